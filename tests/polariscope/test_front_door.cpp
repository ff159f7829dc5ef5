// SPDX-License-Identifier: Apache-2.0
// The library as a program outside meets it: through <polariscope/polariscope.h> alone. Whatever the input, there is an
// answer or an error, and the host lives on.
#include <gtest/gtest.h>
#include <polariscope/polariscope.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace ps = polariscope;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// A shipped scene, small.
ps::Scene small_scene(const std::string& name, int size = 16) {
    const ps::Scene scene = ps::shipped_scene(name).and_then(ps::load_scene).value();
    ps::RenderSettings settings = scene.settings();
    settings.width = settings.height = size;
    settings.samples_per_pixel = 1;
    return scene.with(settings).value();
}

ps::Plan small_plan(const std::string& name, int size = 16) {
    return ps::compile(small_scene(name, size)).value();
}

/// A picture that takes minutes.
ps::Plan endless_plan() {
    const ps::Scene scene = small_scene("cube-calcite");
    ps::RenderSettings settings = scene.settings();
    settings.mode = ps::SampleMode::area;
    settings.samples_per_pixel = 1 << 24;
    return scene.with(settings).and_then(ps::compile).value();
}

std::filesystem::path file_here(const std::string& name) {
    return std::filesystem::path(testing::TempDir()) / ("front_door_" + name);
}

template <class T>
void expect_error(const ps::Result<T>& result, ps::ErrorKind kind, const std::string& field = {}) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, kind) << to_string(result.error());
    EXPECT_FALSE(result.error().message.empty());
    if (!field.empty()) {
        EXPECT_EQ(result.error().field, field) << to_string(result.error());
    }
}

TEST(FrontDoor, LeadsFromASceneFileToACoherenceMatrix) {
    const ps::Scene scene = small_scene("cube-calcite");
    EXPECT_FALSE(scene.objects().empty());
    EXPECT_FALSE(scene.media().empty());
    const ps::Plan plan = ps::compile(scene).value();
    const ps::Rendering done = ps::render(plan).value();
    EXPECT_EQ(done.end, ps::RenderEnd::samples);
    EXPECT_EQ(done.progress.done, 1.0);
    EXPECT_EQ(done.progress.failures, 0U);
    EXPECT_EQ(done.picture.width(), 16);
    EXPECT_EQ(done.picture.wavelengths_nm(), plan.settings().wavelengths_nm);
    const ps::Coherence j = done.picture.coherence(8, 8).value();
    EXPECT_GT(j.xx, 0.0);
    EXPECT_GE(j.xx * j.yy, std::norm(j.xy) * (1.0 - 1e-9)) << "positive semidefinite";
    EXPECT_EQ(done.picture.plane().value()[8 * 16 + 8], done.picture.stokes(8, 8).value());
    EXPECT_LE(done.picture.missing(8, 8).value(), plan.brightest()[0]);
}

TEST(FrontDoor, WritesASceneThatReadsBackToTheSamePicture) {
    const ps::Scene scene = small_scene("metal-spheres");
    const auto again = scene.as_yaml().and_then([](const std::string& yaml) { return ps::parse_scene(yaml); });
    const auto picture_of = [](const ps::Scene& s) {
        return ps::compile(s).and_then([](const ps::Plan& p) { return ps::render(p); }).value().picture.plane().value();
    };
    EXPECT_EQ(picture_of(scene), picture_of(again.value()));
}

TEST(FrontDoor, MatricesAndStokesVectorsAreTwoFormsOfOneThing) {
    const ps::Stokes light{1.0, 0.25, -0.5, 0.125};
    const ps::Coherence j = ps::coherence(light);
    EXPECT_EQ(j.xx, 0.625);
    EXPECT_EQ(j.yy, 0.375);
    EXPECT_EQ(j.xy, std::complex<double>(-0.25, 0.0625));
    EXPECT_EQ(ps::stokes(j), light);
}

