#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whatever is wrong with a scene or a file it names: exit code 3, an address, a hint, and nothing written."""

import os
import unittest
from pathlib import Path

from program import CAMERA, SCENES, ProgramTest, bound_by_permissions, main

EMPTY = CAMERA + "objects: []\n"


def thing(rest):
    """A scene whose object stands in line 3."""
    return CAMERA + "objects:\n  - {name: a, " + rest + "}\n"


BALL = "shape: {sphere: {radius: 1}}, "

# (story, scene, the error points at the first occurrence of this, field, said)
BAD_SCENES = [
    ("not YAML", "camera: {position: [0, 0\nobjects: ]]\n", ": ]]", "", "not valid YAML"),
    ("a sentence", "hello world\n", "hello", "", "expected a map"),
    ("wrong type", EMPTY + "render: {residual: small}\n", "small", "render.residual", "expected a number"),
    ("map for list", CAMERA + "objects: {}\n", "{}", "objects", "expected a list"),
    ("unknown key", CAMERA + "objets: []\n", "objets", "objets", "'objects'"),
    ("unknown key of an object", thing(BALL + "mdium: g"), "mdium", "objects[0].mdium", "'medium'"),
    ("missing key", thing(BALL[:-2]), "{name", "objects[0]", "exactly one of"),
    ("missing camera", "objects: []\n", "objects", "camera", "missing"),
    ("NaN", thing("shape: {sphere: {radius: .nan}}, absorber: on"), ".nan", "objects[0].shape.sphere.radius", "finite"),
    ("infinite", thing("shape: {sphere: {radius: .inf}}, absorber: on"), ".inf", "objects[0].shape.sphere.radius",
     "finite"),
    ("negative radius", thing("shape: {sphere: {radius: -1}}, absorber: on"), "-1", "objects[0].shape.sphere.radius",
     "greater than 0"),
    ("size 0", thing("shape: {box: {size: 0 }}, absorber: on"), "0 }", "objects[0].shape.box.size", "greater than 0"),
    ("absurd index", EMPTY + "media: {g: 1000}\n", "1000", "media.g.index", "between 0 and 100"),
    ("negative index", EMPTY + "media: {g: -1.5}\n", "-1.5", "media.g.index", "between 0 and 100"),
    ("1e9 x 1e9 pixels", EMPTY + "render: {size: [1000000000, 1000000000]}\n", "[1000", "render.size", "65536"),
    ("optic axis of length 0", EMPTY + "media: {c: {crystal: calcite, axis: [0, 0, 0]}}\n", "[0, 0, 0]}", "media.c.axis",
     "length is zero"),
    ("unknown medium", thing(BALL + "medium: glas") + "media: {glass: 1.5}\n", "glas}", "objects[0].medium", "'glass'"),
    ("unknown texture", thing("shape: {rectangle: {size: 1}}, emission: {radiance: {texture: no.png}}"), "no.png",
     "objects[0].emission.radiance.texture", "no file 'no.png'"),
    ("unknown mesh", thing("shape: {mesh: {file: no.obj}}, absorber: on"), "no.obj", "objects[0].shape.mesh.file",
     "no file 'no.obj'"),
    ("unknown record", EMPTY + "media: {g: n-bk8}\n", "n-bk8", "media.g", "n-bk7"),
    ("record outside its range", thing(BALL + "medium: g") + "media: {g: n-bk7}\nrender: {wavelengths: 200}\n", "n-bk7",
     "media.g.index", "200 nm"),
    ("includes itself", EMPTY + "include: [scene.yaml]\n", "scene.yaml", "include[0]", "scene.yaml -> scene.yaml"),
]

CUBE_CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
CUBE_FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]


def obj(corners, faces):
    lines = ["v {} {} {}".format(*corner) for corner in corners]
    return "\n".join(lines + ["f " + " ".join(map(str, face)) for face in faces]) + "\n"


