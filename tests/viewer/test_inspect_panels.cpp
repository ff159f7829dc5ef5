// SPDX-License-Identifier: Apache-2.0
// The panels of a pixel as text, without GL: they say what explain says.
#include <gtest/gtest.h>
#include <imgui.h>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>

#include "report/ray_table.h"
#include "support/sanitizers.h"
#include "support/shipped_scenes.h"
#include "verify/facts/pixel_case.h"
#include "viewer/known_picture.h"
#include "viewer/pages/pixel_page.h"
#include "viewer/pages/readout_text.h"
#include "viewer/panels/paths_panel.h"
#include "viewer/panels/pixel_panel.h"
#include "viewer/panels/ray_table_panel.h"
#include "viewer/panels/status_line.h"
#include "viewer/session/pixel_export.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Panels : public testing::Test {
protected:
    Panels() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as OpenGL 3.3 has: large lists
        io.DisplaySize = {400.0F, 2000.0F};
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~Panels() override { ImGui::DestroyContext(); }

    /// A frame as the user has it; ImGui draws all rows of a list, seen or not, while it writes a text log.
    template <class Panel>
    void draw_frame(Panel& panel) {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("panel");
        Wishes wishes;
        panel.draw(session, wishes);
        ImGui::End();
        ImGui::Render();
        wishes.fulfil(session);
    }

    /// CPU time of this thread for a frame, the median of nine: a busy machine does not count.
    template <class Panel>
    double frame_seconds(Panel& panel) {
        std::vector<double> costs;
        for (int i = 0; i < 9; ++i) {
            const double start = thread_seconds();
            draw_frame(panel);
            costs.push_back(thread_seconds() - start);
        }
        std::nth_element(costs.begin(), costs.begin() + 4, costs.end());
        return costs[4];
    }

    /// What the panel shows in its third frame, as text; the first ones find out sizes.
    template <class Panel>
    std::string shown(Panel& panel) {
        std::string text;
        for (int i = 0; i < 3; ++i) {
            ImGui::NewFrame();
            ImGui::SetNextWindowPos({0.0F, 0.0F});
            ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
            ImGui::Begin("panel");
            ImGui::LogToClipboard(0);
            Wishes wishes;
            panel.draw(session, wishes);
            ImGui::LogFinish();
            text = ImGui::GetClipboardText();
            ImGui::End();
            ImGui::Render();
            wishes.fulfil(session);
        }
        return text;
    }

    /// Renders a scene to its end and explains one pixel of it.
    void pin_in(Scene scene, PixelAddress pixel) {
        ASSERT_TRUE(session.open_scene(std::move(scene), "test"));
        test::finish(*session.current());
        session.pin(pixel);
        for (int i = 0; i < 5000 && !session.explanation(); ++i) {
            session.update();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        ASSERT_NE(session.explanation(), nullptr) << session.explanation_status().problem;
    }

    Session session;
};

void expect_says(const std::string& text, const std::string& what) {
    EXPECT_NE(text.find(what), std::string::npos) << "no '" << what << "' in\n" << text;
}

// Linear light made circular, with the light that goes to and fro between the end faces: each round trip through the
// rhomb adds half a wave, hence the signs of the two geometric series.
TEST_F(Panels, TheRhombsPixelIsThatOfExplain) {
    pin_in(test::small(test::shipped_scene("fresnel-rhomb"), 16), {8, 8});
    const Explanation& e = *session.explanation();
    ASSERT_TRUE(e.exact());
    PixelPanel panel;
    const std::string text = shown(panel);
    const Measures<double> m = measure(e.sample_light);
    expect_says(text, m.handedness > 0 ? "right" : "left");
    expect_says(text, "receiver's view");
    const double r = std::pow((1.51 - 1.0) / (1.51 + 1.0), 2);
    EXPECT_NEAR(e.sample_light.s0, (1.0 - r) * (1.0 - r) / (1.0 - r * r), 5e-6);
    EXPECT_NEAR(std::abs(e.sample_light.s3), (1.0 - r) * (1.0 - r) / (1.0 + r * r), 5e-6);

    const PixelPage page = make_pixel_page(session);
    for (const PageGroup& group : page.groups) {
        if (group.title == "Coherence matrix") continue;  // drawn as a matrix, its bars are in the tooltips
        for (const PageRow& row : group.rows) {
            expect_says(text, row.value);
            expect_says(text, row.bar);
        }
    }
    const MatrixTexts& matrix = page.matrix_texts;
    for (const std::string& entry : {matrix.xx, matrix.xy, matrix.yx, matrix.yy}) expect_says(text, entry);
    EXPECT_EQ(matrix.xy.substr(0, 4), "0 - ") << "Re J_xy of circular light is 0 beside what is missing: " << matrix.xy;
    EXPECT_EQ(page.stokes, e.sample_light) << "one sample: the picture is the explanation, bit for bit";
    EXPECT_EQ(page.matrix, to_coherence(e.sample_light));
    const std::string copied = text_of(page);
    for (const double value : {page.matrix.xx, page.matrix.xy.re, page.matrix.xy.im, page.stokes.s3, m.dop})
        expect_says(copied, fmt::format("{:.17g}", value));
}

