// SPDX-License-Identifier: Apache-2.0
// Every bad scene is refused with an address: file, line, column, key path, and a hint.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "io/scenes/scene_file.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// Line 1 of most cases.
const std::string some_camera = "camera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 30}\n";
/// The same and an empty list of objects in line 2.
const std::string empty_scene = some_camera + "objects: []\n";

struct BadScene {
    const char* story;
    std::string text;
    const char* at;  ///< the error points at the first occurrence of this in `text`
    const char* field;
    const char* what;
    const char* hint;

    /// GoogleTest would print the bytes of the pointers: other test names in every run.
    friend void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.story; }
};

std::string object(const std::string& rest) {
    return some_camera + "objects:\n  - {name: a, " + rest + "}\n";
}

const std::vector<BadScene>& bad_scenes() {
    static const std::vector<BadScene> cases{
        {"empty file", "", "", "", "empty", "README"},
        {"only a comment", "# nothing\n", "# noth", "", "empty", "README"},
        {"not YAML", "camera: {position: [0, 0\nobjects: ]]\n", ": ]]", "", "not valid YAML", "brackets"},
        {"a sentence", "hello world\n", "hello ", "", "expected a map", "key: value"},
        {"a list", "- 1\n- 2\n", "- 1", "", "expected a map", "key: value"},
        {"two documents", empty_scene + "---\ntitle: b\n", "title:", "", "second YAML document", "---"},
        {"a comma after the end", "{objects: []},\n", ",\n", "", "second YAML document", "comma"},
        {"a tab before a key", "camera:\n\tfov: 3\n", "\tfov", "", "indented with a tab; YAML allows only spaces",
         "spaces"},
        {"a tab before an item", some_camera + "objects:\n\t- {name: a}\n", "\t- {", "", "indented with a tab",
         "spaces"},
        {"a tab after spaces", some_camera + "objects:\n  - name: a\n  \tabsorber: on\n", "\tabs", "",
         "indented with a tab", "spaces"},
        {"a tab between a dash and a key", some_camera + "objects:\n  -\tname: a\n    absorber: on\n", "\tname", "",
         "indented with a tab", "spaces"},
        {"a no-break space before an item", some_camera + "objects:\n\u00a0 - name: a\n    absorber: on\n", ": on", "",
         "not valid YAML", "U+00A0"},
        {"a no-break space before a number", empty_scene + "render: {residual: \u00a01e-3}\n", "\u00a01e-3",
         "render.residual", "'<U+00A0>1e-3', expected a number", "1.5"},
        {"a no-break space after a colon", empty_scene + "render: {spp:\u00a04}\n", "spp", "render.spp:\u00a04",
         "'spp:<U+00A0>4'", "known: size"},

        {"a merged word", empty_scene + "title: &t a\nrender: {<<: *t}\n", "<<", "render.<<", "only maps can be merged",
         "*name"},
        {"a merged list of words", empty_scene + "render: {<<: [a]}\n", "<<", "render.<<", "only maps can be merged",
         "[*a, *b]"},
        {"two merge keys", "render: {<<: {spp: 1}, <<: {depth: 2}}\n" + empty_scene, "<<: {depth", "render.<<",
         "'<<' occurs twice", "[*a, *b]"},
        {"a quoted merge key is a plain key", empty_scene + "render: {\"<<\": {spp: 1}}\n", "\"<<", "render.<<",
         "unknown key '<<'", "known: size"},
        {"an unknown key in a merged map", "render: {<<: {sp: 1}}\n" + empty_scene, "sp: 1", "render.sp", "unknown key",
         "'spp'"},
        {"a map merged into itself", empty_scene + "render: &r {<<: *r}\n", "<<", "render.<<", "more than 100 maps",
         "write the keys out"},

        {"unknown key", some_camera + "objets: []\n", "objets", "objets", "unknown key", "'objects'"},
        {"unknown axis", object("shape: {mesh: {file: bench/gem.ply, up: w}}, absorber: on"), "w}",
         "objects[0].shape.mesh.up", "unknown word 'w'", "y"},
        {"unknown key far from all", empty_scene + "zzzzzz: 1\n", "zzzzzz", "zzzzzz", "unknown key", "known: title"},
        {"unknown key inside", "camera:\n  positon: [0, 0, 5]\nobjects: []\n", "posito", "camera.positon",
         "unknown key", "'position'"},
        {"unknown key of an object", object("shape: {sphere: {radius: 1}}, mdium: glass"), "mdium:", "objects[0].mdium",
         "unknown key", "'medium'"},
        {"duplicate key", empty_scene + "title: a\ntitle: b\n", "title: b", "title", "occurs twice", "line 3"},
        {"missing camera", "objects: []\n", "object", "camera", "missing", "camera: ..."},
        {"missing objects", some_camera, "camera", "objects", "missing", "objects: ..."},
        {"missing key inside", "objects: []\ncamera: {position: [0, 0, 5], fov: 30}\n", "{posit", "camera.target",
         "missing", "target: ..."},
        {"missing name", some_camera + "objects:\n  - {shape: {sphere: {radius: 1}}, absorber: on}\n", "{shape",
         "objects[0].name", "missing", "name: ..."},

        {"wrong type: map for list", some_camera + "objects: {}\n", "{}", "objects", "found a map, expected a list",
         "- "},
        {"wrong type: list for map", "camera: [1]\nobjects: []\n", "[1]", "camera", "found a list, expected a map",
         "key"},
        {"wrong type: word for number", empty_scene + "render: {residual: small}\n", "small}", "render.residual",
         "'small', expected a number", "1.5"},
        {"wrong type: quotes", empty_scene + "render: {residual: \"1e-3\"}\n", "\"1e-3\"", "render.residual",
         "the text", "quotes"},
        {"wrong type: nothing", empty_scene + "render: {residual: ~}\n", "~", "render.residual", "found nothing",
         "number"},
        {"wrong type: fraction", empty_scene + "render: {spp: 1.5}\n", "1.5}", "render.spp", "whole number", "decimal"},
        {"wrong type: two for three", "objects: []\ncamera: {position: [0, 5], target: [0, 0, 0], fov: 30}\n", "[0, 5]",
         "camera.position", "list of 2", "[x, y, z]"},
        {"wrong word", empty_scene + "render: {mode: aera}\n", "aera}", "render.mode", "unknown word", "'area'"},
        {"wrong truth", object("shape: {sphere: {radius: 1}}, absorber: maybe"), "maybe}", "objects[0].absorber",
         "expected on or off", "on or off"},
        {"two shapes", object("shape: {sphere: {radius: 1}, disk: {radius: 1}}, absorber: on"), "{spher",
         "objects[0].shape", "exactly one of", "keep one"},
        {"no such shape", object("shape: {spere: {radius: 1}}, absorber: on"), "spere:", "objects[0].shape.spere",
         "unknown key", "'sphere'"},
        {"no role", object("shape: {sphere: {radius: 1}}"), "{name:", "objects[0]", "exactly one of", "to light"},
        {"two roles", object("shape: {sphere: {radius: 1}}, absorber: on, medium: g"), "{name:", "objects[0]",
         "found 2", "to light"},

        {"NaN", "objects: []\ncamera: {position: [0, .nan, 5], target: [0, 0, 0], fov: 30}\n", ".nan, ",
         "camera.position[1]", "not a finite number", "finite"},
        {"infinity", object("shape: {sphere: {radius: inf}}, absorber: on"), "inf}},", "objects[0].shape.sphere.radius",
         "not a finite number", "finite"},
        {"overflow", object("shape: {sphere: {radius: 1e999}}, absorber: on"), "1e999}",
         "objects[0].shape.sphere.radius", "does not fit", "1e308"},
        {"negative radius", object("shape: {sphere: {radius: -1}}, absorber: on"), "-1}}, ",
         "objects[0].shape.sphere.radius", "greater than 0", "positive"},
        {"zero size", object("shape: {box: {size: [1, 0, 1]}}, absorber: on"), "[1, 0,", "objects[0].shape.box.size",
         "greater than 0", "positive"},
        {"absurd size", object("shape: {box: {size: 1e20}}, absorber: on"), "1e20}}", "objects[0].shape.box.size",
         "absurdly", "unit"},
        {"impossible rhomb", object("shape: {rhomb: {angle: 30, aperture: 1, height: 1}}, absorber: on"), "30, ap",
         "objects[0].shape.rhomb.angle", "between 45 and 90", "54.6"},
        {"concave polygon",
         object("shape: {extrusion: {polygon: [[0, 0], [2, 0], [0.5, 0.5], [0, 2]], height: 1}}, absorber: on"),
         "[0.5, 0.5]", "objects[0].shape.extrusion.polygon[2]", "turn left", "convex"},
        {"index zero", empty_scene + "media: {glass: 0 }\n", "0 }", "media.glass.index", "between 0 and 100", "1.5"},
        {"index negative", empty_scene + "media: {glass: {index: -1.5}}\n", "-1.5}}", "media.glass.index",
         "between 0 and 100", "1.5"},
        {"index absurd", empty_scene + "media: {glass: {index: 101}}\n", "101}}", "media.glass.index",
         "between 0 and 100", "1.5"},
        {"gain", empty_scene + "media: {gold: {conductor: [0.2, -3]}}\n", "[0.2, ", "media.gold.conductor",
         "extinction", "absorbs"},
        {"negative absorption", empty_scene + "media: {glass: {index: 1.5, absorption: -1}}\n", "-1}}",
         "media.glass.absorption", "negative", "0 or more"},
        {"picture of size 0", empty_scene + "render: {size: [0, 512]}\n", "[0, 51", "render.size", "1 to 65536", "512"},
        {"picture too wide", empty_scene + "render: {size: [65537, 1]}\n", "[65537", "render.size", "1 to 65536",
         "512"},
        {"picture too large", empty_scene + "render: {size: [65536, 65536]}\n", "[65536", "render.size", "2^31", "512"},
        {"picture of 1e9 x 1e9", empty_scene + "render: {size: [1000000000, 1000000000]}\n", "[1000000000, ",
         "render.size", "1 to 65536", "512"},
        {"picture beyond int", empty_scene + "render: {size: [1e300, 1]}\n", "1e300,", "render.size[0]", "too large",
         "2147483647"},
        {"no samples", empty_scene + "render: {spp: 0 }\n", "0 }", "render.spp", "between 1", "usual"},
        {"residual above 1", empty_scene + "render: {residual: 2}\n", "2}", "render.residual", "between 0 and 1",
         "0.1 %"},
        {"negative depth", empty_scene + "render: {depth: -1}\n", "-1}", "render.depth", "between 0", "paper used 9"},
        {"negative seed", empty_scene + "render: {seed: -1}\n", "-1}", "render.seed", "18446744073709551615", "sign"},
        {"field of view", "objects: []\ncamera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 180}\n",
         "180}", "camera.fov", "between 0 and 180", "30"},
        {"wavelengths descend", empty_scene + "render: {wavelengths: [600, 500]}\n", "[600, ", "render.wavelengths", "",
         ""},
        {"wavelength range", empty_scene + "render: {wavelengths: 780:380:20}\n", "780:38", "render.wavelengths", "780",
         ""},
        {"negative light", object("shape: {sphere: {radius: 1}}, emission: {radiance: -1}"), "-1}}",
         "objects[0].emission.radiance", "negative", "0 or more"},
        {"too polarized",
         object("shape: {disk: {radius: 1}}, emission: {radiance: 1, polarization: {stokes: [1, 1, 0]}}"), "{stoke",
         "objects[0].emission.polarization", "more than fully polarized", "s0"},
        {"degree above 1",
         object("shape: {disk: {radius: 1}}, emission: {radiance: 1, polarization: {dop: 2, azimuth: 0}}"), "2, azi",
         "objects[0].emission.polarization.dop", "between 0 and 1", "fully polarized"},

        {"camera at its target", "objects: []\ncamera: {position: [1, 2, 3], target: [1, 2, 3], fov: 30}\n",
         "[1, 2, 3], fov", "camera.target", "no direction to look in", "move"},
        {"up along the view", "objects: []\ncamera: {position: [0, 0, 5], target: [0, 0, 0], fov: 30}\n", "{posit",
         "camera.up", "parallel to the line of sight", "another up"},
        {"up zero", "objects: []\ncamera: {position: [0, 0, 5], target: [0, 0, 0], up: [0, 0, 0], fov: 30}\n",
         "[0, 0, 0], fov", "camera.up", "its length is zero", "[0, 0, 1]"},
        {"optic axis zero", empty_scene + "media: {c: {ordinary: 1.6, extraordinary: 1.5, axis: [0, 0, 0]}}\n",
         "[0, 0, 0]}", "media.c.axis", "its length is zero", "[0, 0, 1]"},
        {"rotation axis zero",
         object("shape: {disk: {radius: 1}}, absorber: on, transform: [{rotate: {axis: [0, 0, 0], angle: 3}}]"),
         "[0, 0, 0], angle", "objects[0].transform[0].rotate.axis", "its length is zero", "[0, 0, 1]"},
        {"sheet axis across the sheet", object("shape: {disk: {radius: 1}}, sheet: {polarizer: {axis: [0, 0, 1]}}"),
         "[0, 0, 1]", "objects[0].sheet.polarizer.axis", "perpendicular to the sheet", "[1, 0, 0]"},
        {"singular scale", object("shape: {disk: {radius: 1}}, absorber: on, transform: [{scale: [1, 1, 0]}]"),
         "[{scal", "objects[0].transform", "singular", "other than 0"},
        {"singular matrix",
         object("shape: {disk: {radius: 1}}, absorber: on, transform: [{matrix: [[1, 2, 0, 0], [2, 4, 0, 0], [0, 0, 1, "
                "0]]}]"),
         "[{matr", "objects[0].transform", "singular", "other than 0"},

        {"unknown medium", object("shape: {sphere: {radius: 1}}, medium: glas") + "media: {glass: 1.5}\n", "glas}",
         "objects[0].medium", "no medium called 'glas'", "'glass'"},
        {"unknown ambient", empty_scene + "ambient: water\n", "water", "ambient", "no medium called 'water'", "media"},
        {"unknown record", empty_scene + "media: {glass: n-bk8}\n", "n-bk8}", "media.glass", "n-bk8", "n-bk7"},
        {"unknown crystal", empty_scene + "media: {c: {crystal: calcit}}\n", "calcit", "media.c.crystal", "calcit",
         "calcite"},
        {"missing texture", object("shape: {rectangle: {size: 1}}, emission: {radiance: {texture: no.png}}"), "no.png",
         "objects[0].emission.radiance.texture", "no file 'no.png'", "textures"},
        {"missing mesh", object("shape: {mesh: {file: no.ply}}, absorber: on"), "no.ply", "objects[0].shape.mesh.file",
         "no file 'no.ply'", "beside the scene"},
        {"texture on a ball", object("shape: {sphere: {radius: 1}}, emission: {radiance: {texture: test-card.png}}"),
         "{textu", "objects[0].emission.radiance", "only a rectangle", "rectangle"},
        {"duplicate object",
         some_camera +
             "objects:\n  - {name: a, shape: {disk: {radius: 1}}, absorber: on}\n  - {name: \"a\", shape: {disk: "
             "{radius: 1}}, "
             "absorber: on}\n",
         "\"a\"", "objects[1].name", "another object is called 'a'", "rename"},
        {"duplicate medium", empty_scene + "media: {a: 1.5, a: 1.6}\n", "a: 1.6", "media.a", "occurs twice", "line 3"},
        {"open solid", object("shape: {disk: {radius: 1}}, medium: g") + "media: {g: 1.5}\n", "g}", "objects[0].medium",
         "encloses nothing", "closed shape"},
        {"plate of glass",
         object("shape: {disk: {radius: 1}}, emission: {radiance: 1, polarization: {crystal_plate: {medium: g, axis: "
                "[1, 0, 0], "
                "ray: e, fresnel: off}}}") +
             "media: {g: 1.5}\n",
         "g, axi", "objects[0].emission.polarization.crystal_plate.medium", "not a uniaxial crystal", "crystal"},
        {"metal around the camera", empty_scene + "media: {metal: {conductor: gold}}\nambient: \"metal\"\n",
         "\"metal\"", "ambient", "isotropic", "index"},
        {"record outside its range",
         object("shape: {sphere: {radius: 1}}, medium: g") + "media: {g: n-bk7}\nrender: {wavelengths: 200}\n",
         "n-bk7}", "media.g.index", "200", ""},
        {"table outside its range",
         object("shape: {sphere: {radius: 1}}, medium: g") +
             "media: {g: {index: 1.5, absorption: {table: [[400, 0], [500, 0]]}}}\n",
         "{table", "media.g.absorption", "580", ""},
        {"table with two values", empty_scene + "background: {table: [[500, 1], [400, 1], [500, 2]]}\n", "[[500,",
         "background.table", "two values at 500 nm", "only one"},
        {"table in micrometres", empty_scene + "background: {table: [[0.4, 1], [0.7, 1]]}\n", "[[0.4,",
         "background.table", "were micrometres meant?", "0.58 um is 580"},
        {"formula in micrometres",
         empty_scene + "media: {g: {index: {formula: 5, coefficients: [1.5], range: [0.4, 0.7]}}}\n", "[0.4, 0.7]",
         "media.g.index.range", "were micrometres meant?", "0.58 um is 580"},
        {"wavelength in micrometres", empty_scene + "render: {wavelengths: 0.58}\n", "0.58", "render.wavelengths",
         "were micrometres meant?", "0.58 um is 580"},
        {"wavelengths in micrometres", empty_scene + "render: {wavelengths: [0.45, 0.65]}\n", "[0.45",
         "render.wavelengths", "were micrometres meant?", "0.45 um is 450"},
        {"crystal of one file", empty_scene + "media: {c: {crystal: ./spar.yml}}\n", "./spar", "media.c.crystal",
         "one file, and a crystal has two indices", "NAME-o.yml"},
        {"biaxial crystal", empty_scene + "media: {c: {crystal: ktp}}\n", "ktp", "media.c.crystal", "biaxial",
         "NAME-o"},
        {"crystal as one index", empty_scene + "media: {c: calcite}\n", "calcite", "media.c", "is a crystal",
         "{crystal: calcite}"},
        {"metal without its k",
         object("shape: {sphere: {radius: 1}}, medium: g") +
             "media: {g: {conductor: {table: [[400, 1], [700, 1]], k: [[400, 3], [500, 3]]}}}\n",
         "{table", "media.g.conductor", "k is not known at 580 nm", "inside the range of k"},
        {"wavelengths that are a map", empty_scene + "render: {wavelengths: {a: 580}}\n", "{a:", "render.wavelengths",
         "a number is missing", "380:780:20"},
        {"no wavelengths", empty_scene + "render: {wavelengths: ~}\n", "~}", "render.wavelengths",
         "a number is missing", "380:780:20"},
        {"medium that is a list", empty_scene + "media: {g: [1.5, 0.1]}\n", "[1.5", "media.g", "no medium",
         "{index: ...}"},
        {"medium that is nothing", empty_scene + "media: {glass: ~}\n", "~}", "media.glass", "no medium",
         "{index: ...}"},
        {"absurd translation",
         object("shape: {disk: {radius: 1}}, absorber: on, transform: [{translate: [1e300, 0, 0]}]"), "[{trans",
         "objects[0].transform", "beyond 1e15", "absurd"},
        {"absurd scale", object("shape: {disk: {radius: 1}}, absorber: on, transform: [{scale: 1e200}]"), "[{scale",
         "objects[0].transform", "beyond 1e15", "absurd"},
        {"missing include", empty_scene + "include: [no.yaml]\n", "no.yam", "include[0]", "no file 'no.yaml'",
         "beside"},
    };
    return cases;
}

