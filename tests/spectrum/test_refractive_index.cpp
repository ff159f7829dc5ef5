// SPDX-License-Identifier: Apache-2.0
// The nine dispersion formulas against hand calculation, with coefficients for which the arithmetic is easy to follow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>

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

TEST(DispersionFormula, SevenIsHerzbergerForTheIndexItself) {
    // 1/(L - 0.028) = 1/4 at L = 4.028: 1.5 + 0.5/4 + 2/16 and no powers; then powers alone at L = 4.
    EXPECT_NEAR(n_at(formula(7, {1.5, 0.5, 2.0}), 1000.0 * std::sqrt(4.028)), 1.75, rounding);
    EXPECT_NEAR(n_at(formula(7, {1.5, 0.0, 0.0, 0.25, -0.0625, 0.015625}), 2000.0), 1.5 + 1.0 - 1.0 + 1.0, rounding);
}

TEST(DispersionFormula, EightIsForTheRatioOfLorentzAndLorenz) {
    // s = 1/8 + 1/4 * 4/(4 - 2) - 1/32 * 4 = 1/2, n^2 = (1 + 2 s)/(1 - s) = 4
    EXPECT_NEAR(n_at(formula(8, {0.125, 0.25, 2.0, -0.03125}), 2000.0), 2.0, rounding);
}

TEST(DispersionFormula, NineHasASingularityInTheWavelengthItself) {
    // n^2 = 2 + 1/(4 - 2) + 3 * 0.5/(0.5^2 + 0.75)
    EXPECT_NEAR(n_at(formula(9, {2.0, 1.0, 2.0, 3.0, 1.5, 0.75}), 2000.0), 2.0, rounding);
}

TEST(DispersionFormula, HasTheNumberOfCoefficientsThatItsFormTakes) {
    for (const int number : {1, 2, 3, 5, 6}) {
        EXPECT_EQ(coefficient_problem(number, 7), "") << number;
        EXPECT_NE(coefficient_problem(number, 8), "") << number;
    }
    EXPECT_NE(coefficient_problem(4, 7), "");
    EXPECT_EQ(coefficient_problem(4, 9), "");
    for (const auto& [number, most] : {std::pair{7, 6}, {8, 4}, {9, 6}}) {
        EXPECT_EQ(coefficient_problem(number, static_cast<std::size_t>(most)), "") << number;
        EXPECT_NE(coefficient_problem(number, static_cast<std::size_t>(most) + 1), "") << number;
        EXPECT_NE(coefficient_problem(number, 0), "") << number;
    }
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

TEST(RefractiveIndex, ExtinctionIsZeroAndCalledUnknownOutsideItsOwnRange) {
    const RefractiveIndex glass =
        DispersiveIndex{"glass", DispersionFormula{5, {1.5}, 100.0, 5000.0}, IndexTable{{500.0, 700.0}, {0.0, 1.0}}};
    EXPECT_EQ(index_at(glass, 600.0).value(), (ComplexIndex{1.5, 0.5}));
    EXPECT_FALSE(extinction_is_unknown(glass, 600.0));
    for (const double nm : {499.0, 701.0}) {
        EXPECT_EQ(index_at(glass, nm).value(), (ComplexIndex{1.5, 0.0})) << nm;
        EXPECT_TRUE(extinction_is_unknown(glass, nm)) << nm;
    }
    EXPECT_FALSE(extinction_is_unknown(formula(5, {1.5}), 499.0));  // a record without k is transparent
}

TEST(RefractiveIndex, RowsHaveNoOrderAndNoNumber) {
    const DispersiveIndex glass{"glass", index_table({{600.0, 1.5}, {500.0, 1.75}, {600.0, 1.5}, {700.0, 1.25}}), {}};
    EXPECT_EQ(index_at(glass, 550.0).value().n, 1.625);
    EXPECT_EQ(index_at(glass, 600.0).value().n, 1.5);
    EXPECT_EQ(index_at(glass, 650.0).value().n, 1.375);
}

TEST(RefractiveIndex, ARowThatContradictsAnotherIsRefusedOnlyWhereItIsNeeded) {
    const DispersiveIndex glass{
        "glass",
        index_table({{400.0, 2.0}, {500.0, 1.75}, {600.0, 1.5}, {600.0, 1.25}, {700.0, 1.25}, {800.0, 1.0}}),
        {}};
    EXPECT_EQ(index_at(glass, 450.0).value().n, 1.875);
    EXPECT_EQ(index_at(glass, 500.0).value().n, 1.75);
    EXPECT_EQ(index_at(glass, 700.0).value().n, 1.25);
    EXPECT_EQ(index_at(glass, 750.0).value().n, 1.125);
    for (const double nm : {500.1, 600.0, 699.9}) {
        const auto refused = index_at(glass, nm);
        ASSERT_FALSE(refused) << nm;
        EXPECT_EQ(refused.error().what, "'glass' has n = 1.25 at 600 nm and 1.5 in another row");
    }
}

TEST(RefractiveIndex, ANegativeRowIsRefusedOnlyWhereItIsNeeded) {
    const DispersiveIndex crystal{"crystal", IndexTable{{500.0, 600.0, 700.0, 800.0}, {1.5, 1.5, 1.5, -1.5}},
                                  IndexTable{{500.0, 600.0, 700.0}, {1.0, 0.5, -0.25}}};
    EXPECT_EQ(index_at(crystal, 550.0).value().k, 0.75);
    EXPECT_EQ(index_at(crystal, 600.0).value().k, 0.5);
    // At 650 the mean of both rows would be a harmless 0.125.
    EXPECT_EQ(index_at(crystal, 650.0).error().what, "'crystal' has k = -0.25 at 700 nm");
    EXPECT_EQ(index_at(crystal, 710.0).error().what, "'crystal' has n = -1.5 at 800 nm");
}

TEST(RefractiveIndex, OfALiteralIsTheSameEverywhere) {
    const RefractiveIndex literal = ConstantIndex{{1.5, 0.0}};
    EXPECT_EQ(index_at(literal, 1.0).value().n, 1.5);
    EXPECT_TRUE(is_constant(literal));
    EXPECT_FALSE(is_constant(formula(5, {1.5})));
}

}  // namespace
}  // namespace pol
