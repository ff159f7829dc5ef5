// SPDX-License-Identifier: Apache-2.0
// Metrics of pictures of which the error is known by construction (CUTTING.md 3).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/error_metrics.h"
#include "core/units.h"
#include "film/picture_error.h"
#include "polarization/coherence_matrix.h"
#include "verify/convergence/picture_parts.h"

namespace pol {
namespace {

StokesImage picture_of(std::vector<Stokes<double>> pixels) {
    StokesImage image;
    image.width = static_cast<int>(pixels.size());
    image.height = 1;
    image.bands = bands_at({580.0});
    image.stokes = std::move(pixels);
    image.brightest = {1.0};
    return image;
}

/// A few roundings of numbers around 1.
constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();

TEST(ErrorMetrics, APictureHasNoDistanceFromItself) {
    const StokesImage image = picture_of({{1.0, 0.3, -0.2, 0.1}, {0.0, 0.0, 0.0, 0.0}});
    const ErrorMetrics metrics = error_metrics(image, image);
    for (const NamedMetric& named : named_metrics) {
        EXPECT_EQ((metrics.*named.metric).whole, 0.0) << named.name;
        EXPECT_EQ((metrics.*named.metric).largest, 0.0) << named.name;
    }
}

TEST(ErrorMetrics, AMetricOfWhatWasNotMeasuredIsNotThere) {
    const StokesImage ours = picture_of({{1.0, 0.3, -0.2, 0.1}, {0.5, -0.1, 0.4, 0.2}});
    StokesImage photographed = ours;
    for (Stokes<double>& s : photographed.stokes) s.s3 = 0.0;
    photographed.bands[0].known = StokesComponents::linear();
    for (const ErrorMetrics& metrics : {error_metrics(photographed, ours), error_metrics(ours, photographed)}) {
        for (const NamedMetric& named : named_metrics) {
            const bool is_there = named.name == "rel_rmse_s0" || named.name == "mrse_s0" || named.name == "azimuth_w";
            EXPECT_EQ((metrics.*named.metric).is_measured(), is_there) << named.name;
        }
        EXPECT_EQ(metrics.azimuth_w.whole, 0.0);
    }
}

// Both numerator and denominator of fro_c are norms: a picture scaled by 1 + f is off by f in fro_c and in S0, and by
// nothing in degree, azimuth and ellipticity.
TEST(ErrorMetrics, ABrighterPictureIsOffInIntensityAlone) {
    const StokesImage reference = picture_of({{1.0, 0.3, -0.2, 0.1}, {0.5, -0.1, 0.4, 0.2}});
    StokesImage brighter = reference;
    for (Stokes<double>& s : brighter.stokes) s = 1.25 * s;
    const ErrorMetrics metrics = error_metrics(brighter, reference);
    EXPECT_NEAR(metrics.fro_c.whole, 0.25, rounding);
    EXPECT_NEAR(metrics.rel_rmse_s0.whole, 0.25, rounding);
    EXPECT_NEAR(metrics.dop_w.whole, 0.0, rounding);
    EXPECT_NEAR(metrics.azimuth_w.whole, 0.0, rounding);
    EXPECT_NEAR(metrics.ellip_w.whole, 0.0, rounding);
}

// Crossed linear states: |dC|_F^2 = 2 for |C|_F^2 = 1; an analyzer along the one reads 1 instead of 0; the azimuths are
// 90 degrees apart, the largest angle between undirected lines.
TEST(ErrorMetrics, CrossedLinearStatesAreAsFarApartAsCanBe) {
    const ErrorMetrics metrics = error_metrics(picture_of({{1.0, -1.0, 0.0, 0.0}}), picture_of({{1.0, 1.0, 0.0, 0.0}}));
    EXPECT_NEAR(metrics.fro_c.whole, std::sqrt(2.0), rounding);
    EXPECT_NEAR(metrics.analyzer_inf.whole, 1.0, rounding);
    EXPECT_NEAR(metrics.azimuth_w.whole, pi / 2.0, rounding);
    EXPECT_EQ(metrics.rel_rmse_s0.whole, 0.0);
    EXPECT_EQ(metrics.dop_w.whole, 0.0);
}

// Azimuths of 89 and -89 degrees are 2 degrees apart, not 178.
TEST(ErrorMetrics, AzimuthsAreComparedAsLines) {
    const auto linear_at = [](double angle) {
        return Stokes<double>{1.0, std::cos(2.0 * angle), std::sin(2.0 * angle), 0.0};
    };
    const ErrorMetrics metrics =
        error_metrics(picture_of({linear_at(radians(89.0))}), picture_of({linear_at(radians(-89.0))}));
    EXPECT_NEAR(metrics.azimuth_w.whole, radians(2.0), rounding);
}

// The same error seen in a turned frame has the same fro_c: the Frobenius norm does not know the basis.
TEST(ErrorMetrics, ThePrimaryMetricDoesNotDependOnTheFrame) {
    const std::vector<Stokes<double>> test{{1.0, 0.3, -0.2, 0.1}, {0.5, -0.1, 0.4, 0.2}};
    const std::vector<Stokes<double>> reference{{0.9, 0.1, -0.25, 0.15}, {0.6, -0.2, 0.35, 0.1}};
    const auto turned = [](std::vector<Stokes<double>> pixels) {
        for (Stokes<double>& s : pixels) s = rotate_basis(s, 0.7);
        return picture_of(std::move(pixels));
    };
    EXPECT_NEAR(error_metrics(picture_of(test), picture_of(reference)).fro_c.whole,
                error_metrics(turned(test), turned(reference)).fro_c.whole, rounding);
}

// sin, cos of 2 chi and 2 psi: the distance of two states of one azimuth is that of their ellipticity angles, the
// distance of two linear states that of their azimuths, and right and left circular are opposite.
TEST(ErrorMetrics, HalfTheAngleOnThePoincareSphereIsAzimuthForLinearAndEllipticityForAlignedStates) {
    const auto state = [](double azimuth, double ellipticity_angle) {
        const double c = std::cos(2.0 * ellipticity_angle);
        return picture_of(
            {{2.0, c * std::cos(2.0 * azimuth), c * std::sin(2.0 * azimuth), std::sin(2.0 * ellipticity_angle)}});
    };
    const auto distance = [&](const StokesImage& a, const StokesImage& b) {
        return error_metrics(a, b).poincare_w.whole;
    };
    EXPECT_NEAR(distance(state(radians(89.0), 0.0), state(radians(-89.0), 0.0)), radians(2.0), rounding);
    EXPECT_NEAR(distance(state(0.4, 0.3), state(0.4, -0.2)), 0.5, rounding);
    EXPECT_NEAR(distance(state(0.0, pi / 4.0), state(0.0, -pi / 4.0)), pi / 2.0, rounding);
    // Azimuth along a circle of latitude: cos g' = sin^2 2chi + cos^2 2chi cos 2dpsi, g' = 2 g.
    const double c = std::cos(0.6);
    EXPECT_NEAR(distance(state(0.1, 0.3), state(0.4, 0.3)), 0.5 * std::acos(1.0 - c * c * (1.0 - std::cos(0.6))),
                rounding);
}

// Weights are |s| of the reference: 1/2 and 1/4 for distances of 0.3 and 0.
TEST(ErrorMetrics, ThePoincareDistanceIsWeightedByThePolarizedPart) {
    const StokesImage reference = picture_of({{1.0, 0.5, 0.0, 0.0}, {1.0, 0.0, 0.25, 0.0}});
    StokesImage test = reference;
    test.stokes[0] = {1.0, 0.5 * std::cos(0.6), 0.5 * std::sin(0.6), 0.0};
    const Metric metric = error_metrics(test, reference).poincare_w;
    EXPECT_NEAR(metric.whole, 0.3 * std::sqrt(2.0 / 3.0), rounding);
    EXPECT_NEAR(metric.largest, 0.3, rounding);
}

// (0.1/(1 + 0.01))^2 and (0.02/(0 + 0.01))^2: a black pixel counts against a hundredth of the brightest. The unit of
// radiance does not matter.
TEST(ErrorMetrics, TheMeanRelativeSquareErrorCountsDarkPixelsAgainstAHundredthOfTheBrightest) {
    for (const double unit : {1.0, 1024.0}) {
        const Metric metric = error_metrics(picture_of({{1.1 * unit, 0.0, 0.0, 0.0}, {0.02 * unit, 0.0, 0.0, 0.0}}),
                                            picture_of({{unit, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}}))
                                  .mrse_s0;
        EXPECT_NEAR(metric.whole, 0.5 * (0.01 / (1.01 * 1.01) + 4.0), 4.0 * rounding);
        EXPECT_NEAR(metric.largest, 4.0, 4.0 * rounding);
    }
}

TEST(LightDefects, AreStatesThatNoLightHasAndRadianceAboveTheBrightest) {
    const StokesImage image = picture_of({{1.0, 0.6, 0.0, 0.8}, {0.5, 0.3, 0.0, 0.5}, {1.25, 0.0, 0.0, 0.0}});
    const LightDefects defects = light_defects(image, rounding);
    EXPECT_EQ(defects.not_psd, 1U);
    EXPECT_EQ(defects.s0_over_max, 1.25);
}

TEST(ErrorMetrics, NumbersThatAreNoneAreCountedAndLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ErrorMetrics metrics = error_metrics(picture_of({{nan, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}),
                                               picture_of({{1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}));
    EXPECT_EQ(metrics.nan_count, 1U);
    EXPECT_EQ(metrics.fro_c.whole, 0.0);
    const StokesImage none = picture_of({{nan, 0.0, 0.0, 0.0}});
    EXPECT_EQ(error_metrics(none, picture_of({{1.0, 0.0, 0.0, 0.0}})).fro_c.whole,
              std::numeric_limits<double>::infinity());
}

// Two pictures can both be right only if their bounds together allow the difference, pixel by pixel: a third pixel
// whose reference is unknown does not excuse the second.
TEST(BoundCoverage, CountsPixelsWhoseErrorExceedsBothBounds) {
    StokesImage test = picture_of({{0.95, 0.0, 0.0, 0.0}, {0.80, 0.0, 0.0, 0.0}, {0.50, 0.0, 0.0, 0.0}});
    test.residual = {0.1, 0.1, 0.1};
    StokesImage reference = picture_of({{1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}});
    reference.residual = {0.0, 0.0, 0.0};
    reference.tail = {0.0, 0.05, 0.9};
    const BoundCoverage coverage = bound_coverage(test, reference, double_rounding);
    EXPECT_NEAR(coverage.covered, 2.0 / 3.0, rounding);
    EXPECT_EQ(coverage.largest, 0.1);
    EXPECT_NEAR(coverage.ratio, 0.5, rounding);  // of the one pixel whose reference is known ten times better
}

// As bright as the reference, but of another state: C moves by |ds| / sqrt(2) in Frobenius' norm, 0.07 in the first
// pixel, 0.42 in the second, where a tenth was not traced.
TEST(BoundCoverage, CountsPixelsWhosePolarizationIsOff) {
    StokesImage test = picture_of({{1.0, 0.1, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.3}});
    test.residual = {0.1, 0.1};
    const StokesImage reference = picture_of({{1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, -0.3}});
    EXPECT_EQ(bound_coverage(test, reference, double_rounding).covered, 0.5);
}

// An error of nothing is not 0 unless it is nothing.
TEST(ErrorMetrics, ABlackReferenceMakesAnyLightAnInfiniteError) {
    const StokesImage black = picture_of({{0.0, 0.0, 0.0, 0.0}});
    StokesImage lit = picture_of({{1.0, 0.0, 0.0, 0.0}});
    lit.residual = {0.5};
    EXPECT_EQ(error_metrics(lit, black).fro_c.whole, std::numeric_limits<double>::infinity());
    EXPECT_EQ(relative_bound(lit, black), std::numeric_limits<double>::infinity());
    EXPECT_EQ(error_metrics(black, black).fro_c.whole, 0.0);
    EXPECT_EQ(relative_bound(black, black), 0.0);
}

// What a tail tells and the truth may be light of crossed polarizations, as bright as the tail is heavy: sqrt(2) apart
// in Frobenius' norm. What was not traced may come on top.
TEST(BoundCoverage, OfATailHoldsItsWorstCase) {
    EXPECT_EQ(truncation_bound(0.25, 0.0), 0.25);
    EXPECT_DOUBLE_EQ(truncation_bound(0.0, 0.5), std::sqrt(frobenius_square(Stokes<double>{0.0, 1.0, 0.0, 0.0})));
    StokesImage test = picture_of({{0.5, 0.5, 0.0, 0.0}});
    test.tail = {0.5};
    test.residual = {0.25};
    const StokesImage reference = picture_of({{0.75, -0.75, 0.0, 0.0}});
    EXPECT_EQ(bound_coverage(test, reference, double_rounding).covered, 1.0);
    EXPECT_NEAR(relative_bound(test, reference), error_metrics(test, reference).fro_c.whole, rounding);
}

// A nested set keeps both ends of the range; the same light seen at fewer wavelengths has another color.
TEST(ColorDifference, ANestedSetOfWavelengthsKeepsItsEndsAndShiftsTheColor) {
    StokesImage flat;
    flat.width = flat.height = 1;
    for (int w = 380; w <= 780; w += 20) {
        flat.bands.push_back({w, {}});
        flat.stokes.push_back({1.0, 0.0, 0.0, 0.0});
    }
    const StokesImage half = verify::every_second_wavelength(flat);
    EXPECT_EQ(half.bands.size(), 11U);
    EXPECT_EQ(*half.bands.back().wavelength_nm, 780.0);
    EXPECT_EQ(color_difference(flat, flat), 0.0);
    EXPECT_GT(color_difference(half, flat), 0.0);
}

}  // namespace
}  // namespace pol
