// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/scene_patch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/units.h"
#include "io/scenes/scene_file.h"
#include "io/scenes/scene_hash.h"

namespace pol {
namespace {

namespace fs = std::filesystem;
using Edit = std::function<void(Scene&)>;

const fs::path here = fs::path(POL_ASSETS) / "scenes" / "test.yaml";

/// As people write: their own units, order, spacing, and comments wherever they may stand.
const std::string by_hand = R"(# My bench, do not touch.
render: {size: [8, 6], spp: 1, residual: 1e-3}  # quick

camera:
  position: [0.50, -3, 2.0]  # from above
  target: [0, 0, 0]
  fov: 28.0
unit: um        # not mm!
media:
  glass: 1.5    # like N-BK7
  smoke: {absorption: 0.20, index: 1.50}
  "second glass": n-bk7
  spar: {crystal: calcite, axis: [1, 0, 1]}   # tilted
  pair:
    ordinary: 1.60
    # found by hand
    extraordinary: 1.50
objects:
  # the only light
  - name: lamp
    emission:
      radiance: 1.0  # flat
      polarization: {dop: 1, azimuth: 30}
    shape: {rectangle: {size: 3}}
    transform: [{translate: [0, 0, -2.50]}]
  - {name: ball, shape: {sphere: {radius: 0.30}}, medium: smoke}   # keeps its place
  - name: lamp two
    shape: {disk: {radius: 0.1}}
    emission: {radiance: {d65: 1}}
)";

Scene parsed_at(const std::string& text, const fs::path& file = here) {
    Result<Scene> scene = parse_scene(text, file.string(), file.parent_path());
    if (!scene) {
        ADD_FAILURE() << to_string(scene.error()) << "\n" << text;
        return {};
    }
    return std::move(scene).value();
}

std::optional<std::string> patched(const std::string& source, const Edit& edit) {
    const Scene before = parsed_at(source);
    Scene edited = before;
    edit(edited);
    auto text = patch_scene(source, before, edited, here, here);
    if (text) {
        EXPECT_EQ(scene_hash(parsed_at(*text)), scene_hash(edited)) << *text;
    }
    return text;
}

/// `source` with `after` instead of `before`, which is there once.
std::string with(std::string source, const std::string& before, const std::string& after) {
    EXPECT_NE(source.find(before), std::string::npos) << before;
    EXPECT_EQ(source.find(before), source.rfind(before)) << before;
    return source.replace(source.find(before), before.size(), after);
}

/// The edit changes `before` into `after` and not one other character.
void expect_change(const std::string& source, const Edit& edit, const std::string& before, const std::string& after) {
    const auto text = patched(source, edit);
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, with(source, before, after));
}

template <class Matter>
Matter& matter(Scene& scene, std::size_t index) {
    return std::get<Matter>(scene.media.at(index).matter);
}

Emission& lamp(Scene& scene, std::size_t index) {
    return std::get<Emission>(scene.objects.at(index).role);
}

TEST(ScenePatch, ChangesNothingWhereNothingWasEdited) {
    const auto text = patched(by_hand, [](Scene&) {});
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, by_hand);
}

