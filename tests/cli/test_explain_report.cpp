// SPDX-License-Identifier: Apache-2.0
// Light, frames and words of a tree as explain writes them: the same in text, JSON, CSV and OBJ, and right.
#include "report/explain_report.h"

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/ray_table.h"
#include "support/lit_trees.h"
#include "tracer/tree_names.h"

namespace pol::test {
namespace {

using Json = nlohmann::json;

DVec3 vec_of(const Json& j) {
    return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

using Row = std::map<std::string, std::string>;

/// Rows of a CSV file without quotes.
std::vector<Row> rows_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::vector<std::vector<std::string>> cells;
    for (std::string line; std::getline(lines, line);) {
        line.pop_back();  // CR
        std::istringstream fields(line);
        cells.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) cells.back().push_back(field);
        cells.back().resize(cells.front().size());
    }
    std::vector<Row> rows;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        rows.emplace_back();
        for (std::size_t c = 0; c < cells[i].size(); ++c) rows.back()[cells.front()[c]] = cells[i][c];
    }
    return rows;
}

DVec3 vec_of(const Row& row, const std::string& x, const std::string& y, const std::string& z) {
    return {std::stod(row.at(x)), std::stod(row.at(y)), std::stod(row.at(z))};
}

int handedness_of(const Stokes<double>& s) {
    return s.s3 > 1e-12 ? 1 : s.s3 < -1e-12 ? -1 : 0;
}

TEST(ExplainReport, JsonHasTheLightOfTheClosedFormInARightHandedFrame) {
    for_each_lit_branch([](const Plan& plan, const Explanation& e, int branch, const BranchLight& expected) {
        const Json node = Json::parse(explanation_as_json(plan, e)).at("nodes").at(static_cast<std::size_t>(branch));
        const DVec3 e1 = vec_of(node.at("frame").at("E1"));
        const DVec3 e2 = vec_of(node.at("frame").at("E2"));
        const DVec3 k = vec_of(node.at("frame").at("k"));
        EXPECT_EQ(k, -vec_of(node.at("ray")));
        EXPECT_NEAR(dot(cross(e1, e2), k), 1.0, lit_rounding);
        const Json& light = node.at("light");
        const Json& s = light.at("stokes");
        const Stokes<double> stokes{s[0], s[1], s[2], s[3]};
        expect_stokes(seen_from(stokes, e1, e2, expected.x), expected.light, lit_rounding);
        const Json& j = light.at("coherence");
        expect_stokes(to_stokes(CoherenceMatrix<double>{j.at("xx"), j.at("yy"), {j.at("xy")[0], j.at("xy")[1]}}),
                      stokes, eps);
        EXPECT_EQ(light.at("handedness"), handedness_of(expected.light));
        // M and the share belong to the same frames.
        Throughput<double> m;
        for (std::size_t row = 0; row < 2; ++row)
            for (std::size_t column = 0; column < node.at("matrix")[row].size(); ++column) {
                const Json& z = node.at("matrix")[row][column];
                m.m[row][column] = {z[0], z[1]};
            }
        const Json& share = node.at("share");
        expect_stokes(m.gather(to_coherence(stokes)), {share[0], share[1], share[2], share[3]}, lit_rounding);
    });
}

TEST(ExplainReport, CsvHasTheLightOfTheClosedFormInARightHandedFrame) {
    for_each_lit_branch([](const Plan& plan, const Explanation& e, int branch, const BranchLight& expected) {
        const Row row = rows_of(ray_table_as_csv(plan, e))[static_cast<std::size_t>(branch)];
        const DVec3 e1 = vec_of(row, "E1_x", "E1_y", "E1_z");
        const DVec3 e2 = vec_of(row, "E2_x", "E2_y", "E2_z");
        EXPECT_NEAR(dot(cross(e1, e2), -vec_of(row, "L", "M", "N")), 1.0, lit_rounding);
        const auto number = [&](const std::string& name) { return std::stod(row.at(name)); };
        const Stokes<double> light{number("light_S0"), number("light_S1"), number("light_S2"), number("light_S3")};
        expect_stokes(seen_from(light, e1, e2, expected.x), expected.light, lit_rounding);
        Throughput<double> m;
        m.m[0][0] = {number("M_x1_re"), number("M_x1_im")};
        m.m[1][0] = {number("M_y1_re"), number("M_y1_im")};
        if (!row.at("M_x2_re").empty()) {
            m.m[0][1] = {number("M_x2_re"), number("M_x2_im")};
            m.m[1][1] = {number("M_y2_re"), number("M_y2_im")};
        }
        expect_stokes(m.gather(to_coherence(light)),
                      {number("share_S0"), number("share_S1"), number("share_S2"), number("share_S3")}, lit_rounding);
    });
}