// Random tails scatter, and one of them per pixel tells nothing of it; glass at the pixel centres has none.
TEST_F(Panels, TheStatusLineSaysWhatIsKnownOfTheSamplingError) {
    struct Line {
        static void draw(const Session& session, Wishes& wishes) { draw_status_line(session, wishes); }
    } line;
    Scene calcite = test::small(test::shipped_scene("cube-calcite"), 8);
    pin_in(calcite, {4, 4});
    expect_says(shown(line), "sampling not estimated");
    pin_in(test::small(test::shipped_scene("cube-glass"), 8), {4, 4});
    expect_says(shown(line), "no sampling error");
    calcite.render.mode = SampleMode::area;
    pin_in(calcite, {4, 4});
    expect_says(shown(line), "sampling not estimated");
    calcite.render.samples_per_pixel = 2;
    pin_in(calcite, {4, 4});
    expect_says(shown(line), "(estimated, 68 %)");
}

TEST_F(Panels, FrameAndConventionRelabelEverything) {
    pin_in(test::small(test::shipped_scene("fresnel-rhomb"), 16), {8, 8});
    const PixelPage before = make_pixel_page(session);
    session.change_view().convention.viewpoint = Viewpoint::source;
    const PixelPage source = make_pixel_page(session);
    EXPECT_EQ(source.stokes.s2, -before.stokes.s2);
    EXPECT_EQ(source.stokes.s3, -before.stokes.s3);
    EXPECT_EQ(source.measures.handedness, -before.measures.handedness);
    EXPECT_EQ(source.seen.handedness, -before.seen.handedness);
    PixelPanel panel;
    expect_says(shown(panel), "source's view");

    session.change_view().convention = {};
    session.set_page({FrameChoice::own_angle, 0.3});
    const PixelPage turned = make_pixel_page(session);
    const auto expected = rotate_basis(before.stokes, 0.3);
    EXPECT_EQ(turned.stokes, expected);
    EXPECT_EQ(turned.measures.dop, measure(expected).dop);
    session.set_page({FrameChoice::scene_x});  // the rhomb's camera looks along the x axis
    expect_says(make_pixel_page(session).trouble, "along the ray");
    session.set_page({FrameChoice::scene_z});  // up in the picture: x lies along the camera's y
    const PixelPage z = make_pixel_page(session);
    EXPECT_NEAR(z.stokes.s1, -before.stokes.s1, 1e-12);
    expect_says(z.groups[1].rows[0].exact, ", 1)");
}

