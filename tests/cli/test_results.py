#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""From a scene to pictures and reports: what the commands hand to people and to other programs."""

import csv
import json
import math
import re
import unittest

from program import CASES, REPOSITORY, SCENES, ProgramTest, main

GLASS = SCENES / "cube-glass.yaml"
CALCITE = SCENES / "cube-calcite.yaml"
STATISTICS = """tool tool_version kernel_features precision threads scene scene_hash width height wavelengths_nm mode
    spp_wanted residual_target depth_limit node_budget seed unpolarized trees_per_sample spp spp_mean t_load_s t_render_wall_s
    t_render_cpu_s t_output_s
    camera_samples rays nodes_mean nodes_max residual_mean residual_max tail_mean brightest energy_defect_max failures
    film_bytes_per_pixel error stop_reason""".split()


def strict_json(text):
    """NaN and Infinity are no JSON."""
    def refuse(word):
        raise ValueError(word)
    return json.loads(text, parse_constant=refuse)


class Render(ProgramTest):
    def test_the_picture_does_not_depend_on_the_number_of_threads(self):
        for scene in (GLASS, CALCITE):
            for threads in (1, 2, 7):
                self.succeed("render", scene, "-o", f"{threads}.exr", "--size", "70x40", "--mode", "area", "--spp", "2",
                             "--wavelengths", "450,580", "--node-budget", "200", "--threads", threads, "--quiet")
            files = self.files()
            self.assertEqual(files["1.exr"], files["2.exr"])
            self.assertEqual(files["1.exr"], files["7.exr"])

    def test_statistics_say_what_was_done(self):
        self.succeed("render", GLASS, "-o", "out.exr", "--size", "20x10", "--mode", "area", "--spp", "3", "--seed", "7",
                     "--residual", "1e-4", "--wavelengths", "380:780:20", "--threads", "2", "--stats", "s.json")
        statistics = strict_json((self.folder / "s.json").read_text())
        self.assertEqual(list(statistics), STATISTICS)
        said = {"width": 20, "height": 10, "mode": "area", "spp": 3, "seed": 7, "threads": 2, "residual_target": 1e-4,
                "depth_limit": None, "camera_samples": 20 * 10 * 3, "failures": 0, "stop_reason": "samples"}
        self.assertEqual({key: statistics[key] for key in said}, said)
        self.assertEqual(statistics["wavelengths_nm"], list(range(380, 781, 20)))
        self.assertGreaterEqual(statistics["rays"], statistics["camera_samples"])
        self.assertLessEqual(statistics["residual_max"], 1e-4)
        self.assertLessEqual(statistics["energy_defect_max"], 1e-11)

    def test_a_log_gets_few_lines_and_quiet_none(self):
        lines = self.succeed("render", CALCITE, "-o", "out.exr", "--size", "96x96").splitlines()
        self.assertLessEqual(len(lines), 12)
        for line in lines[:-1]:
            self.assertRegex(line, r"^progress \d+\.\d%(, .* left)?$")
        self.assertRegex(lines[-1], r"^out\.exr: 96x96, 1 wavelength, .*s, .* rays, untraced at most [^ ]* % of a pixel"
                         r"(, estimated by one random path at most [^ ]* %)?$")
        self.assertEqual(self.succeed("render", GLASS, "-o", "out.exr", "--size", "8x8", "--quiet"), "")

    def test_extreme_sizes_make_pictures(self):
        for size in ("1x1", "4096x1", "1x4096"):
            with self.subTest(size):
                self.succeed("render", GLASS, "-o", "out.exr", "--size", size, "--quiet")
                self.succeed("maps", "out.exr", "--map", "dop", "-o", "dop.png", "--plain")
                self.assertEqual(self.png_size("dop.png"), tuple(map(int, size.split("x"))))
                self.succeed("maps", "out.exr", "--map", "dop", "-o", "dop.png")