TEST(ScenePatch, ChangesOnlyTheNumberThatWasEdited) {
    expect_change(
        by_hand, [](Scene& s) { s.camera.position.y = -3.5; }, "-3, 2.0", "-3.5, 2.0");
    expect_change(
        by_hand, [](Scene& s) { s.camera.horizontal_fov = radians(30.1); }, "28.0", "30.1");
    expect_change(
        by_hand, [](Scene& s) { s.camera.horizontal_fov = radians(40.0); }, "28.0", "40");
    expect_change(
        by_hand, [](Scene& s) { s.render.residual = 0.002; }, "1e-3", "0.002");
    expect_change(
        by_hand, [](Scene& s) { s.render.width = 16; }, "[8, 6]", "[16, 6]");
    const auto index = [](double n) { return RefractiveIndex{ConstantIndex{{n, 0.0}}}; };
    expect_change(
        by_hand, [&](Scene& s) { matter<IsotropicMedium>(s, 0).index = index(1.7); }, "1.5    #", "1.7    #");
    expect_change(
        by_hand, [&](Scene& s) { matter<IsotropicMedium>(s, 1).index = index(1.7); }, "1.50}", "1.7}");
    expect_change(
        by_hand, [&](Scene& s) { matter<IsotropicMedium>(s, 2).index = index(1.7); }, "n-bk7\n", "1.7\n");
    expect_change(
        by_hand, [](Scene& s) { matter<UniaxialMedium>(s, 3).axis.y = 0.5; }, "[1, 0, 1]", "[1, 0.5, 1]");
    expect_change(
        by_hand, [&](Scene& s) { matter<UniaxialMedium>(s, 4).ordinary = index(1.61); }, "1.60", "1.61");
    expect_change(
        by_hand, [](Scene& s) { lamp(s, 0).radiance = Spectrum{ConstantSpectrum{2.0}}; }, "1.0  #", "2  #");
    expect_change(
        by_hand, [](Scene& s) { lamp(s, 2).radiance = Spectrum{D65Spectrum{0.5}}; }, "{d65: 1}", "{d65: 0.5}");
}

TEST(ScenePatch, AddsAKeyThatWasLeftOutBesideTheOthers) {
    expect_change(
        by_hand,
        [](Scene& s) {
            s.camera.up = {0.0, 1.0, 0.0};
        },
        "fov: 28.0", "fov: 28.0\n  up: [0, 1, 0]");
    expect_change(
        by_hand,
        [](Scene& s) {
            s.render.wavelengths_nm = {500.0, 600.0};
        },
        "1e-3}", "1e-3, wavelengths: [500, 600]}");
    expect_change(
        by_hand,
        [](Scene& s) {
            lamp(s, 2).state = FixedState{0.0, 0.0, 1.0};
        },
        "{d65: 1}}", "{d65: 1}, polarization: {stokes: [0, 0, 1], x_axis: [1, 0, 0]}}");
    const std::string without_render = by_hand.substr(by_hand.find("\ncamera"));
    expect_change(
        without_render, [](Scene& s) { s.render.width = 16; }, "unit: um        # not mm!",
        "unit: um        # not mm!\nrender: {size: [16, 512]}");
}

// As the window turns it: (cos 2 psi, sin 2 psi).
TEST(ScenePatch, TurnedLinearLightKeepsItsAzimuth) {
    for (const char* azimuth : {"45", "22.5", "135", "-10", "61.7"}) {
        const double twice = 2.0 * radians(std::stod(azimuth));
        const FixedState turned{std::cos(twice), std::sin(twice), 0.0};
        expect_change(
            by_hand, [&](Scene& s) { lamp(s, 0).state = turned; }, "azimuth: 30", std::string("azimuth: ") + azimuth);
    }
}

TEST(ScenePatch, WritesAValueAnewWhereItsKeysHaveNoPlace) {
    expect_change(
        by_hand,
        [](Scene& s) {
            lamp(s, 0).state = FixedState{0.0, 0.0, 1.0};
        },
        "{dop: 1, azimuth: 30}", "{stokes: [0, 0, 1], x_axis: [1, 0, 0]}");
    const auto text = patched(by_hand, [](Scene& s) {
        matter<UniaxialMedium>(s, 3).ordinary = ConstantIndex{{1.6, 0.0}};
    });
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("spar: {ordinary: 1.6, extraordinary: \"calcite-e\", axis: [1, 0, 1]"), std::string::npos)
        << *text;
    EXPECT_NE(text->find("}   # tilted\n"), std::string::npos) << *text;
}

