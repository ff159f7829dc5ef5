// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/units.h"
#include "geometry/geometry_helpers.h"

namespace pol {
namespace {

using Outline = std::vector<DVec2>;

double cross2(const DVec2& u, const DVec2& v) {
    return u.x * v.y - u.y * v.x;
}

/// Gauss's area formula, positive counter-clockwise.
double shoelace(const Outline& outline) {
    double sum = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) sum += cross2(outline[i], outline[(i + 1) % outline.size()]);
    return 0.5 * sum;
}

/// Whether a ray from `p` to the right crosses the outline an odd number of times.
bool is_inside(const Outline& outline, const DVec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const DVec2& a = outline[i];
        const DVec2& b = outline[(i + 1) % outline.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

/// A plane in space: where a point of the polygon's own plane lies.
struct Placement {
    DVec3 origin{0.0}, x{1, 0, 0}, y{0, 1, 0};
    DVec3 operator()(const DVec2& p) const { return origin + p.x * x + p.y * y; }
};

Placement tilted(test::Dice& dice) {
    const DVec3 x = dice.direction();
    return {3.0 * dice.direction(), x, cross(any_perpendicular(x), x)};
}

std::vector<DVec3> placed(const Outline& outline, const Placement& place = {}) {
    std::vector<DVec3> corners;
    for (const DVec2& p : outline) corners.push_back(place(p));
    return corners;
}

std::string complaint(const std::vector<DVec3>& corners) {
    const auto cut = cut_polygon(corners);
    return cut ? "" : cut.error().what;
}

/// Each point of the inside lies in one triangle, no other point in any: tried at random points of the bounding box and
/// by the sum of the areas. All triangles wind as the outline does.
void expect_filled(const Outline& outline, const Placement& place, test::Dice& dice) {
    const auto cut = cut_polygon(placed(outline, place));
    ASSERT_TRUE(cut) << cut.error().what;
    EXPECT_EQ(cut.value().size(), outline.size() - 2);
    const double sense = shoelace(outline) < 0.0 ? -1.0 : 1.0;
    double sum = 0.0;
    for (const auto& [a, b, c] : cut.value()) {
        const double area = 0.5 * cross2(outline[b] - outline[a], outline[c] - outline[a]);
        EXPECT_GT(sense * area, 0.0);
        sum += std::abs(area);
    }
    // Each of the fewer than 100 terms is below 10 and rounded a few times: 100 * 10 * 1e-16 * 5.
    EXPECT_NEAR(sum, std::abs(shoelace(outline)), 5e-13);
    DVec2 low = outline[0];
    DVec2 high = outline[0];
    for (const DVec2& p : outline) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    for (int trial = 0; trial < 50; ++trial) {
        const DVec2 p = low + DVec2(dice.next(), dice.next()) * (high - low);
        int covered = 0;
        for (const auto& [a, b, c] : cut.value()) covered += is_inside({outline[a], outline[b], outline[c]}, p) ? 1 : 0;
        EXPECT_EQ(covered, is_inside(outline, p) ? 1 : 0);
    }
}

const Outline letter_u{{0, 0}, {3, 0}, {3, 2.1}, {2, 2}, {2.1, 1}, {0.9, 1.1}, {1, 2.2}, {0.1, 2}};
const Outline plus_sign{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};

/// `count` teeth, each half a unit wide and 1 high, on a bar 1 high: area 3 count / 2.
Outline comb(int count) {
    Outline outline{{0, 0}, {count, 0}};
    for (int tooth = count - 1; tooth >= 0; --tooth) {
        const double x = tooth;
        outline.insert(outline.end(), {{x + 1.0, 1}, {x + 0.75, 2}, {x + 0.25, 2}});
    }
    outline.emplace_back(0, 1);
    outline.erase(outline.begin() + 2);
    outline.insert(outline.begin() + 2, DVec2(count, 1));
    return outline;
}

/// Two turns of a band that is half as wide as the gap to its next turn.
Outline spiral() {
    Outline outline;
    const auto at = [](double turns, double radius) {
        return DVec2(radius * std::cos(2.0 * pi * turns), radius * std::sin(2.0 * pi * turns));
    };
    for (int i = 0; i <= 40; ++i) outline.push_back(at(i / 20.0, 1.3 + i / 20.0));
    for (int i = 40; i >= 0; --i) outline.push_back(at(i / 20.0, 1.0 + i / 20.0));
    return outline;
}

bool cross_each_other(const DVec2& a, const DVec2& b, const DVec2& c, const DVec2& d) {
    return cross2(b - a, c - a) * cross2(b - a, d - a) < 0.0 && cross2(d - c, a - c) * cross2(d - c, b - c) < 0.0;
}

/// Random corners; where two sides cross, what lies between them is run through the other way, which shortens the
/// outline until none cross.
Outline tangle_undone(int count, test::Dice& dice) {
    Outline outline;
    for (int i = 0; i < count; ++i) outline.emplace_back(dice.next(), dice.next());
    for (bool again = true; again;) {
        again = false;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            for (std::size_t j = i + 2; j < outline.size(); ++j) {
                const DVec2& next = outline[(j + 1) % outline.size()];
                if (!cross_each_other(outline[i], outline[i + 1], outline[j], next)) continue;
                std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             outline.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                again = true;
            }
        }
    }
    return outline;
}

TEST(PolygonCut, FillsALetterUAPlusACombAndASpiralToTheirOutlineInAnyPlane) {
    EXPECT_NEAR(shoelace(letter_u), 4.985, 1e-14);
    EXPECT_EQ(shoelace(plus_sign), 5.0);
    EXPECT_EQ(shoelace(comb(20)), 1.0 * 20 + 0.75 * 20);
    test::Dice dice = test::dice(31);
    for (Outline outline : {letter_u, plus_sign, comb(20), spiral()}) {
        for (const bool turned : {false, true}) {
            if (turned) std::reverse(outline.begin(), outline.end());
            for (std::size_t first = 0; first < outline.size(); first += 3) {
                std::rotate(outline.begin(), outline.begin() + 1, outline.end());
                expect_filled(outline, {}, dice);
                expect_filled(outline, tilted(dice), dice);
            }
        }
    }
}

TEST(PolygonCut, FillsAnySimplePolygonToItsOutline) {
    test::Dice dice = test::dice(32);
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE(trial);
        expect_filled(tangle_undone(4 + trial % 37, dice), tilted(dice), dice);
    }
}

// The least height of any triangle would be 0, or a rounding, if a side's own corners made one.
TEST(PolygonCut, CornersInTheMiddleOfSidesMakeNoEmptyTriangles) {
    test::Dice dice = test::dice(33);
    for (const Outline& corners :
         {Outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Outline{{0, 0}, {3, 0}, {1, 2}}, plus_sign, letter_u}) {
        for (int parts = 2; parts <= 5; ++parts) {
            Outline outline;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                for (int k = 0; k < parts; ++k)
                    outline.push_back(glm::mix(corners[i], corners[(i + 1) % corners.size()], DVec2(1.0 * k / parts)));
            }
            const Placement place = tilted(dice);
            expect_filled(outline, place, dice);
            const auto cut = cut_polygon(placed(outline, place));
            ASSERT_TRUE(cut);
            double least = HUGE_VAL;
            for (const auto& [a, b, c] : cut.value()) {
                const double longest =
                    std::max({glm::distance(outline[a], outline[b]), glm::distance(outline[b], outline[c]),
                              glm::distance(outline[c], outline[a])});
                least = std::min(least, std::abs(cross2(outline[b] - outline[a], outline[c] - outline[a])) / longest);
            }
            EXPECT_GT(least, 0.01);
        }
    }
}