class Maps(ProgramTest):
    def setUp(self):
        super().setUp()
        self.succeed("render", CALCITE, "-o", "in.exr", "--size", "32x20", "--wavelengths", "450,580,650", "--node-budget",
                     "100", "--quiet")
        listed = self.succeed("maps", "--help").split("Maps:\n")[1].split("\n\n")[0]
        self.names = re.findall(r"^  (\w+) ", listed, re.MULTILINE)

    def test_every_map_of_the_help_becomes_a_picture(self):
        for name in "color intensity dop dolp docp ellipticity azimuth handedness s1 s2 s3 residual".split():
            self.assertIn(name, self.names)
        self.names.remove("all")
        for name in self.names:
            with self.subTest(name):
                self.succeed("maps", "in.exr", "--map", name, "-o", "map.png")
                width, height = self.png_size("map.png")
                self.assertTrue(200 <= width <= 2000 and 150 <= height <= 2000, (width, height))
                self.succeed("maps", "in.exr", "--map", name, "-o", "map.png", "--plain", "--wavelength", "650")
                self.assertEqual(self.png_size("map.png"), (32, 20))
        self.succeed("maps", "in.exr", "--map", "all", "-o", "maps")
        self.assertEqual({name for name in self.files() if name.startswith("maps")},
                         {f"maps/{name}.png" for name in self.names})

    def test_styles_differ_and_names_of_styles_are_those_of_the_help(self):
        pictures = set()
        for style in ("scientific", "paper", "wilkie"):
            self.succeed("maps", "in.exr", "--map", "dop", "-o", "map.png", "--style", style, "--plain")
            pictures.add((self.folder / "map.png").read_bytes())
        self.assertEqual(len(pictures), 3)

    def test_a_map_fades_by_the_width_of_its_bar_on_request_but_not_on_a_gray_scale(self):
        def drawn(*options):
            self.succeed("maps", "in.exr", "--map", "dop", "-o", "map.png", "--plain", *options)
            return (self.folder / "map.png").read_bytes()

        self.assertNotEqual(drawn("--fade-by-bar"), drawn())  # a hundred branches leave light untraced
        self.assertEqual(drawn("--style", "paper", "--fade-by-bar"), drawn("--style", "paper"))