TEST(FrontDoor, SaysWhereAFileIsWrong) {
    expect_error(ps::load_scene("/no/such/scene.yaml"), ps::ErrorKind::input);
    expect_error(ps::load_scene(testing::TempDir()), ps::ErrorKind::input);
    expect_error(ps::shipped_scene("no-such-scene"), ps::ErrorKind::input);
    const auto scene = ps::parse_scene(
        "camera: {position: [0, -4, 2], target: [0, 0, 0], fov: 30}\nobjects:\n  - {name: x, "
        "shape: {box: {size: 1}}, medium: glas}\nmedia: {glass: 1.5}\n",
        "mine.yaml");
    expect_error(scene, ps::ErrorKind::input, "objects[0].medium");
    EXPECT_EQ(scene.error().file, "mine.yaml");
    EXPECT_EQ(scene.error().line, 3);
    EXPECT_GT(scene.error().column, 0);
    EXPECT_EQ(scene.error().hint, "did you mean 'glass'?");
    for (const std::string text : {"", "{", "\xff\xfe", "camera: &a [*a]", "objects: 3"})
        expect_error(ps::parse_scene(text), ps::ErrorKind::input);
}

TEST(FrontDoor, RefusesSettingsThatMakeNoPicture) {
    const ps::Scene scene = small_scene("cube-calcite");
    const auto expect_refused = [&scene](const char* field, auto edit) {
        ps::RenderSettings settings = scene.settings();
        edit(settings);
        expect_error(scene.with(settings).and_then(ps::compile), ps::ErrorKind::input, field);
    };
    expect_refused("render.wavelengths", [](ps::RenderSettings& s) { s.wavelengths_nm.clear(); });
    expect_refused("render.wavelengths", [](ps::RenderSettings& s) { s.wavelengths_nm = {600.0, 500.0}; });
    expect_refused("render.wavelengths", [](ps::RenderSettings& s) { s.wavelengths_nm = {nan}; });
    expect_refused("render.size", [](ps::RenderSettings& s) { s.width = 0; });
    expect_refused("render.size", [](ps::RenderSettings& s) { s.height = 1 << 30; });
    expect_refused("render.spp", [](ps::RenderSettings& s) { s.samples_per_pixel = -1; });
    expect_refused("render.residual", [](ps::RenderSettings& s) { s.residual = nan; });
    expect_refused("render.depth", [](ps::RenderSettings& s) { s.depth = -1; });
    expect_refused("render.node_budget", [](ps::RenderSettings& s) { s.node_budget = 0; });
    ps::RenderSettings outside = scene.settings();
    outside.wavelengths_nm = {1e6};
    const auto plan = scene.with(outside).and_then(ps::compile);
    expect_error(plan, ps::ErrorKind::input);
    EXPECT_NE(plan.error().field.find("media."), std::string::npos);
    EXPECT_NE(plan.error().file.find("cube-calcite.yaml"), std::string::npos);
}

TEST(FrontDoor, RefusesOptionsThatMakeNoRender) {
    const ps::Plan plan = small_plan("cube-glass");
    ps::RenderOptions options;
    options.threads = -1;
    expect_error(ps::render(plan, options), ps::ErrorKind::usage, "options.threads");
    options = {};
    options.seconds = nan;
    expect_error(ps::render(plan, options), ps::ErrorKind::usage, "options.seconds");
    options = {};
    options.error = 0.0;
    expect_error(ps::render(plan, options), ps::ErrorKind::usage, "options.error");
}

TEST(FrontDoor, SaysThatAPictureIsBeyondAllMemory) {
    const ps::Scene scene = ps::parse_scene(R"(
camera: {position: [0, -4, 2], target: [0, 0, 0], fov: 30}
media: {glass: 1.5}
objects: [{name: box, shape: {box: {size: 1}}, medium: glass}]
)")
                                .value();
    ps::RenderSettings settings;
    settings.width = 65536;
    settings.height = 32768;
    settings.wavelengths_nm.clear();
    for (int i = 0; i < 4096; ++i) settings.wavelengths_nm.push_back(400.0 + 0.05 * i);
    const auto done =
        scene.with(settings).and_then(ps::compile).and_then([](const ps::Plan& plan) { return ps::render(plan); });
    expect_error(done, ps::ErrorKind::memory);
}