class BadSceneText : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneText, IsRefusedWithAddressAndHint) {
    const BadScene& bad = GetParam();
    const Result<Scene> scene = parse_scene(bad.text, "bad.yaml", fs::path(POL_TESTS_DIR) / "io");
    ASSERT_FALSE(scene) << bad.story;
    const Error& error = scene.error();
    SCOPED_TRACE(to_string(error));
    EXPECT_EQ(error.kind, ErrorKind::input);
    EXPECT_EQ(error.place.file, "bad.yaml");
    const std::size_t at = bad.text.find(bad.at);
    ASSERT_NE(at, std::string::npos);
    const std::size_t line_start = at == 0 ? 0 : bad.text.rfind('\n', at - 1) + 1;
    EXPECT_EQ(error.place.line,
              1 + std::count(bad.text.begin(), bad.text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    EXPECT_EQ(error.place.column, static_cast<int>(at - line_start) + 1);
    EXPECT_EQ(error.field, bad.field);
    EXPECT_NE(error.what.find(bad.what), std::string::npos);
    EXPECT_NE(error.hint.find(bad.hint), std::string::npos);
    EXPECT_FALSE(error.hint.empty());
}

std::string story_of(const testing::TestParamInfo<BadScene>& param) {
    std::string name = param.param.story;
    for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, BadSceneText, testing::ValuesIn(bad_scenes()), story_of);

/// A folder that is gone after the test.
class SceneFolder : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("polariscope-scene-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    fs::path folder_;
};

TEST_F(SceneFolder, MissingFilesAndDirectoriesAreRefusedByName) {
    const Result<Scene> missing = load_scene(folder_ / "no.yaml");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().what.find("no such file"), std::string::npos);
    EXPECT_EQ(missing.error().place.file, (folder_ / "no.yaml").string());
    const Result<Scene> directory = load_scene(folder_);
    ASSERT_FALSE(directory);
    EXPECT_NE(directory.error().what.find("folder"), std::string::npos);
    EXPECT_EQ(directory.error().kind, ErrorKind::input);
}

TEST_F(SceneFolder, IncludesBringMediaAndObjectsAndKeepTheirPlaces) {
    write("glass.yaml", "media:\n  glass: 1.5\nobjects:\n  - {name: b, shape: {sphere: {radius: 1}}, medium: glass}\n");
    const fs::path path = write("main.yaml", some_camera +
                                                 "include: [glass.yaml]\n"
                                                 "objects:\n  - {name: a, shape: {disk: {radius: 1}}, absorber: on}\n");
    const Result<Scene> scene = load_scene(path);
    ASSERT_TRUE(scene) << to_string(scene.error());
    ASSERT_EQ(scene.value().objects.size(), 2U);
    EXPECT_EQ(scene.value().objects[0].name, "a");
    EXPECT_EQ(scene.value().objects[0].place.file, 0);
    EXPECT_EQ(scene.value().objects[1].place.file, 1);
    EXPECT_EQ(scene.value().objects[1].place.line, 4);
    ASSERT_EQ(scene.value().files.size(), 2U);
    EXPECT_EQ(fs::path(scene.value().files[1]).filename(), "glass.yaml");
}

TEST_F(SceneFolder, AMistakeInAnIncludeIsReportedThere) {
    write("part.yaml", "media:\n  glass: -1\n");
    const fs::path path = write("main.yaml", empty_scene + "include: [part.yaml]\n");
    const Result<Scene> scene = load_scene(path);
    ASSERT_FALSE(scene);
    EXPECT_EQ(fs::path(scene.error().place.file).filename(), "part.yaml");
    EXPECT_EQ(scene.error().place.line, 2);
    EXPECT_EQ(scene.error().place.column, 10);
}

TEST_F(SceneFolder, AnIncludeThatLeadsBackIsRefusedWithItsChain) {
    write("b.yaml", "include: [c.yaml]\n");
    write("c.yaml", "include: [./a.yaml]\n");
    const fs::path path = write("a.yaml", empty_scene + "include: [b.yaml]\n");
    const Result<Scene> scene = load_scene(path);
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().what.find("a.yaml -> b.yaml -> c.yaml -> a.yaml"), std::string::npos) << scene.error().what;
    EXPECT_EQ(fs::path(scene.error().place.file).filename(), "c.yaml");
    EXPECT_EQ(scene.error().place.line, 1);
    EXPECT_EQ(scene.error().place.column, 11);
    EXPECT_EQ(scene.error().field, "include[0]");
    EXPECT_FALSE(scene.error().hint.empty());
}