// The paper's depth limit sets the residual and the budget; without it they have their own values again.
TEST(ScenePatch, AKeyGoesWithItsLine) {
    const std::string source = with(by_hand, "render: {size: [8, 6], spp: 1, residual: 1e-3}  # quick\n",
                                    "render:\n  size: [8, 6]  # quick\n  depth: 9\n");
    const auto unlimited = [](Scene& s) {
        s.render.depth.reset();
        s.render.residual = RenderSettings{}.residual;
        s.render.node_budget = RenderSettings{}.node_budget;
    };
    expect_change(source, unlimited, "# quick\n  depth: 9\n", "# quick\n");
    const std::string unpolarized = with(by_hand, "spp: 1,", "unpolarized: on, spp: 1,");
    expect_change(
        unpolarized, [](Scene& s) { s.render.unpolarized = false; }, "unpolarized: on, ", "");
    // Not without what is said of it.
    EXPECT_FALSE(patched(with(source, "depth: 9", "depth: 9  # as in the paper"), unlimited));
}

TEST(ScenePatch, KeepsRadiansAndJsonAndTheEndsOfLines) {
    expect_change(
        with(by_hand, "28.0", "0.5 rad"), [](Scene& s) { s.camera.horizontal_fov = 0.25; }, "0.5 rad", "0.25 rad");
    const std::string json =
        R"({"camera": {"position": [0, 1, 5], "target": [0, 0, 0], "fov": 30}, "objects": [], "media": {"a": 1.5}})";
    expect_change(
        json,
        [](Scene& s) {
            s.camera.up = {0.0, 1.0, 0.0};
        },
        "30}", "30, \"up\": [0, 1, 0]}");
    std::string dos;
    for (const char c : by_hand) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
    expect_change(
        dos,
        [](Scene& s) {
            s.camera.up = {0.0, 1.0, 0.0};
        },
        "fov: 28.0", "fov: 28.0\r\n  up: [0, 1, 0]");
    const std::string marked = "\xef\xbb\xbf" + with(by_hand, "My bench", "Mein Prüfstand");
    expect_change(
        marked, [](Scene& s) { s.camera.position.y = -3.5; }, "-3, 2.0", "-3.5, 2.0");
}

TEST(ScenePatch, IsNotMadeWhereItWouldCostACommentOrChangeAnotherThing) {
    const auto to_twelve = [](Scene& s) { s.render.wavelengths_nm.assign({500.0, 600.0, 700.0}); };
    EXPECT_FALSE(patched(with(by_hand, "spp: 1,", "spp: 1,\n  wavelengths: [500,  # blue\n    600],"), to_twelve));
    // Both media stand at one place.
    const std::string alias =
        with(with(by_hand, "glass: 1.5 ", "glass: &g {index: 1.5}"), "glass\": n-bk7", "glass\": *g");
    EXPECT_FALSE(patched(alias, [](Scene& s) { matter<IsotropicMedium>(s, 2).index = ConstantIndex{{1.7, 0.0}}; }));
}

TEST(ScenePatch, AnEditOfAnIncludedFileIsNotForThisFile) {
    const std::string source = with(by_hand, "unit: um", "include: [included/optics.yaml]\nunit: um");
    const fs::path folder = fs::temp_directory_path() / ("polariscope-patch-" + std::to_string(::getpid()));
    fs::create_directories(folder / "included");
    std::ofstream(folder / "included/optics.yaml")
        << "media: {extra: 1.4}\nobjects: [{name: drop, shape: {sphere: {radius: 0.1}}, medium: extra, priority: 1}]\n";
    const fs::path file = folder / "scene.yaml";
    const Scene before = parsed_at(source, file);
    Scene edited = before;
    edited.camera.position.y = -3.5;
    const auto own = patch_scene(source, before, edited, file, file);
    ASSERT_TRUE(own);
    EXPECT_EQ(*own, with(source, "-3, 2.0", "-3.5, 2.0"));
    // From another folder the included file has another name.
    fs::create_directory(folder / "elsewhere");
    const auto moved = patch_scene(source, before, edited, file, folder / "elsewhere" / "scene.yaml");
    ASSERT_TRUE(moved);
    EXPECT_EQ(*moved, with(*own, "included/optics.yaml", "\"../included/optics.yaml\""));
    edited.objects.back().priority = 2;
    EXPECT_FALSE(patch_scene(source, before, edited, file, file));
    edited.objects.back().priority = 1;
    edited.media.back().matter = IsotropicMedium{ConstantIndex{{1.41, 0.0}}, ConstantSpectrum{0.0}};
    EXPECT_FALSE(patch_scene(source, before, edited, file, file));
    fs::remove_all(folder);
}