// The text has six digits of numbers and nine decimals of directions.
TEST(ExplainReport, TextHasTheLightOfTheClosedFormInARightHandedFrame) {
    const double six_digits = 4.0 * printed(6);
    for_each_lit_branch([&](const Plan& plan, const Explanation& e, int branch, const BranchLight& expected) {
        const std::string text = explanation_as_text(plan, e, 0.0);
        const std::size_t at = text.find("#" + std::to_string(branch) + " ");
        ASSERT_NE(at, std::string::npos);
        const auto after = [&](const char* what) {
            const std::size_t found = text.find(what, at);
            return found == std::string::npos ? "" : text.c_str() + found + std::char_traits<char>::length(what);
        };
        const auto vec_after = [&](const char* what) {
            DVec3 v(0.0);
            EXPECT_EQ(std::sscanf(after(what), "(%lf, %lf, %lf)", &v.x, &v.y, &v.z), 3) << text;
            return v;
        };
        const DVec3 e1 = vec_after("   E1 ");
        const DVec3 e2 = vec_after("  E2 ");
        EXPECT_NEAR(dot(cross(e1, e2), -vec_after("   ray ")), 1.0, six_digits);
        Stokes<double> s;
        char word[16] = "";
        double j[6] = {};
        ASSERT_EQ(std::sscanf(after("light S "), "(%lf, %lf, %lf, %lf) J [[%lf, %lf%lfi], [%lf%lfi, %lf]] %15s", &s.s0,
                              &s.s1, &s.s2, &s.s3, &j[0], &j[1], &j[2], &j[3], &j[4], &j[5], word),
                  11)
            << text;
        expect_stokes(seen_from(s, e1, e2, expected.x), expected.light, six_digits);
        expect_stokes(to_stokes(CoherenceMatrix<double>{j[0], j[5], {j[1], j[2]}}), s, six_digits);
        const int hand = handedness_of(expected.light);
        const bool is_polarized = polarized_part(expected.light) > 1e-12;
        EXPECT_STREQ(word, hand > 0                    ? "right"
                           : hand < 0                  ? "left"
                           : is_polarized              ? "linear"
                           : expected.light.s0 > 1e-12 ? "unpolarized"
                                                       : "none");
    });
}

/// A tree with every interaction: behind a sheet a prism that reflects totally, in a bright room.
const std::string all_interactions = verify::camera_in_plane({1.0, 0.0, 0.0}, {0.0, 0.5, 0.0}) +
                                     "render: {depth: 4, residual: 0}\nbackground: 1\nmedia: {glass: 1.5}\nobjects:\n" +
                                     extruded("prism", {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, "glass") +
                                     "  - {name: sheet, shape: {rectangle: {size: 2}}, " +
                                     placed({-1.0, 0.5, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}) +
                                     ", sheet: {polarizer: {axis: [1, 0, 0]}}}\n";

TEST(ExplainReport, OneThingHasOneWordInTextJsonCsvAndObj) {
    Scene scene = scene_of(all_interactions);
    scene.render.width = scene.render.height = 1;
    const auto plan = plan_of(scene);
    const Explanation e = explain(*plan, 0, 0, 0, 0);
    const std::map<std::string, std::string> interactions{
        {"", "camera"},          {"S", "through sheet"},         {"S T", "transmitted"},
        {"S R", "reflected"},    {"S T R", "totally reflected"}, {"S T R T", "transmitted"},
        {"S T R R", "reflected"}};
    const std::map<std::string, std::string> ends{{"S T R T", "background"}, {"S T R R", "depth limit"}};
    const std::string text = explanation_as_text(*plan, e, 0.0);
    const Json nodes = Json::parse(explanation_as_json(*plan, e)).at("nodes");
    const std::vector<Row> rows = rows_of(ray_table_as_csv(*plan, e));
    const std::string obj = paths_as_obj(*plan, e);
    for (const auto& [route, word] : interactions) {
        const auto branch_index = static_cast<std::size_t>(&branch(e, route) - e.tree.nodes.data());
        const std::string head = "#" + std::to_string(branch_index) + " ";
        EXPECT_NE(text.find(head + word + " in "), std::string::npos) << word << "\n" << text;
        EXPECT_EQ(nodes[branch_index].at("interaction"), word);
        EXPECT_EQ(rows[branch_index].at("interaction"), word);
    }
    for (const auto& [route, word] : ends) {
        const auto branch_index = static_cast<std::size_t>(&branch(e, route) - e.tree.nodes.data());
        EXPECT_NE(text.find("ends: " + word + " (", text.find("#" + std::to_string(branch_index) + " ")),
                  std::string::npos);
        EXPECT_EQ(nodes[branch_index].at("ended"), word);
        EXPECT_EQ(rows[branch_index].at("ended"), word);
    }
    for (const char* group : {"camera", "reflected", "transmitted", "through_sheet", "not_followed"})
        EXPECT_NE(obj.find(std::string("\ng ") + group + "\n"), std::string::npos) << obj;
}

}  // namespace
}  // namespace pol::test