// S0 of 0.5, P = 1, a quarter of the lamp's 0.5 missing: P may be as low as (0.5 - 0.125)/0.625, never above 1. The
// handedness of linear light with some light missing is not known.
TEST_F(Panels, BarsAreIntervalsThatNoTruthLeaves) {
    StokesImage image = known_picture();
    image.brightest = {0.5, 0.5};
    image.stokes.assign(image.stokes.size(), {0.5, 0.5, 0.0, 0.0});
    image.residual.assign(image.residual.size(), 0.25);
    open_picture(session, image);
    session.pin({5, 8});
    session.update();
    const PixelPage page = make_pixel_page(session);
    const auto row = [&](const std::string& name) {
        for (const PageGroup& group : page.groups)
            for (const PageRow& r : group.rows)
                if (r.name == name) return r;
        ADD_FAILURE() << name;
        return PageRow{};
    };
    EXPECT_EQ(row("DoP").value, "1");
    EXPECT_EQ(row("DoP").bar, "[0.6, 1]");
    EXPECT_EQ(row("DoP").exact, "1");
    expect_says(row("DoP").exact_bar, "[0.59999999999999998, 1]");
    EXPECT_EQ(row("S0").bar, "[0.5, 0.625]") << "light can only be missing";
    EXPECT_EQ(row("Jyy").bar, "[0, 0.125]");
    EXPECT_EQ(row("unpolarized").bar, "[0, 0.25]");
    EXPECT_EQ(row("eigenvalue 1").bar, "[0.5, 0.625]");
    EXPECT_EQ(row("S2").value, "0");
    EXPECT_EQ(row("S2").bar, "\u00b1 0.13") << "0.125, rounded outwards";
    EXPECT_EQ(row("handedness").value, "not determined");
    EXPECT_EQ(row("handedness").exact, "");
    const std::string copied = text_of(page);
    expect_says(copied, row("DoP").exact_bar);
    expect_says(copied, "receiver's view, S3 > 0 right");
}

// Panels of the tree stay in the tracer's convention; where that is not the shown one, they say so.
TEST_F(Panels, PanelsOfTheTreeSayThatTheyKeepTheTracersConvention) {
    pin_in(test::small(test::shipped_scene("cube-calcite"), 32), {16, 14});
    session.select_branch(1);
    PathsPanel paths;
    RayTablePanel table;
    const std::string note = "tracer's convention: receiver's view, S3 > 0 right, exp(-i";
    EXPECT_EQ(shown(paths).find(note), std::string::npos);
    for (const Convention& other : {Convention{Viewpoint::source, {}, {}}, Convention{{}, PositiveS3::left, {}},
                                    Convention{{}, {}, TimeSign::plus}}) {
        session.change_view().convention = other;
        expect_says(shown(paths), note);
        expect_says(shown(table), note);
    }
}

TEST_F(Panels, ABlackPixelHasNoLightAndNoDirection) {
    Scene scene = test::scene_of(test::plate_scene(8, 8));
    for (Object& object : scene.objects)
        if (std::holds_alternative<Emission>(object.role)) object.role = Absorber{};
    pin_in(std::move(scene), {4, 4});
    PixelPanel panel;
    const std::string text = shown(panel);
    expect_says(text, "no light");
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    PathsPanel paths;
    expect_says(shown(paths), "agree to the last bit");
}