TEST(FrontDoor, TellsHowFarItIsAndStopsWhenAsked) {
    std::stop_source stop;
    ps::RenderOptions options;
    options.stop = stop.get_token();
    int calls = 0;
    options.progress = [&](const ps::RenderProgress& progress) {
        ++calls;
        EXPECT_GE(progress.seconds, 0.0);
        if (progress.fewest_samples > 0) stop.request_stop();
    };
    const auto done = ps::render(endless_plan(), options);
    ASSERT_TRUE(done) << to_string(done.error());
    EXPECT_EQ(done.value().end, ps::RenderEnd::stopped);
    EXPECT_LT(done.value().progress.done, 1.0);
    EXPECT_GT(calls, 1);
    EXPECT_GT(done.value().picture.stokes(8, 8).value().s0, 0.0) << "what is finished stays";
    EXPECT_GT(done.value().picture.sampling_error(8, 8).value().s0, 0.0);
}

TEST(FrontDoor, KeepsATimeLimit) {
    ps::RenderOptions options;
    options.seconds = 0.2;
    EXPECT_EQ(ps::render(endless_plan(), options).value().end, ps::RenderEnd::seconds);
}

TEST(FrontDoor, AnExceptionOfTheHostComesBackAsAnError) {
    ps::RenderOptions options;
    options.progress = [](const ps::RenderProgress&) { throw std::runtime_error("the host has had enough"); };
    const auto done = ps::render(endless_plan(), options);
    expect_error(done, ps::ErrorKind::internal);
    EXPECT_EQ(done.error().message, "the host has had enough");
}

