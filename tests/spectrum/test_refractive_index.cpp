// SPDX-License-Identifier: Apache-2.0
// The six dispersion formulas against hand calculation, with coefficients for which the arithmetic is easy to follow.
#include <gtest/gtest.h>

#include <cmath>

#include "spectrum/refractive_index.h"

namespace pol {
namespace {

RefractiveIndex formula(int number, std::vector<double> coefficients) {
    return DispersiveIndex{"test", DispersionFormula{number, std::move(coefficients), 100.0, 5000.0}, {}};
}

double n_at(const RefractiveIndex& index, double nm) {
    return index_at(index, nm).value().n;
}

// Each expected value is the formula of the database's documentation at wavelength 0.5 um (L = 0.25) or 2 um (L = 4),
// written out with exact binary fractions; sqrt and pow round once: 4 epsilon.
constexpr double rounding = 1e-15;

TEST(DispersionFormula, OneIsSellmeierWithSquaredPoles) {
    // n^2 = 1 + 0.5 + 1 * 4/(4 - 0.5^2) + 0.25 * 4/(4 - 4^2)
    EXPECT_NEAR(n_at(formula(1, {0.5, 1.0, 0.5, 0.25, 4.0}), 2000.0), std::sqrt(1.5 + 4.0 / 3.75 - 1.0 / 12.0),
                rounding);
}

TEST(DispersionFormula, TwoIsSellmeierWithPlainPoles) {
    EXPECT_NEAR(n_at(formula(2, {0.5, 1.0, 0.5, 0.25, 5.0}), 2000.0), std::sqrt(1.5 + 4.0 / 3.5 - 1.0), rounding);
}

TEST(DispersionFormula, ThreeIsAPolynomialForTheSquare) {
    EXPECT_NEAR(n_at(formula(3, {2.0, 1.0, 2.0, 0.5, -1.0}), 500.0), std::sqrt(2.0 + 0.25 + 1.0), rounding);
}

TEST(DispersionFormula, FourHasTwoPolesAndAPolynomial) {
    // n^2 = 2 + 1 * L^(1/2 * 2)/(L - 0.5^2) + 3 * 2/(4 - 0.5^1) + 0.25 * 2^1
    EXPECT_NEAR(n_at(formula(4, {2.0, 1.0, 2.0, 0.5, 2.0, 3.0, 1.0, 0.5, 1.0, 0.25, 1.0}), 2000.0),
                std::sqrt(2.0 + 4.0 / 3.75 + 6.0 / 3.5 + 0.5), rounding);
}

TEST(DispersionFormula, FiveIsCauchyForTheIndexItself) {
    EXPECT_NEAR(n_at(formula(5, {1.5, 0.25, -2.0}), 2000.0), 1.5 + 0.25 / 4.0, rounding);
}

TEST(DispersionFormula, SixIsForGases) {
    EXPECT_NEAR(n_at(formula(6, {0.25, 1.0, 8.0}), 500.0), 1.25 + 1.0 / (8.0 - 4.0), rounding);
}

TEST(RefractiveIndex, OutsideItsRangeIsAnErrorThatNamesRecordAndRange) {
    const RefractiveIndex glass = formula(5, {1.5});
    EXPECT_TRUE(index_at(glass, 100.0));
    EXPECT_TRUE(index_at(glass, 5000.0));
    for (const double nm : {99.0, 5001.0, std::nan("")}) {
        const Result<ComplexIndex> result = index_at(glass, nm);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().kind, ErrorKind::input);
        EXPECT_NE(result.error().what.find("'test', 100 to 5000 nm"), std::string::npos) << result.error().what;
    }
}

TEST(RefractiveIndex, WithoutAPositiveFiniteSquareIsAnError) {
    EXPECT_FALSE(index_at(formula(3, {-1.0}), 500.0));
    EXPECT_FALSE(index_at(formula(3, {0.0}), 500.0));
    EXPECT_FALSE(index_at(formula(5, {-1.5}), 500.0));
    EXPECT_FALSE(index_at(formula(1, {0.0, 1.0, 0.5}), 500.0));  // on the pole
    EXPECT_FALSE(index_at(formula(5, {1.0, 1e300, 400.0}), 5000.0));
}

TEST(RefractiveIndex, TablesAreLinearBetweenNodesAndExactOnThem) {
    const DispersiveIndex metal{"metal", IndexTable{{500.0, 600.0, 700.0}, {0.5, 0.25, 1.0}},
                                IndexTable{{500.0, 700.0}, {2.0, 4.0}}};
    EXPECT_EQ(index_at(metal, 600.0).value(), (ComplexIndex{0.25, 3.0}));
    EXPECT_NEAR(index_at(metal, 525.0).value().n, 0.4375, rounding);
    EXPECT_NEAR(index_at(metal, 650.0).value().n, 0.625, rounding);
    EXPECT_EQ(index_at(metal, 700.0).value(), (ComplexIndex{1.0, 4.0}));
    EXPECT_FALSE(index_at(metal, 499.0));
    EXPECT_FALSE(index_at(metal, 701.0));
}

TEST(RefractiveIndex, ExtinctionHasARangeOfItsOwn) {
    const DispersiveIndex glass{"glass", DispersionFormula{5, {1.5}, 100.0, 5000.0},
                                IndexTable{{500.0, 700.0}, {0.0, 1.0}}};
    EXPECT_TRUE(index_at(glass, 500.0));
    const Result<ComplexIndex> outside = index_at(glass, 400.0);
    ASSERT_FALSE(outside);
    EXPECT_NE(outside.error().what.find("range of k in 'glass', 500 to 700 nm"), std::string::npos)
        << outside.error().what;
}

TEST(RefractiveIndex, OfALiteralIsTheSameEverywhere) {
    const RefractiveIndex literal = ConstantIndex{{1.5, 0.0}};
    EXPECT_EQ(index_at(literal, 1.0).value().n, 1.5);
    EXPECT_TRUE(is_constant(literal));
    EXPECT_FALSE(is_constant(formula(5, {1.5})));
}

}  // namespace
}  // namespace pol