class Explain(ProgramTest):
    def test_the_leaves_of_a_pixel_sum_to_it_to_the_last_bit(self):
        for scene, pixels in ((GLASS, ("0,0", "16,16", "9,20")), (CALCITE, ("16,16", "20,11")),
                              (SCENES / "crossed-polarizers.yaml", ("16,16",)), (SCENES / "metal-spheres.yaml", ("16,16",))):
            for pixel in pixels:
                with self.subTest(f"{scene.stem} {pixel}"):
                    tree = strict_json(self.succeed("explain", scene, "--pixel", pixel, "--size", "32x32", "--json"))
                    self.assertIs(tree["leaves_sum_to_sample"], True)
                    self.assertEqual(tree["leaf_sum"], tree["stokes"])
                    total = [0.0] * 4
                    for leaf in tree["leaves"]:
                        self.assertIn("ended", tree["nodes"][leaf])
                        total = [a + b for a, b in zip(total, tree["nodes"][leaf]["share"])]
                    self.assertEqual(total, tree["stokes"])
                    energy = tree["resolved"] + tree["absorbed"] + tree["residual"] + tree["tail"]
                    self.assertAlmostEqual(energy, 1.0, delta=1e-11)  # CUTTING.md 1.1
                    s0, s1, s2, s3 = tree["stokes"]
                    self.assertLessEqual(math.hypot(s1, s2, s3), s0 * (1 + 1e-12))
                    low, high = tree["bounds"]["s0"]
                    self.assertTrue(low <= s0 <= high)

    def test_the_text_names_every_number_of_the_issue(self):
        text = self.succeed("explain", CALCITE, "--pixel", "16,16", "--size", "32x32")
        for word in ("coherence matrix", "frame", "S3", "polarization", "ellipticity", "azimuth", "handedness", "truth in",
                     "to the last bit", "weight", "deg", "ray", "k (", "ends:"):
            self.assertIn(word, text)


    def test_without_a_wavelength_the_one_nearest_to_580_is_explained_and_mapped(self):
        for wavelengths, nearest in (("380:780:20", 580), ("450,550,650", 550), ("650,700", 650)):
            tree = json.loads(self.succeed("explain", GLASS, "--pixel", "1,1", "--size", "4x4", "--wavelengths", wavelengths,
                                           "--json"))
            self.assertEqual(tree["wavelength_nm"], nearest)
            self.succeed("render", GLASS, "-o", "in.exr", "--size", "4x4", "--wavelengths", wavelengths, "--quiet")
            self.succeed("maps", "in.exr", "--map", "dop", "-o", "a.png")
            self.succeed("maps", "in.exr", "--map", "dop", "-o", "b.png", "--wavelength", nearest)
            self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_ray_states_are_those_of_the_json_tree(self):
        scene = SCENES / "cube-calcite.yaml"
        tree = json.loads(self.succeed("explain", scene, "--pixel", "256,200", "--json", "--csv", "rays.csv", "--obj",
                                       "rays.obj"))
        with open(self.folder / "rays.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(tree["nodes"]))
        for row, node in zip(rows, tree["nodes"]):
            self.assertEqual(int(row["#"]), node["id"])
            self.assertEqual(int(row["parent"]), node["parent"])
            self.assertEqual([float(row[k]) for k in ("k_x", "k_y", "k_z")], node["k"])
            self.assertEqual([float(row[k]) for k in ("share_S0", "share_S1", "share_S2", "share_S3")], node["share"])
            self.assertEqual((row["interaction"], row["ended"]), (node["interaction"], node.get("ended", "")))
            self.assertEqual([float(row[k]) for k in ("light_S0", "light_S1", "light_S2", "light_S3")],
                             node["light"]["stokes"])
            for axis in ("E1", "E2"):
                self.assertEqual([float(row[f"{axis}_{k}"]) for k in "xyz"], node["frame"][axis])
            self.assertEqual(float(row["weight"]), node["weight"])
            self.assertEqual((row["medium"], row["mode"]), (node["medium"], node["mode"]))
            self.assertEqual([row[k] == "" for k in "XYZ"], ["point" not in node] * 3)
            if "point" in node:
                self.assertEqual([float(row[k]) for k in "XYZ"], node["point"])
                # The light's path to this point, one index times one length after the other.
                length, at = 0.0, node
                while True:
                    length += sum((b - a) * k for a, b, k in zip(at["origin"], at["point"], at["k"]))
                    if at["parent"] < 0:
                        break
                    at = tree["nodes"][at["parent"]]
                self.assertAlmostEqual(float(row["OPL"]), length, delta=1e-12 * abs(length))
            first = node["matrix"][0][0]
            self.assertEqual([float(row["M_x1_re"]), float(row["M_x1_im"])], first)

        lines = (self.folder / "rays.obj").read_text().splitlines()
        vertices = [list(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]
        segments, group = {}, None
        for line in lines:
            if line.startswith("g "):
                group = line[2:]
            elif line.startswith("l "):
                a, b = map(int, line.split()[1:])
                segments[b - 2] = (group, vertices[a - 1], vertices[b - 1])
        self.assertEqual(sorted(segments), [node["id"] for node in tree["nodes"]])
        for node in tree["nodes"]:
            group, start, end = segments[node["id"]]
            for a, b in zip(start, node["origin"]):
                self.assertAlmostEqual(a, b, delta=1e-12)
            if "point" in node:
                self.assertEqual(end, node["point"])
            if group in ("o", "e"):
                self.assertEqual(node["mode"], group)

    def test_a_film_that_should_show_interference_is_doubted_wherever_numbers_are_given(self):
        # Quartz of 100 nm between crossed polarizers: o and e differ by 0.91 nm, light of 580 nm stays coherent over um.
        film = self.write("film.yaml", "camera: {type: orthographic, position: [0, 0, 10], target: [0, 0, 0], "
                          "up: [0, 1, 0], width: 1}\nbackground: 1\n"
                          "media: {quartz: {ordinary: 1.5442, extraordinary: 1.5533, axis: [1, 1, 0]}}\nobjects:\n"
                          "  - {name: plate, shape: {box: {size: [20, 20, 0.0001]}}, medium: quartz}\n")
        doubt = "'plate' is 100 nm thick"
        text = self.succeed("explain", film, "--size", "1x1", "--pixel", "0,0")
        self.assertEqual(text.count("doubt: "), 1)
        self.assertIn(doubt, text)
        self.assertIn("powers are added", text)
        self.assertNotIn("truth", text)
        tree = strict_json(self.succeed("explain", film, "--size", "1x1", "--pixel", "0,0", "--json"))
        self.assertIn(doubt, tree["doubts"][0])
        self.assertNotIn("bounds", tree)
        self.assertIn("s0", tree["bounds_but_for_doubts"])
        self.assertIn(doubt, self.succeed("plan", film))
        self.assertIn(doubt, strict_json(self.succeed("plan", film, "--json"))["doubts"][0])
        self.assertIn(doubt, self.succeed("check", film, "--size", "2"))
        self.assertIn(doubt, strict_json(self.succeed("check", film, "--size", "2", "--json"))["doubts"][0])
        done = self.run_program("render", film, "-o", "film.exr", "--size", "2x2", "--quiet")
        self.assertEqual(done.returncode, 0)
        self.assertIn(doubt, done.stderr)
        self.assertEqual(done.stderr.count("polariscope: doubt: "), 1)

    def test_a_pixel_case_holds_or_says_by_how_much_it_does_not(self):
        case = CASES / "brewster.yaml"
        self.assertIn("the case holds", self.succeed("explain", "--case", case))
        text = case.read_text()
        elsewhere = self.write("elsewhere.yaml", b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
        self.assertIn("the case holds", self.succeed("explain", "--case", elsewhere))
        wrong = self.write("wrong.yaml", text.replace("0.0739", "0.0738"))
        done = self.run_program("explain", "--case", wrong)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("DOES NOT HOLD: differs by 0.0001", done.stdout)
        self.refuse(2, ["--pixel", "the case says that itself"], "explain", "--case", case, "--pixel", "1,1")
        self.refuse(2, ["--residual"], "explain", "--case", case, "--residual", "0.1")
        self.refuse(3, ["no line '---'"], "explain", "--case", SCENES / "cube-glass.yaml")
        misspelt = self.write("misspelt.yaml", text.replace("medium: glass", "medium: glas"))
        line = 1 + text.splitlines().index("    medium: glass")
        self.refuse(3, [f"misspelt.yaml:{line}:", "did you mean 'glass'?"], "explain", "--case", misspelt)
        outside = self.write("outside.yaml", text.replace("pixel: [1, 1]", "pixel: [3, 1]"))
        self.refuse(3, ["outside.yaml:3:8", "no such pixel"], "explain", "--case", outside)
        infinite = self.write("infinite.yaml", text.replace("yy: 0", "yy: .inf"))
        self.refuse(3, ["infinite.yaml:6"], "explain", "--case", infinite)

    def test_every_case_that_ships_holds(self):
        cases = sorted(CASES.glob("*.yaml"))
        self.assertTrue(cases)
        for case in cases:
            self.succeed("explain", "--case", case)


class Interface(ProgramTest):
    ORACLE = REPOSITORY / "tests" / "optics" / "data" / "oracle_vectors.jsonl"

    @staticmethod
    def powers(case):
        """Summed over the incident modes, whose basis is a choice where they are a pair: {(side, wave): power}."""
        sums = {}
        for incident in case["incident"]:
            for wave in incident.get("out", []):
                key = wave["side"], {"s": "pair", "p": "pair"}.get(wave["label"], wave["label"])
                sums[key] = sums.get(key, 0.0) + wave.get("power", 0.0)
        return sums

    def test_cases_are_answered_line_by_line_with_the_powers_of_the_oracle(self):
        lines = self.ORACLE.read_text().splitlines()[::20]
        self.write("cases.jsonl", "\ufeff" + "\r\n".join(lines) + "\n\n")
        answers = self.succeed("interface", "--cases", "cases.jsonl").splitlines()
        self.assertEqual(len(answers), len(lines))
        for line, answer in zip(lines, answers):
            expected, found = json.loads(line), strict_json(answer)
            self.assertEqual(found["case"], expected["case"])
            # The oracle's own change when its inputs move by an ulp, times the few roundings of a solve.
            tolerance = 1e-13 + 64 * expected["ulp_sensitivity_mode"]
            ours, theirs = self.powers(found), self.powers(expected)
            for key in ours.keys() | theirs.keys():
                self.assertAlmostEqual(ours.get(key, 0.0), theirs.get(key, 0.0), delta=tolerance,
                                       msg=f"case {expected['case']} {key}")

    def test_lines_that_cannot_be_used_are_named_and_the_others_answered(self):
        good = '{"normal": [0,0,1], "wave_normal": [0,0,1], "medium1": {"type": "isotropic", "n": 1}, ' \
               '"medium2": {"type": "isotropic", "n": 1.5}}'
        self.write("cases.jsonl", f"{good}\nhello\n\n{good.replace('1.5', '-1')}\n{good.replace('[0,0,1], ', '', 1)}\n{good}")
        done = self.run_program("interface", "--cases", "cases.jsonl")
        self.assertEqual(done.returncode, 3)
        self.assertEqual(len(done.stdout.splitlines()), 2)
        for said in ("cases.jsonl:2: ", "cases.jsonl:4: medium2.n: ", "cases.jsonl:5: ", "3 of 6 lines"):
            self.assertIn(said, done.stderr)
        again = self.run_program("interface", "--cases", "-", input=good + "\n")
        self.assertEqual(again.stdout, done.stdout.splitlines()[0] + "\n")

    def test_the_table_has_the_textbook_numbers(self):
        # Fresnel: at normal incidence on n = 1.5 a share of (0.5 / 2.5)^2 = 0.04 comes back; nothing of p at Brewster's
        # angle atan(1.5).
        table = self.succeed("interface", "--from", "air", "--to", "1.5")
        self.assertEqual(len(re.findall(r"reflected +[sp] .* 0\.0400000000 ", table)), 2)
        table = self.succeed("interface", "--from", "air", "--to", "1.5", "--angle", math.degrees(math.atan(1.5)))
        self.assertRegex(table, r"reflected +p .* 0\.0000000000 ")

    def test_absorbing_media_reflect_with_n_and_k_however_they_are_given(self):
        # ((n - 1)^2 + k^2)/((n + 1)^2 + k^2): 0.0769231 for 1.5 + 0.5i, 0.0400038 for 1.5 + 0.005i, 0.04 for real 1.5.
        for n, k in ((1.5, 0.5), (1.5, 0.005), (0.298776, 2.837424)):
            reflectance = ((n - 1)**2 + k**2) / ((n + 1)**2 + k**2)
            table = self.succeed("interface", "--from", "air", "--to", f"{n}+{k}i")
            shares = re.findall(r"reflected +[sp] +\S+ +\S+ +\S+ +(\S+)", table)
            for share in (shares[0], shares[3]):  # s to s, p to p
                self.assertAlmostEqual(float(share), reflectance, delta=1e-10)  # ten printed decimals
            self.assertEqual(len(re.findall(r"sum +1\.0000000000", table)), 2)
            for kind in ("isotropic", "conductor"):
                case = {"normal": [0, 0, 1], "wave_normal": [0, 0, 1], "medium1": {"type": "isotropic", "n": 1},
                        "medium2": {"type": kind, "n": n, "k": k}}
                self.write("case.jsonl", json.dumps(case))
                found = self.powers(strict_json(self.succeed("interface", "--cases", "case.jsonl")))
                self.assertAlmostEqual(found["R", "pair"], 2 * reflectance, delta=1e-14)
        # From inside, what the interference of incident and reflected wave adds is booked as absorbed.
        self.assertEqual(len(re.findall(r"sum +1\.0000000000",
                                        self.succeed("interface", "--from", "1.5+0.005i", "--to", "air"))), 2)


    RECORD = "DATA:\n  - type: tabulated n\n    data: |\n        0.4 {0}\n        0.7 {0}\n"

    def test_a_name_that_begins_like_a_number_is_a_record(self):
        for name in ("infrasil.yml", "4H-SiC.yml", "nanogold.yml", "1e3.yml", "0x10.yml"):
            self.write(name, self.RECORD.format(1.458))
            self.assertIn("to    isotropic, n = 1.458\n", self.succeed("interface", "--from", "air", "--to", name), name)
        for number, said in (("1.5", "n = 1.5\n"), ("1.5e0", "n = 1.5\n"), ("0.3+2.84i", "n = 0.3 + 2.84 i")):
            self.assertIn(said, self.succeed("interface", "--from", "air", "--to", number))
        self.assertIn("n_o = 1.66, n_e = 1.49", self.succeed("interface", "--from", "air", "--to", "1.66, 1.49",
                                                             "--axis", "1,0,1"))

    def test_a_path_of_a_crystal_is_the_pair_of_its_files(self):
        self.write("spar-o.yml", self.RECORD.format(1.6584))
        self.write("spar-e.yml", self.RECORD.format(1.4864))
        table = self.succeed("interface", "--from", "air", "--to", "./spar", "--axis", "1,0,1")
        self.assertIn("uniaxial, n_o = 1.6584, n_e = 1.4864", table)

    def test_an_extinction_that_is_not_known_is_zero_and_said(self):
        self.write("film.yml", self.RECORD.format(1.5) + "  - type: tabulated k\n    data: 9 0.1\n")
        done = self.run_program("interface", "--from", "air", "--to", "film.yml")
        self.assertEqual(done.returncode, 0)
        self.assertIn("isotropic, n = 1.5\n", done.stdout)
        self.assertIn("k of 'film.yml' is not known at 580 nm: 0 is used", done.stderr)


class Plan(ProgramTest):
    def test_json_lists_every_feature_with_its_reason(self):
        plan = strict_json(self.succeed("plan", CALCITE, "--json", "--wavelengths", "380:780:20"))
        self.assertEqual(len(plan["wavelengths_nm"]), 21)
        self.assertEqual(plan["trees"], 21)  # calcite disperses
        for feature in plan["features"]:
            self.assertTrue(feature["name"] and feature["reason"])
            self.assertIsInstance(feature["needed"], bool)
        text = self.succeed("plan", CALCITE, "--wavelengths", "380:780:20")
        for feature in plan["features"]:
            self.assertIn(feature["reason"], text)

    def test_what_does_not_disperse_is_traced_once(self):
        plan = strict_json(self.succeed("plan", GLASS, "--json", "--wavelengths", "380:780:20"))
        self.assertEqual(plan["trees"], 1)  # n = 1.5 throughout


if __name__ == "__main__":
    main()