TEST(FrontDoor, SeveralThreadsGetTheSameBits) {
    const ps::Plan plan = small_plan("twinned-crystals");
    std::vector<std::vector<ps::Stokes>> planes(3);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < planes.size(); ++i)
        threads.emplace_back([&, i] {
            ps::RenderOptions options;
            options.threads = static_cast<int>(i) + 1;
            const ps::Plan own = ps::compile(small_scene("twinned-crystals")).value();
            planes[i] = ps::render(i == 0 ? plan : own, options).value().picture.plane().value();
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(planes[0], planes[1]);
    EXPECT_EQ(planes[0], planes[2]);
}

TEST(FrontDoor, ExplainsAPixelToTheLastBit) {
    const ps::Plan plan = small_plan("cube-calcite");
    const ps::Picture picture = ps::render(plan).value().picture;
    const ps::Explanation explanation = ps::explain(plan, 8, 8).value();
    EXPECT_TRUE(explanation.exact());
    EXPECT_EQ(explanation.stokes(), picture.stokes(8, 8).value());
    EXPECT_EQ(explanation.coherence(), picture.coherence(8, 8).value());
    const std::vector<ps::Branch>& branches = explanation.branches();
    ASSERT_GT(branches.size(), 4U);
    EXPECT_EQ(branches[0].interaction, "camera");
    EXPECT_EQ(branches[0].weight, 1.0);
    EXPECT_NEAR(branches[0].share.s0, explanation.stokes().s0, 1e-12);
    bool crystal = false;
    for (std::size_t i = 1; i < branches.size(); ++i) {
        ASSERT_LT(branches[i].parent, static_cast<int>(i));
        ASSERT_GE(branches[i].parent, 0);
        crystal = crystal || branches[i].mode == "e";
        EXPECT_NEAR(std::hypot(branches[i].direction[0], branches[i].direction[1], branches[i].direction[2]), 1.0,
                    1e-12);
    }
    EXPECT_TRUE(crystal);
    EXPECT_NE(explanation.as_text().value().find("camera"), std::string::npos);
    EXPECT_EQ(explanation.as_json().value().front(), '{');
    expect_error(explanation.as_text(nan), ps::ErrorKind::usage, "least_weight");
}

TEST(FrontDoor, TracesTheRayOfAPixel) {
    const ps::Plan plan = small_plan("cube-glass");
    const ps::Picture picture = ps::render(plan).value().picture;
    const ps::Ray ray = ps::camera_ray(plan, 8.5, 8.5).value();
    const ps::RayLight light = ps::trace_ray(plan, ray).value();
    ASSERT_EQ(light.light.size(), plan.settings().wavelengths_nm.size());
    EXPECT_NEAR(light.light[0].s0, picture.stokes(8, 8).value().s0, 1e-9);
    EXPECT_NEAR(light.light[0].s2, picture.stokes(8, 8).value().s2, 1e-9);
    EXPECT_GT(light.branches, 1U);
    EXPECT_EQ(light.failures, 0U);
    EXPECT_LE(light.missing[0], 1e-3 * plan.brightest()[0] * 1.001);
    // Any length, and x as far as it is across: the same ray.
    ps::Ray same = ray;
    for (std::size_t i = 0; i < 3; ++i) {
        same.direction[i] *= 17.0;
        same.x[i] = 3.0 * ray.x[i] + 0.5 * ray.direction[i];
    }
    EXPECT_NEAR(ps::trace_ray(plan, same).value().light[0].s1, light.light[0].s1, 1e-9);
}

TEST(FrontDoor, RefusesRaysThatAreNone) {
    const ps::Plan plan = small_plan("cube-calcite");
    const ps::Ray good = ps::camera_ray(plan, 8.5, 8.5).value();
    ps::Ray ray = good;
    ray.direction = {0.0, 0.0, 0.0};
    expect_error(ps::trace_ray(plan, ray), ps::ErrorKind::usage, "ray.direction");
    ray.direction = {nan, 0.0, 1.0};
    expect_error(ps::trace_ray(plan, ray), ps::ErrorKind::usage, "ray");
    ray = good;
    ray.origin = {inf, 0.0, 0.0};
    expect_error(ps::trace_ray(plan, ray), ps::ErrorKind::usage, "ray");
    ray = good;
    ray.x = ray.direction;
    expect_error(ps::trace_ray(plan, ray), ps::ErrorKind::usage, "ray.x");
    ray.x = {0.0, 0.0, 0.0};
    expect_error(ps::trace_ray(plan, ray), ps::ErrorKind::usage, "ray.x");
    expect_error(ps::camera_ray(plan, nan, 0.0), ps::ErrorKind::usage, "x, y");
    const ps::Scene box = ps::parse_scene(R"(
camera: {position: [0, -4, 2], target: [0, 0, 0], fov: 30}
media: {stone: {crystal: calcite}}
objects:
  - {name: stone, shape: {box: {size: 1}}, medium: stone}
  - {name: sun, shape: {sphere: {radius: 1}}, transform: [{translate: [0, 0, 9]}], emission: {radiance: 1}}
)")
                              .value();
    const ps::Plan inside = ps::compile(box).value();
    for (const ps::Vector origin : {ps::Vector{0.0, 0.0, 0.0}, ps::Vector{0.0, 0.0, 9.0}})
        expect_error(ps::trace_ray(inside, {origin, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}), ps::ErrorKind::usage,
                     "ray.origin");
}

TEST(FrontDoor, SaysThatAPixelIsOutside) {
    const ps::Plan plan = small_plan("cube-glass");
    const ps::Picture picture = ps::render(plan).value().picture;
    for (const auto& [x, y] : {std::pair(-1, 0), std::pair(0, -1), std::pair(16, 0), std::pair(0, 1 << 30)}) {
        expect_error(picture.stokes(x, y), ps::ErrorKind::usage, "x, y");
        expect_error(picture.coherence(x, y), ps::ErrorKind::usage, "x, y");
        expect_error(picture.missing(x, y), ps::ErrorKind::usage, "x, y");
        expect_error(ps::explain(plan, x, y), ps::ErrorKind::usage, "x, y");
    }
    for (const int wavelength : {-1, 1, 1 << 30}) {
        expect_error(picture.stokes(0, 0, wavelength), ps::ErrorKind::usage, "wavelength");
        expect_error(picture.plane(wavelength), ps::ErrorKind::usage, "wavelength");
        expect_error(ps::explain(plan, 0, 0, wavelength), ps::ErrorKind::usage, "wavelength");
        expect_error(ps::evaluate(picture, "dop", wavelength), ps::ErrorKind::usage, "wavelength");
    }
}

TEST(FrontDoor, StopsBeforeItBegins) {
    std::stop_source stop;
    stop.request_stop();
    const ps::Plan plan = small_plan("cube-glass");
    expect_error(ps::explain(plan, 8, 8, 0, 0, stop.get_token()), ps::ErrorKind::stopped);
    expect_error(ps::trace_ray(plan, ps::camera_ray(plan, 8.5, 8.5).value(), 0, stop.get_token()),
                 ps::ErrorKind::stopped);
    ps::RenderOptions options;
    options.stop = stop.get_token();
    EXPECT_EQ(ps::render(endless_plan(), options).value().end, ps::RenderEnd::stopped);
}

TEST(FrontDoor, ReadsAPictureOfAPolarizationCamera) {
    const ps::Picture camera =
        ps::read_picture(std::filesystem::path(POL_TESTS_DIR) / "data/pictures/stokes_dialects/hw3_linear_f8.npy")
            .value();
    EXPECT_TRUE(camera.wavelengths_nm().empty());
    EXPECT_TRUE(camera.is_measured(2));
    EXPECT_FALSE(camera.is_measured(3));
    EXPECT_FALSE(camera.assumed().empty());
    // S1/S0 and S2/S0 of the pixel (0, 0), by hand from the file: 0.281908, 0.102606.
    EXPECT_NEAR(ps::evaluate(camera, "dolp").value().values[0], std::hypot(0.281908, 0.102606), 1e-6);
    EXPECT_EQ(ps::evaluate(camera, "dop").value().states[0], ps::PixelState::not_measured);
    expect_error(camera.coherence(0, 0), ps::ErrorKind::usage, "wavelength");
}

TEST(FrontDoor, ReadsThePictureThatItWrote) {
    const ps::Picture picture = ps::render(small_plan("crossed-polarizers")).value().picture;
    const auto file = file_here("picture.exr");
    ASSERT_TRUE(ps::write_exr(picture, file));
    const ps::Picture again = ps::read_picture(file).value();
    EXPECT_EQ(again.wavelengths_nm(), picture.wavelengths_nm());
    EXPECT_EQ(again.bands(), picture.bands());
    EXPECT_TRUE(again.assumed().empty());
    EXPECT_TRUE(again.is_measured(3));
    EXPECT_FALSE(again.is_measured(4));
    EXPECT_FALSE(again.is_measured(0, 1));
    EXPECT_EQ(again.attributes().at("scene"), "crossed-polarizers.yaml");
    const std::vector<ps::Stokes> before = picture.plane().value();
    const std::vector<ps::Stokes> after = again.plane().value();
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(after[i].s0, static_cast<double>(static_cast<float>(before[i].s0)));
        EXPECT_EQ(after[i].s3, static_cast<double>(static_cast<float>(before[i].s3)));
    }
}