# (story, mesh file, said). The cube's last face is left out, turned, shrunk or doubled.
BAD_MESHES = [
    ("a hole", obj(CUBE_CORNERS, CUBE_FACES[:-1]), "hole"),
    ("inside out", obj(CUBE_CORNERS, [face[::-1] for face in CUBE_FACES]), "inside out"),
    ("one face turned", obj(CUBE_CORNERS, CUBE_FACES[:-1] + [CUBE_FACES[-1][::-1]]), "triangles"),
    ("a degenerate face", obj(CUBE_CORNERS, CUBE_FACES + [(1, 1, 2)]), "triangle 12"),
    ("a non-manifold edge", obj(CUBE_CORNERS + [(2, 2, 2)], CUBE_FACES + [(1, 2, 9)]), "edge"),
    ("no such corner", obj(CUBE_CORNERS, CUBE_FACES[:-1] + [(2, 4, 8, 99)]), "face 5"),
    ("empty", "", "empty"),
    ("no mesh at all", "hello\n", ""),
]


class BadScenes(ProgramTest):
    def test_a_bad_scene_is_refused_by_every_command_that_reads_it(self):
        for story, text, at, field, said in BAD_SCENES:
            with self.subTest(story):
                self.write("scene.yaml", text)
                offset = text.index(at)
                line = text.count("\n", 0, offset) + 1
                column = offset - (text.rfind("\n", 0, offset) + 1) + 1
                address = f"scene.yaml:{line}:{column}: " + (f"{field}: " if field else "")
                message = self.refuse(3, [address, said], "render", "scene.yaml", "-o", "out.exr", "--stats", "s.json")
                for command in (("plan", "scene.yaml"), ("explain", "scene.yaml", "--pixel", "0,0"),
                                ("check", "scene.yaml"), ("converge", "scene.yaml", "-o", "curves")):
                    self.assertEqual(self.refuse(3, [], *command), message)
                self.assertEqual(os.listdir(self.folder), ["scene.yaml"], "not even a folder is made")

    def test_a_scene_that_is_no_file_is_refused_by_name(self):
        self.write("empty.yaml", "")
        (self.folder / "folder.yaml").mkdir()
        os.mkfifo(self.folder / "pipe.yaml")
        for name, said in [("missing.yaml", "no such file"), ("empty.yaml", "empty"), ("folder.yaml", "folder"),
                           ("pipe.yaml", "regular file"), ("", "no such file")]:
            with self.subTest(name):
                before = set(os.listdir(self.folder))
                done = self.run_program("render", name, "-o", "out.exr")
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn(f"polariscope: {name}", done.stderr)
                self.assertIn(said, done.stderr)
                self.assertIn("  hint: ", done.stderr)
                self.assertEqual(set(os.listdir(self.folder)), before)

    def test_a_scene_that_may_not_be_read_is_refused(self):
        scene = self.write("scene.yaml", EMPTY)
        scene.chmod(0)
        done = self.run_program("render", "scene.yaml", "-o", "out.exr", **bound_by_permissions())
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("scene.yaml: ", done.stderr)
        self.assertIn("check its permissions", done.stderr)

    def test_binary_and_endless_nesting_are_no_scenes(self):
        for content in (b"\x7fELF\x02\x01\x01\0\0\0", b"[" * 100_000, b"{a: " * 50_000, os.urandom(1000), b"\xff\xfe\0", b",b"):
            with self.subTest(content[:8]):
                self.write("scene.yaml", content)
                self.refuse(3, ["scene.yaml:"], "render", "scene.yaml", "-o", "out.exr")

    def test_overlapping_solids_are_refused_and_both_are_named(self):
        self.write("scene.yaml", CAMERA + "media: {g: 1.5, w: 1.33}\nobjects:\n"
                   "  - {name: cube, shape: {box: {size: 1}}, medium: g}\n"
                   "  - {name: drop, shape: {sphere: {radius: 0.6}}, transform: [{translate: [0.5, 0, 0]}], medium: w}\n")
        self.refuse(3, ["scene.yaml:", "cube", "drop", "priority"], "render", "scene.yaml", "-o", "out.exr")

    def test_includes_that_lead_back_are_refused_with_their_chain(self):
        self.write("scene.yaml", EMPTY + "include: [b.yaml]\n")
        self.write("b.yaml", "include: [scene.yaml]\n")
        self.refuse(3, ["b.yaml:1:11: include[0]: ", "scene.yaml -> b.yaml -> scene.yaml"], "render", "scene.yaml", "-o",
                    "out.exr")