TEST_F(SceneFolder, AnIncludeHasNoCamera) {
    write("b.yaml", some_camera);
    const Result<Scene> scene = load_scene(write("a.yaml", empty_scene + "include: [b.yaml]\n"));
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().field, "camera");
    EXPECT_NE(scene.error().what.find("unknown key"), std::string::npos);
}

TEST_F(SceneFolder, AMalformedIndexRecordIsReportedInItsOwnFile) {
    write("bad.yml", "DATA:\n  - type: formula 10\n    coefficients: 1 2 3\n    wavelength_range: 0.3 0.8\n");
    const Result<Scene> scene = load_scene(write("a.yaml", empty_scene + "media: {g: bad.yml}\n"));
    ASSERT_FALSE(scene);
    EXPECT_EQ(fs::path(scene.error().place.file).filename(), "bad.yml");
    EXPECT_GT(scene.error().place.line, 0);
}

TEST_F(SceneFolder, ARecordThatIsGoneIsSavedWithAllItsBlocks) {
    write("r.yml",
          "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.5\n    coefficients: 1.5\n"
          "  - type: tabulated nk\n    data: |\n        0.5 1.25 1\n        0.6 1.25 1\n        0.6 1.25 2\n"
          "  - type: tabulated k\n    data: |\n        2.0 -3\n        3.0 3\n");
    const Result<Scene> scene = load_scene(write("a.yaml", empty_scene + "media: {g: r.yml}\n"));
    ASSERT_TRUE(scene) << to_string(scene.error());
    fs::remove(folder_ / "r.yml");
    const Result<Scene> again = load_scene(write("b.yaml", save_scene(scene.value())));
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(std::get<IsotropicMedium>(again.value().media[0].matter).index,
              std::get<IsotropicMedium>(scene.value().media[0].matter).index);
}