TEST(FrontDoor, RefusesPicturesThatAreNone) {
    const auto file = file_here("corrupt.exr");
    ASSERT_TRUE(ps::write_exr(ps::render(small_plan("cube-glass")).value().picture, file));
    std::string bytes;
    {
        std::ifstream in(file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    const auto read_of = [&file](const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
        return ps::read_picture(file);
    };
    ASSERT_TRUE(read_of(bytes));
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{4}, std::size_t{200}, bytes.size() / 2, bytes.size() - 1})
        expect_error(read_of(bytes.substr(0, length)), ps::ErrorKind::input);
    expect_error(read_of("no picture"), ps::ErrorKind::input);
    for (std::size_t at = 0; at < bytes.size(); at += 97) {  // broken somewhere: an error or other numbers, never more
        std::string broken = bytes;
        broken[at] = static_cast<char>(~broken[at]);
        static_cast<void>(read_of(broken));
    }
    expect_error(ps::read_picture("/no/such/picture.exr"), ps::ErrorKind::input);
    expect_error(ps::write_exr(ps::make_picture(1, 1, {580.0}, {{}}).value(), "/no/such/folder/a.exr"),
                 ps::ErrorKind::output);
    expect_error(ps::make_picture(0, 1, {580.0}, {}), ps::ErrorKind::usage, "width, height");
    expect_error(ps::make_picture(1, 1, {}, {}), ps::ErrorKind::usage, "wavelengths_nm");
    expect_error(ps::make_picture(1, 1, {nan}, {{}}), ps::ErrorKind::usage, "wavelengths_nm");
    expect_error(ps::make_picture(1, 1, {580.0, 580.0}, {{}, {}}), ps::ErrorKind::usage, "wavelengths_nm");
    expect_error(ps::make_picture(2, 2, {580.0}, {{}}), ps::ErrorKind::usage, "stokes");
}