class BadAssets(ProgramTest):
    def test_a_malformed_index_record_is_refused_in_its_own_file(self):
        self.write("scene.yaml", thing(BALL + "medium: g") + "media: {g: bad.yml}\n")
        good = "DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2.5\n    coefficients: 0 1.04 0.006\n"
        self.write("bad.yml", good)
        self.succeed("plan", "scene.yaml")
        for story, text in [("empty", ""), ("no data", "REFERENCES: none\n"), ("not YAML", "DATA: [\n"),
                            ("formula 99", good.replace("formula 1", "formula 99")),
                            ("no coefficients", good.split("    coeff")[0]),
                            ("words for numbers", good.replace("1.04", "one")),
                            ("NaN", good.replace("1.04", "nan")),
                            ("range turned", good.replace("0.3 2.5", "2.5 0.3")),
                            ("short table", "DATA:\n  - type: tabulated nk\n    data: |\n      0.4 1.5\n"),
                            ("binary", b"\x7fELF\x02\x01\x01\0\0\0")]:
            with self.subTest(story):
                self.write("bad.yml", text)
                self.refuse(3, ["bad.yml"], "render", "scene.yaml", "-o", "out.exr")

    def test_a_broken_mesh_is_refused_and_says_which_face(self):
        self.write("scene.yaml", thing("shape: {mesh: {file: bad.obj}}, medium: g") + "media: {g: 1.5}\n")
        self.write("bad.obj", obj(CUBE_CORNERS, CUBE_FACES))
        self.succeed("plan", "scene.yaml")
        for story, text, said in BAD_MESHES:
            with self.subTest(story):
                self.write("bad.obj", text)
                self.refuse(3, ["bad.obj", said], "render", "scene.yaml", "-o", "out.exr")

    def test_a_texture_that_is_no_picture_is_refused_where_it_is_named(self):
        self.write("scene.yaml", thing("shape: {rectangle: {size: 1}}, emission: {radiance: {texture: bad.png}}"))
        whole = (SCENES.parent / "textures" / "test-card.png").read_bytes()
        for story, content in [("text", b"hello"), ("empty", b""), ("cut short", whole[:len(whole) // 2])]:
            with self.subTest(story):
                self.write("bad.png", content)
                self.refuse(3, ["scene.yaml:3:", "objects[0].emission.radiance.texture", "bad.png"], "render",
                            "scene.yaml", "-o", "out.exr")

    def test_a_picture_that_is_not_ours_is_refused_by_maps(self):
        scene = SCENES / "cube-glass.yaml"
        self.succeed("render", scene, "-o", "good.exr", "--size", "8x8", "--quiet")
        whole = (self.folder / "good.exr").read_bytes()
        for story, content in [("text", b"hello"), ("empty", b""), ("cut short", whole[:len(whole) // 2]),
                               ("no pixels", whole[:400])]:
            with self.subTest(story):
                self.write("bad.exr", content)
                self.refuse(3, ["bad.exr: "], "maps", "bad.exr", "--map", "dop", "-o", "dop.png")
        self.refuse(3, ["no.exr: "], "maps", "no.exr", "--map", "dop", "-o", "dop.png")
        self.refuse(3, [": "], "maps", self.folder, "--map", "dop", "-o", "dop.png")


if __name__ == "__main__":
    main()