TEST(ScenePatch, FilesThatShipWithTheProgramKeepTheirNamesElsewhere) {
    const std::string source = with(by_hand, "radiance: {d65: 1}}", "radiance: {texture: test-card.png}}  # a card");
    const Scene scene = parsed_at(source);
    const auto text = patch_scene(source, scene, scene, here, fs::temp_directory_path() / "elsewhere.yaml");
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, source);
    // Also when the file is written anew.
    EXPECT_NE(save_scene(scene, fs::temp_directory_path()).find("texture: \"test-card.png\""), std::string::npos);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(ScenePatch, OfEveryShippedSceneChangesALineAndKeepsAllComments) {
    const std::vector<std::pair<const char*, Edit>> edits{
        {"position", [](Scene& s) { s.camera.position.x += 0.01; }},
        {"up", [](Scene& s) { s.camera.up = s.camera.up + DVec3(0.01, 0.02, 0.0); }},
        {"fov or width",
         [](Scene& s) {
             s.camera.horizontal_fov *= 1.01;
             s.camera.width *= 1.01;
         }},
        {"size", [](Scene& s) { s.render.width += 1; }},
        {"wavelengths",
         [](Scene& s) {
             s.render.wavelengths_nm = {510.0, 520.0};
         }},
        {"mode",
         [](Scene& s) { s.render.mode = s.render.mode == SampleMode::area ? SampleMode::point : SampleMode::area; }},
        {"samples", [](Scene& s) { s.render.samples_per_pixel += 1; }},
        {"residual", [](Scene& s) { s.render.residual = 0.0123; }},
        {"seed", [](Scene& s) { s.render.seed += 1; }},
        {"polarization",
         [](Scene& s) {
             for (Object& object : s.objects)
                 if (auto* emission = std::get_if<Emission>(&object.role))
                     return static_cast<void>(emission->state = FixedState{0.0, 1.0, 0.0});
         }},
        {"medium",
         [](Scene& s) {
             if (s.media.empty()) return;
             if (auto* crystal = std::get_if<UniaxialMedium>(&s.media[0].matter))
                 crystal->ordinary = ConstantIndex{{1.789, 0.0}};
             else
                 s.media[0].matter = IsotropicMedium{ConstantIndex{{1.234, 0.0}}, ConstantSpectrum{0.5}};
         }},
    };
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(POL_ASSETS) / "scenes")) {
        if (entry.path().extension() != ".yaml") continue;
        ++files;
        const std::string source = read_scene_text(entry.path()).value();
        const Scene before = parsed_at(source, entry.path());
        for (const auto& [name, edit] : edits) {
            SCOPED_TRACE(entry.path().filename().string() + ", " + name);
            Scene edited = before;
            edit(edited);
            const auto text = patch_scene(source, before, edited, entry.path(), entry.path());
            ASSERT_TRUE(text);
            EXPECT_EQ(scene_hash(parsed_at(*text, entry.path())), scene_hash(edited));
            const std::vector<std::string> now = lines_of(*text);
            std::size_t gone = 0;
            for (const std::string& line : lines_of(source)) {
                gone += std::find(now.begin(), now.end(), line) == now.end() ? 1 : 0;
                const std::size_t comment = line.find("# ");
                if (comment != std::string::npos) {
                    EXPECT_NE(text->find(line.substr(comment)), std::string::npos) << line;
                }
            }
            // A value of several lines, as of a crystal plate, becomes one.
            EXPECT_LE(gone, 3U) << *text;
        }
    }
    EXPECT_GE(files, 17U);
}

}  // namespace
}  // namespace pol