TEST(PolygonCut, ACornerAtThePlaceOfAnotherIsLeftOut) {
    const auto cut = cut_polygon(placed({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().size(), 2U);
    // A quadrilateral at the pole of a sphere, whose last two corners differ by what the sine of pi is off zero.
    for (const double off : {0.0, 1.2e-16}) {
        const auto pole = cut_polygon(placed({{0, 0}, {1, 0}, {0, 1}, {off, 1}}));
        ASSERT_TRUE(pole);
        EXPECT_EQ(pole.value().size(), 1U);
    }
}

TEST(PolygonCut, RefusesByNameWhatHasNoSingleInside) {
    test::Dice dice = test::dice(34);
    const auto expect = [&](const Outline& outline, const std::string& what) {
        for (const Placement& place : {Placement{}, tilted(dice)}) {
            const std::string text = complaint(placed(outline, place));
            EXPECT_NE(text.find(what), std::string::npos) << "'" << text << "' instead of '" << what << "'";
        }
    };
    expect({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "crosses itself");  // its area formula gives 0
    expect({{0, 0}, {3, 3}, {3, 0}, {0, 1}}, "crosses itself");  // and here another number than 0
    Outline pentagram;                                           // runs round twice, all corners turn left
    for (int i = 0; i < 5; ++i) pentagram.emplace_back(std::cos(0.8 * pi * i), std::sin(0.8 * pi * i));
    expect(pentagram, "crosses itself");
    // A band that overlaps itself: each corner turns as a simple outline's would, and the triangles add up.
    expect({{0, 0}, {5, 0}, {5, 5}, {-2, 5}, {-2, 1}, {3, 1}, {3, 2}, {-1, 2}, {-1, 4}, {4, 4}, {4, -1}, {0, -1}},
           "crosses itself");
    // A square with a square hole, which a cut that is run along twice leads to.
    expect({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}, "a face with a hole");
    expect({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}, "touches itself");  // two triangles at a point
    // A corner on a side: in a tilted plane, rounding puts it on either side of it.
    EXPECT_NE(complaint(placed({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})).find("touches itself"), std::string::npos);
    expect({{0, 0}, {1, 0}, {1, 1}, {1, 3}, {1, 1}, {0, 1}}, "along its own side");
    expect({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, "in one line");
    expect({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, "in one line");
    EXPECT_EQ(complaint(placed(Outline(10'001))), "has all its corners in one line");
    Outline circle;
    for (int i = 0; i < 10'001; ++i)
        circle.emplace_back(std::cos(2.0 * pi * i / 10'001), std::sin(2.0 * pi * i / 10'001));
    EXPECT_EQ(complaint(placed(circle)), "has more than 10000 corners");
    EXPECT_NE(complaint({{0, 0, 0}, {1e200, 0, 0}, {1e200, 1e200, 0}, {0, 1e200, 0}}).find("too large"),
              std::string::npos);
}

// One corner of a unit square raised by h: best plane off by a quarter of h at least.
TEST(PolygonCut, RefusesFacesThatAreNotFlatButNotWhatRoundingBends) {
    const auto raised = [](double h) { return std::vector<DVec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}}; };
    EXPECT_EQ(complaint(raised(1e-6)), "");
    EXPECT_NE(complaint(raised(0.01)).find("is not flat: its corners lie up to 0.00"), std::string::npos);
    // Long and thin: the bend is measured against the width, which is what turns the normals.
    EXPECT_NE(complaint({{0, 0, 0}, {100, 0, 0}, {100, 0.1, 0.01}, {0, 0.1, 0}}).find("is not flat"),
              std::string::npos);
    // Next to the pole of a tilted unit sphere of 1024 x 512 faces, in coordinates of six decimals: 4e-5 wide.
    test::Dice dice = test::dice(35);
    const Placement sphere = tilted(dice);
    for (int face = 0; face < 1024; ++face) {
        std::vector<DVec3> corners;
        for (const auto& [i, j] : {std::pair{1, 0}, {2, 0}, {2, 1}, {1, 1}}) {
            const double polar = pi * i / 512;
            const double azimuth = 2.0 * pi * (face + j) / 1024;
            const DVec3 p = std::sin(polar) * (std::cos(azimuth) * sphere.x + std::sin(azimuth) * sphere.y) +
                            std::cos(polar) * cross(sphere.x, sphere.y);
            corners.push_back(glm::round(p * 1e6) / 1e6);
        }
        EXPECT_EQ(complaint(corners), "");
    }
    // Digits far from the origin explain no bend that can be seen.
    EXPECT_NE(complaint({{1e6, 0, 0}, {1e6, 1, 0}, {1e6 + 0.1, 1, 1}, {1e6, 0, 1}}).find("is not flat"),
              std::string::npos);
    // A facet in any direction, 3 wide in single precision, and 0.003 wide in coordinates of six decimals.
    for (int trial = 0; trial < 100; ++trial) {
        Placement place = tilted(dice);
        std::vector<DVec3> rounded = placed(letter_u, place);
        for (DVec3& p : rounded) p = DVec3(glm::vec3(p));
        EXPECT_EQ(complaint(rounded), "");
        Outline small = letter_u;
        for (DVec2& p : small) p *= 1e-3;
        rounded = placed(small, place);
        for (DVec3& p : rounded) p = glm::round(p * 1e6) / 1e6;
        EXPECT_EQ(complaint(rounded), "");
    }
}

}  // namespace
}  // namespace pol