TEST(FrontDoor, EvaluatesAndDrawsMaps) {
    const ps::Picture picture =
        ps::make_picture(2, 2, {580.0}, {{1.0, 0.6, 0.8, 0.0}, {2.0, 0.0, 0.0, -1.0}, {}, {1.0, nan, 0.0, 0.0}})
            .value();
    const ps::Map dop = ps::evaluate(picture, "dop").value();
    EXPECT_EQ(dop.wavelength_nm, 580.0);
    EXPECT_NEAR(dop.values[0], 1.0, 1e-15);
    EXPECT_NEAR(dop.values[1], 0.5, 1e-15);
    EXPECT_TRUE(std::isnan(dop.values[2]));
    EXPECT_EQ(dop.states, (std::vector<ps::PixelState>{ps::PixelState::defined, ps::PixelState::defined,
                                                       ps::PixelState::no_light, ps::PixelState::not_a_number}));
    EXPECT_NEAR(ps::evaluate(picture, "azimuth").value().values[0],
                0.5 * std::atan2(0.8, 0.6) * 180.0 / std::acos(-1.0), 1e-12);
    for (const ps::MapInfo& info : ps::maps()) {
        EXPECT_EQ(static_cast<bool>(ps::evaluate(picture, info.name)), info.name != "color") << info.name;
        for (const ps::MapStyle style : {ps::MapStyle::scientific, ps::MapStyle::paper, ps::MapStyle::wilkie}) {
            ps::DrawOptions options;
            options.style = style;
            options.caption = "four pixels";
            const auto drawn = ps::draw(picture, info.name, 0, options);
            ASSERT_TRUE(drawn) << info.name << ": " << to_string(drawn.error());
            EXPECT_GT(drawn.value().width, 2) << "enlarged, with a legend";
            options.legend = false;
            EXPECT_EQ(ps::draw(picture, info.name, 0, options).value().rgb.size(), 12U);
        }
    }
    EXPECT_TRUE(ps::write_png(ps::draw(picture, "dop").value(), file_here("dop.png")));

    const auto unknown = ps::evaluate(picture, "dopp");
    expect_error(unknown, ps::ErrorKind::usage, "map");
    EXPECT_EQ(unknown.error().hint, "did you mean 'dop'?");
    ps::DrawOptions flat;
    flat.low = flat.high = 1.0;
    expect_error(ps::draw(picture, "dop", 0, flat), ps::ErrorKind::usage, "options.low, options.high");
    flat.high.reset();
    expect_error(ps::draw(picture, "dop", 0, flat), ps::ErrorKind::usage, "options.low, options.high");
    ps::DrawOptions bright;
    bright.exposure = inf;
    expect_error(ps::draw(picture, "color", 0, bright), ps::ErrorKind::usage, "options.exposure");
    expect_error(ps::write_png({2, 2, {0, 0, 0}}, file_here("none.png")), ps::ErrorKind::usage, "picture");
    // Outside of the CIE tables.
    const ps::Picture infrared = ps::make_picture(1, 1, {10000.0}, {{1.0, 0.5, 0.0, 0.0}}).value();
    expect_error(ps::evaluate(infrared, "intensity"), ps::ErrorKind::input);
    EXPECT_TRUE(ps::draw(infrared, "dop"));
    static_cast<void>(ps::draw(infrared, "color"));
}

TEST(FrontDoor, KnowsItsAssetsAndTakesOthers) {
    const auto folder = ps::assets_folder();
    ASSERT_TRUE(folder) << to_string(folder.error());
    expect_error(ps::set_assets_folder("/no/such/folder"), ps::ErrorKind::usage, "folder");
    ASSERT_TRUE(ps::set_assets_folder(folder.value()));
    EXPECT_EQ(ps::assets_folder().value(), folder.value());
}

TEST(FrontDoor, AResultWithoutAValueThrowsOnlyIfItIsTakenForOne) {
    const ps::Result<int> none = ps::Error{ps::ErrorKind::usage, "nothing", "a.yaml", 3, 4, "field", "something"};
    EXPECT_THROW(static_cast<void>(none.value()), std::bad_variant_access);
    EXPECT_EQ(to_string(none.error()), "a.yaml:3:4: field: nothing\n  hint: something");
    const auto twice = [](int x) { return ps::Result<int>(2 * x); };
    EXPECT_FALSE(none.and_then(twice));
    EXPECT_EQ(ps::Result<int>(21).and_then(twice).value(), 42);
}

}  // namespace
