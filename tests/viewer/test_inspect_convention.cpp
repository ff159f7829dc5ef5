// SPDX-License-Identifier: Apache-2.0
// Labels of the same light in other conventions, against the field itself as it moves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/units.h"
#include "polarization/measures.h"
#include "viewer/shown/convention.h"

namespace pol {
namespace {

/// The field at time t as somebody sees it, x to the right and y up.
DVec2 field(const JonesVector<double>& e, double t, Viewpoint viewpoint) {
    // Re[E exp(-i omega t)], the engine's own sign.
    const double x = e.x.re * std::cos(t) + e.x.im * std::sin(t);
    const double y = e.y.re * std::cos(t) + e.y.im * std::sin(t);
    return {viewpoint == Viewpoint::source ? -x : x, y};
}

/// Direction of the major axis, and +1 if the field turns clockwise.
std::pair<double, int> watched(const JonesVector<double>& e, Viewpoint viewpoint) {
    double longest = 0.0;
    double azimuth = 0.0;
    for (int i = 0; i < 7200; ++i) {
        const DVec2 at = field(e, 2.0 * pi * i / 7200.0, viewpoint);
        if (const double length = std::hypot(at.x, at.y); length > longest) {
            longest = length;
            azimuth = std::atan2(at.y, at.x);
        }
    }
    const DVec2 now = field(e, 0.3, viewpoint);
    const DVec2 later = field(e, 0.3001, viewpoint);
    return {azimuth, now.x * later.y - now.y * later.x < 0.0 ? 1 : -1};
}

std::vector<Convention> all_conventions() {
    std::vector<Convention> all;
    for (const Viewpoint v : {Viewpoint::receiver, Viewpoint::source})
        for (const PositiveS3 s : {PositiveS3::right, PositiveS3::left})
            for (const TimeSign t : {TimeSign::minus, TimeSign::plus}) all.push_back({v, s, t});
    return all;
}

TEST(Convention, TheDefaultIsTheEnginesOwn) {
    const Stokes<double> s{1.0, 0.1, -0.2, 0.3};
    EXPECT_EQ(Convention{}.stokes(s), s);
    EXPECT_EQ(Convention{}.matrix(to_coherence(s)), to_coherence(s));
    EXPECT_EQ(Convention{}.handedness_name(1), "right");
    EXPECT_EQ(Convention{}.s3_of_matrix(), 1);
}

TEST(Convention, LabelsAgreeWithTheFieldAsItIsSeen) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 40; ++i) {
        const JonesVector<double> e{{normal(random), normal(random)}, {normal(random), normal(random)}};
        const CoherenceMatrix<double> engine = CoherenceMatrix<double>::outer(e);
        for (const Convention& c : all_conventions()) {
            SCOPED_TRACE(c.text());
            const auto [azimuth, clockwise] = watched(e, c.viewpoint);
            const Stokes<double> s = c.stokes(to_stokes(engine));
            const Measures<double> m = measure(s);
            EXPECT_LT(std::abs(std::sin(m.azimuth - azimuth)), 2e-3);
            EXPECT_EQ(c.handedness_name(m.handedness), clockwise > 0 ? "right" : "left");
            EXPECT_EQ(s.s3 > 0.0, (clockwise > 0) == (c.positive_s3 == PositiveS3::right));

            // The matrix from the amplitudes that this convention has: opposite x, or conjugate.
            JonesVector<double> amplitude = e;
            if (c.viewpoint == Viewpoint::source) amplitude.x = -amplitude.x;
            if (c.time_sign == TimeSign::plus) amplitude = {conj(amplitude.x), conj(amplitude.y)};
            const CoherenceMatrix<double> j = c.matrix(engine);
            EXPECT_NEAR(j.xy.re, CoherenceMatrix<double>::outer(amplitude).xy.re, 1e-14);
            EXPECT_NEAR(j.xy.im, CoherenceMatrix<double>::outer(amplitude).xy.im, 1e-14);
            EXPECT_EQ(s.s2, 2.0 * j.xy.re);
            EXPECT_EQ(s.s3, c.s3_of_matrix() * 2.0 * j.xy.im);
        }
    }
}

// What an element does to the light does not depend on how the light is labeled.
TEST(Convention, AMuellerMatrixActsOnTheLabelsAsOnTheLight) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const Convention& c : all_conventions()) {
        MuellerMatrix<double> m;
        for (auto& row : m.m)
            for (double& entry : row) entry = uniform(random);
        const Stokes<double> s{1.0, uniform(random), uniform(random), uniform(random)};
        EXPECT_EQ(c.mueller(m) * c.stokes(s), c.stokes(m * s)) << c.text() << ": only signs change";
    }
}

// Words follow the numbers: the end of the scale that is called right is that of light that turns clockwise for who
// looks.
TEST(Convention, NamesTheSignsAsTheFieldIsSeen) {
    const Stokes<double> turning{1.0, 0.0, 0.0, 1.0};  // clockwise for the receiver, counter-clockwise for the source
    for (const Convention& c : all_conventions()) {
        SCOPED_TRACE(c.text());
        const std::string name = c.viewpoint == Viewpoint::receiver ? "right" : "left";
        const bool is_high = c.stokes(turning).s3 > 0.0;
        for (const Quantity quantity : {Quantity::s3, Quantity::handedness}) {
            const ScaleWords words = c.scale_words(quantity, false);
            EXPECT_EQ(is_high ? words.high : words.low, name);
            EXPECT_NE(words.high, words.low);
            EXPECT_NE(words.note.find(c.viewpoint == Viewpoint::receiver ? "receiver" : "source"), std::string::npos);
            const std::string at_one = "1 " + words.high + " circular";
            EXPECT_NE(c.definition(quantity).find(" " + at_one), std::string::npos) << c.definition(quantity);
            EXPECT_NE(c.definition(quantity).find("-1 " + words.low + " circular"), std::string::npos);
            EXPECT_EQ(c.scale_words(quantity, true).high, "") << "a difference is not right-handed";
            EXPECT_EQ(c.scale_words(quantity, true).note, words.note);
        }
        EXPECT_EQ(c.scale_words(Quantity::azimuth, false).clockwise, c.viewpoint == Viewpoint::source);
        EXPECT_EQ(c.state_name(turning), name + " circular");
        EXPECT_EQ(c.state_name({1.0, 0.0, 1.0, 0.0}),
                  c.viewpoint == Viewpoint::receiver ? "+45\u00b0" : "\u221245\u00b0");
        EXPECT_EQ(c.state_name({1.0, -1.0, 0.0, 0.0}), "vertical");
        EXPECT_EQ(c.scale_words(Quantity::dop, false).note, "") << "no convention changes it";
    }
    for (const QuantityInfo& about : quantities()) EXPECT_EQ(Convention{}.definition(about.quantity), about.definition);
}

}  // namespace
}  // namespace pol
