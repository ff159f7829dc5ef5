// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "viewer/widgets/fonts.h"
#include "viewer/widgets/theme.h"

namespace pol {
namespace {

/// Relative luminance and contrast as WCAG 2.1 defines them.
double luminance(const ImVec4& color) {
    const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

double contrast(const ImVec4& a, const ImVec4& b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

TEST(Theme, TextsCanBeReadOnEveryGround) {
    constexpr double readable = 4.5;  // WCAG 2.1, level AA
    EXPECT_NEAR(contrast({0, 0, 0, 1}, {1, 1, 1, 1}), 21.0, 1e-9);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const ThemeColors& c = colors(theme);
        const std::array grounds{std::pair{"window", c.window}, std::pair{"popup", c.popup},
                                 std::pair{"field", c.field}, std::pair{"field_hover", c.field_hover},
                                 std::pair{"selected", c.selected}};
        for (const auto& [name, ground] : grounds) {
            EXPECT_GE(contrast(c.text, ground), 7.0) << name;
            EXPECT_GE(contrast(c.dim, ground), readable) << name;
        }
        for (const ImVec4& signal : {c.accent, c.good, c.warning, c.error})
            for (const ImVec4& ground : {c.window, c.popup}) EXPECT_GE(contrast(signal, ground), readable);
    }
}

class Fonts : public testing::Test {
protected:
    Fonts() { ImGui::CreateContext(); }
    ~Fonts() override { ImGui::DestroyContext(); }
};

TEST_F(Fonts, HaveEverySignThatPanelsShow) {
    EXPECT_EQ(load_fonts(1.0), std::nullopt);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    // degree, plus-minus, middle dot, multiply, superscript 2; chi, lambda, delta, omega; subscripts; arrows; minus,
    // root, almost equal, less or equal; dashes; triangle
    constexpr std::array<ImWchar, 24> shown{0x00b0, 0x00b1, 0x00b7, 0x00d7, 0x00b2, 0x03c7, 0x03bb, 0x03b4,
                                            0x03c9, 0x2080, 0x2081, 0x2092, 0x2091, 0x2190, 0x2192, 0x21ba,
                                            0x21bb, 0x2212, 0x221a, 0x2248, 0x2264, 0x2013, 0x25b6, 0x2020};
    for (const FontRole role : {FontRole::body, FontRole::bold, FontRole::mono})
        for (const ImWchar sign : shown)
            EXPECT_NE(font(role)->FindGlyphNoFallback(sign), nullptr)
                << "U+" << std::hex << sign << " in font " << static_cast<int>(role);
}

TEST_F(Fonts, GrowWithTheScreen) {
    load_fonts(2.0);
    ImGui::GetIO().Fonts->Build();
    EXPECT_EQ(font(FontRole::body)->FontSize, 28.0F);
}

}  // namespace
}  // namespace pol