TEST_F(SceneFolder, ACrystalByPathIsThePairOfFilesBesideTheScene) {
    const std::string record = "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.6584\n        0.7 1.6584\n";
    write("spar-o.yml", record);
    write("spar-e.yml", "DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.7\n    coefficients: 1.4864\n");
    write("spar.yml", record);
    const fs::path path = write("a.yaml", empty_scene + "media: {c: {crystal: ./spar}}\n");
    const Result<Scene> scene = load_scene(path);
    ASSERT_TRUE(scene) << to_string(scene.error());
    const auto indices = [](const Scene& of) {
        const auto& crystal = std::get<UniaxialMedium>(of.media[0].matter);
        return std::pair{index_at(crystal.ordinary, 580.0).value().n, index_at(crystal.extraordinary, 580.0).value().n};
    };
    EXPECT_EQ(indices(scene.value()), std::pair(1.6584, 1.4864));
    const Result<Scene> again = load_scene(write("b.yaml", save_scene(scene.value())));
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(indices(again.value()), std::pair(1.6584, 1.4864));

    fs::remove(folder_ / "spar-e.yml");
    const Result<Scene> half = load_scene(path);
    ASSERT_FALSE(half);
    EXPECT_EQ(half.error().field, "media.c.crystal");
    EXPECT_NE(half.error().what.find("spar-e.yml"), std::string::npos) << half.error().what;
    fs::remove(folder_ / "spar-o.yml");
    EXPECT_NE(load_scene(path).error().what.find("no file './spar-o.yml'"), std::string::npos);
    write("spar-beta.yml", record);
    EXPECT_NE(load_scene(path).error().what.find("biaxial (it has spar-beta)"), std::string::npos);
}

TEST_F(SceneFolder, ATextureThatIsNoPictureIsReportedWhereItIsNamed) {
    write("no.png", "not a picture");
    const Result<Scene> scene =
        load_scene(write("a.yaml", object("shape: {rectangle: {size: 1}}, emission: {radiance: {texture: no.png}}")));
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().place.line, 3);
    EXPECT_EQ(scene.error().field, "objects[0].emission.radiance.texture");
    EXPECT_NE(scene.error().what.find("no.png"), std::string::npos);
}

// Guards the parser's stack: yaml-cpp recurses over nested lists.
TEST(SceneText, BinaryIsNoScene) {
    const Result<Scene> scene = parse_scene(std::string("\x7f"
                                                        "ELF\x02\x01\x01\0\0\0",
                                                        10),
                                            "program", ".");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().kind, ErrorKind::input);
    EXPECT_EQ(scene.error().place.line, 1);
}

TEST(SceneText, DeepNestingIsAnErrorNotACrash) {
    const std::string deep(100000, '[');
    EXPECT_FALSE(parse_scene("camera: " + deep, "deep.yaml", "."));
    EXPECT_FALSE(parse_scene("a: &a [*a]\n", "loop.yaml", "."));
}

}  // namespace
}  // namespace pol