TEST_F(Panels, ANanInAFileIsCalledOne) {
    StokesImage image = known_picture();
    image.stokes[image.pixel(3, 4)].s1 = std::numeric_limits<double>::quiet_NaN();
    open_picture(session, image);
    session.pin({3, 4});
    session.update();
    PixelPanel panel;
    const std::string text = shown(panel);
    expect_says(text, "not a number");
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST_F(Panels, APictureWithoutASceneSaysSo) {
    open_picture(session, known_picture());
    session.pin({5, 8});
    session.update();
    PixelPanel pixel;
    const std::string text = shown(pixel);
    expect_says(text, "image right");
    const StokesImage& picture = session.current()->picture();
    const Stokes<double> s = picture.at(0, picture.pixel(5, 8));
    expect_says(text, fmt::format("{:.3f}", s.s2));  // 0.01 is missing: \u00b1 0.01
    expect_says(text, "\u00b1 ");                    // the file has a residual
    expect_says(text, "Over wavelength");
    PathsPanel paths;
    expect_says(shown(paths), "no scene to trace");
    RayTablePanel rays;
    expect_says(shown(rays), "no scene to trace");
    session.set_page({FrameChoice::scene_z});
    expect_says(make_pixel_page(session).trouble, "no scene axes");
}

TEST_F(Panels, PathsAndTableShowTheNumbersOfTheTree) {
    pin_in(test::small(test::shipped_scene("cube-calcite"), 32), {16, 14});
    const Explanation& e = *session.explanation();
    PathsPanel paths;
    session.select_branch(1);
    std::string text = shown(paths);
    expect_says(text, fmt::format("{:.17g}", e.leaf_sum.s0));
    expect_says(text, fmt::format("of {} leaves", e.tree.leaves.size()));
    expect_says(text, "Branch 1");
    const RayTreeNode& node = e.tree.nodes[1];
    expect_says(text, short_number(node.start.weight, 9));
    expect_says(text, complex_text(node.start.throughput.m[0][0]));

    RayTablePanel table;
    ImGui::GetIO().DisplaySize = {4000.0F, 2000.0F};
    text = shown(table);
    const RayTable rays(*session.current()->plan(), e);
    for (const RayTable::Column& column : RayTable::columns()) {
        expect_says(text, std::string(column.name));
        if (column.number != nullptr)
            if (const auto value = column.number(rays, 2)) expect_says(text, short_number(*value, 7));
    }
}

TEST_F(Panels, ExportsAndCasesGoWhereAllExportsGo) {
    const test::WorkingFolder folder;
    test::write_text(folder / "tip.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8) +
                                                "  - {name: tip, shape: {mesh: {file: tip.obj}}, "
                                                "transform: [{translate: [0, 0, -8]}], medium: glass}\n");
    ASSERT_TRUE(session.open(folder / "plate.yaml"));
    session.pin({4, 4});
    for (int i = 0; i < 5000 && !session.explanation(); ++i) {
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_NE(session.explanation(), nullptr);
    for (const RayFormat format : {RayFormat::csv, RayFormat::json, RayFormat::obj}) export_rays(session, format);
    save_pixel_case(session);
    save_pixel_case(session);
    for (int i = 0; i < 5000 && !session.exports().idle(); ++i) {
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    for (const char* name :
         {"plate-4,4.csv", "plate-4,4.json", "plate-4,4.obj", "plate-4,4.case.yaml", "plate-4,4-2.case.yaml"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    const auto saved = load_pixel_case(folder / "plate-4,4.case.yaml");
    ASSERT_TRUE(saved) << to_string(saved.error());
    EXPECT_EQ(saved.value().expected, to_coherence(session.explanation()->sample_light));
    std::ifstream file(folder / "plate-4,4.case.yaml");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_NE(text.find("{file: \"tip.obj\"}"), std::string::npos) << "named as seen from the folder of the case\n"
                                                                   << text;
    const auto verdict = check(saved.value());
    ASSERT_TRUE(verdict);
    EXPECT_TRUE(verdict.value().computed == saved.value().expected) << "equal bits after a way through a file";
}

// 1e5 branches, everything open: a frame may take 20 ms. CPU time of this thread, so that a busy machine does not
// count.
TEST_F(Panels, DrawATreeOfAHundredThousandBranches) {
    Scene scene = test::small(test::shipped_scene("cube-calcite"), 16);
    scene.render.residual = 0.0;
    scene.render.node_budget = 500;  // the render; the pinned tree gets its own plan below
    pin_in(scene, {8, 7});
    scene.render.node_budget = 60'000;
    ASSERT_TRUE(session.current()->edit(scene, "node budget"));
    session.current()->set_paused(true);
    for (int i = 0; i < 5000 && !session.explanation(); ++i) {
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_NE(session.explanation(), nullptr);
    const std::size_t branches = session.explanation()->tree.nodes.size();
    ASSERT_GT(branches, 100'000U);

    PathList list;
    double start = thread_seconds();
    list.set_tree(session.current()->plan(), session.explanation());
    const double facts = thread_seconds() - start;
    start = thread_seconds();
    list.open_all(true);
    EXPECT_EQ(list.rows().size(), branches);
    const double rows = thread_seconds() - start;

    ImGui::GetIO().DisplaySize = {400.0F, 900.0F};
    PathsPanel paths;
    RayTablePanel table;
    draw_frame(paths);
    draw_frame(table);
    session.select_branch(session.explanation()->tree.leaves.back());
    const double paths_frame = frame_seconds(paths);
    const double table_frame = frame_seconds(table);
    std::printf("%zu branches: list %.1f ms, all rows %.1f ms; a frame of paths %.2f ms, of the table %.2f ms\n",
                branches, 1e3 * facts, 1e3 * rows, 1e3 * paths_frame, 1e3 * table_frame);
    EXPECT_LT(rows, 0.1 * test::slowdown);
    EXPECT_LT(paths_frame, 0.02 * test::slowdown);
    EXPECT_LT(table_frame, 0.02 * test::slowdown);
}

}  // namespace
}  // namespace pol
