// SPDX-License-Identifier: Apache-2.0
// The shader's formulas against the engine's in double precision, on the same (single precision) Stokes vectors.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "maps/error_bars.h"
#include "maps/evaluate.h"
#include "polarization/bounds.h"
#include "support/egl_context.h"
#include "viewer/gl/program.h"
#include "viewer/gl/render_target.h"
#include "viewer/gl/shader_sources.h"
#include "viewer/picture/float_texture.h"
#include "viewer/picture/picture_floats.h"
#include "viewer/picture/shader_constants.h"
#include "viewer/shown/shown_picture.h"

namespace pol {
namespace {

constexpr double shader_noise = 1e-12;

/// A Stokes vector and what may be missing or too much, as the shader sees them.
struct Input {
    Float4 stokes{};
    float missing = 0.0F;
    float surplus = 0.0F;
};

Stokes<double> stokes_of(const Input& input) {
    return {input.stokes[0], input.stokes[1], input.stokes[2], input.stokes[3]};
}

/// Light of degree of polarization `p`, azimuth `psi` and ellipticity angle `chi`.
Float4 state(double s0, double p, double psi, double chi) {
    return to_single(s0, s0 * p * std::cos(2.0 * chi) * std::cos(2.0 * psi),
                     s0 * p * std::cos(2.0 * chi) * std::sin(2.0 * psi), s0 * p * std::sin(2.0 * chi));
}

std::vector<Input> inputs() {
    std::vector<Input> all;
    std::mt19937 generator(20260411);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
    };
    const auto add = [&](const Float4& s) {
        const float s0 = s[0] > 0.0F ? s[0] : 1.0F;
        const auto share = [&] { return s0 * to_single(std::pow(10.0, uniform(-9.0, 0.5))); };
        const float surplus = share();
        all.push_back({s, 0.0F, 0.0F});
        all.push_back({s, share(), 0.0F});
        all.push_back({s, surplus + share(), surplus});
        all.push_back({s, surplus, surplus});
    };
    for (int i = 0; i < 4000; ++i) {
        const double s0 = std::pow(10.0, uniform(-18.0, 18.0));
        // Any point of the sphere, then ones close to unpolarized, to linear and to circular light.
        add(state(s0, uniform(0.0, 1.0), uniform(-1.6, 1.6), uniform(-0.79, 0.79)));
        add(state(s0, std::pow(10.0, uniform(-11.0, 0.0)), uniform(-1.6, 1.6), uniform(-0.79, 0.79)));
        add(state(s0, 1.0, uniform(-1.6, 1.6), std::pow(10.0, uniform(-9.0, 0.0)) * 0.78));
        add(state(s0, 1.0, uniform(-1.6, 1.6), -0.785398163397448 + std::pow(10.0, uniform(-9.0, -1.0))));
    }
    for (const float one : {1.0F, 1e-30F, 1e30F}) {
        for (const float sign : {1.0F, -1.0F}) {
            add({one, sign * one, 0.0F, 0.0F});
            add({one, sign * one, -0.0F, 0.0F});
            add({one, 0.0F, sign * one, 0.0F});
            add({one, 0.0F, 0.0F, sign * one});
            add({one, 0.0F, sign * 1e-7F * one, one});
        }
        add({one, 0.0F, 0.0F, 0.0F});
    }
    add({0.0F, 0.0F, 0.0F, 0.0F});
    return all;
}

/// What `body`, statements that set `result` from `s`, `missing` and `surplus`, makes of each input.
class ShaderFormulas : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(context_.problem(), ""); }

    std::vector<Float4> evaluate(const std::vector<Input>& all, const std::string& body) {
        std::vector<Float4> stokes;
        std::vector<Float4> amounts;
        for (const Input& input : all) {
            stokes.push_back(input.stokes);
            amounts.push_back({input.missing, input.surplus, 0.0F, 0.0F});
        }
        const std::string main_text =
            "uniform sampler2D stokes;\nuniform sampler2D amounts;\nout vec4 result;\nvoid main() {\n"
            "ivec2 at = ivec2(gl_FragCoord.xy);\nvec4 s = texelFetch(stokes, at, 0);\n"
            "float missing = texelFetch(amounts, at, 0).x;\nfloat surplus = texelFetch(amounts, at, 0).y;\n"
            "float radius = missing + surplus;\nMeasures m = measure(s, 1e-12);\n" +
            body + "\n}\n";
        const auto program = Program::link({shader_sources::fullscreen_vert()},
                                           {shader_sources::measures_glsl(), shader_sources::bounds_glsl(), main_text});
        EXPECT_TRUE(program) << to_string(program.error());
        return program ? run(program.value(), stokes, amounts) : std::vector<Float4>{};
    }

    /// Value, weight, state and certainty of the map of `quantity`, by the formula that the window's picture uses.
    std::vector<Float4> evaluate_map(const LightFloats& lights, Quantity quantity, double d65, double peak) {
        constexpr std::string_view main_text =
            "uniform sampler2D stokes;\nuniform sampler2D amounts;\nout vec4 result;\nvoid main() {\n"
            "ivec2 at = ivec2(gl_FragCoord.xy);\nvec4 e = texelFetch(amounts, at, 0);\n"
            "MapPixel p = evaluate(Light(texelFetch(stokes, at, 0), e.x, e.y, unphysical_part(e.z), max(e.z, 0.0), "
            "e.w,\n"
            "vec3(0.0), true));\n"
            "result = vec4(p.value, p.weight, float(p.state), p.certainty);\n}\n";
        const auto program = Program::link({shader_sources::fullscreen_vert()},
                                           {shader_sources::measures_glsl(), shader_sources::bounds_glsl(),
                                            shader_constants(quantity), shader_sources::evaluate_glsl(), main_text});
        EXPECT_TRUE(program) << to_string(program.error());
        if (!program) return {};
        program.value().use();
        program.value().set("brightest", 1.0F);
        program.value().set("d65", to_single(d65));
        program.value().set("is_measured", 1);
        program.value().set("noise", to_single(pixel_noise));
        program.value().set("full_weight", to_single(full_weight_polarization));
        program.value().set("dark_below", to_single(dark_share * peak));
        return run(program.value(), lights.stokes, lights.left_out);
    }

    /// What the program makes of each pair of texels.
    static std::vector<Float4> run(const Program& program, std::vector<Float4> stokes, std::vector<Float4> amounts) {
        constexpr int width = 256;
        const std::size_t count = stokes.size();
        const int height = (static_cast<int>(count) + width - 1) / width;
        stokes.resize(static_cast<std::size_t>(width * height));
        amounts.resize(stokes.size());
        FloatTexture stokes_texture;
        FloatTexture amounts_texture;
        for (auto* texture : {&stokes_texture, &amounts_texture}) texture->resize(width, height);
        stokes_texture.write({0, 0, width, height}, stokes);
        amounts_texture.write({0, 0, width, height}, amounts);
        program.use();
        program.set("stokes", 0);
        program.set("amounts", 1);
        RenderTarget target(GL_RGBA32F);
        target.begin(width, height);
        stokes_texture.bind(0);
        amounts_texture.bind(1);
        const VertexArrayName no_vertices;
        glBindVertexArray(no_vertices.id());
        draw_fullscreen();
        std::vector<Float4> results(stokes.size());
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, results.data());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        results.resize(count);
        return results;
    }

    /// Up to `relative` of the expected value, or up to `absolute`. Only the first failures are told.
    void expect_near(float actual, double expected, double relative, const Input& input, const char* what,
                     double absolute = 0.0) {
        if (std::abs(actual - expected) <= std::max(absolute, relative * std::abs(expected)) || ++failures_ > 10)
            return;
        ADD_FAILURE() << what << " of (" << input.stokes[0] << ", " << input.stokes[1] << ", " << input.stokes[2]
                      << ", " << input.stokes[3] << "), missing " << input.missing << ", surplus " << input.surplus
                      << " is " << actual << " instead of " << expected << ", off by " << actual - expected;
    }

private:
    EglContext context_;
    int failures_ = 0;
};

constexpr double promised = 1e-6;

/// The angle of a ball that just reaches the origin depends on the last digit of its radius.
bool just_reaches(const Input& input, double distance) {
    const double radius = static_cast<double>(input.missing) + input.surplus;
    return std::abs(radius - distance) < 0.01 * distance;
}

TEST_F(ShaderFormulas, DegreesOfPolarizationAgreeWithTheEngine) {
    const std::vector<Input> all = inputs();
    const auto results = evaluate(all, "result = vec4(m.dop, m.dolp, m.docp, m.ellipticity);");
    ASSERT_EQ(results.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Measures<double> m = measure(stokes_of(all[i]), shader_noise);
        expect_near(results[i][0], m.dop, promised, all[i], "DoP");
        expect_near(results[i][1], m.dolp, promised, all[i], "DoLP");
        expect_near(results[i][2], m.docp, promised, all[i], "DoCP");
        expect_near(results[i][3], m.ellipticity, promised, all[i], "ellipticity");
    }
}

TEST_F(ShaderFormulas, AnglesAgreeWithTheEngine) {
    const std::vector<Input> all = inputs();
    const auto results = evaluate(all, "result = vec4(m.azimuth, m.ellipticity_angle, m.chirality, 0.0);");
    ASSERT_EQ(results.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Measures<double> m = measure(stokes_of(all[i]), shader_noise);
        expect_near(results[i][0], m.azimuth, promised, all[i], "azimuth");
        expect_near(results[i][1], m.ellipticity_angle, promised, all[i], "ellipticity angle");
        expect_near(results[i][2], std::sin(2.0 * m.ellipticity_angle), promised, all[i], "S3/p");
    }
}

TEST_F(ShaderFormulas, TellWhatHasNoPolarizationAndWhatIsNoLight) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<Input> all = inputs();
    for (std::size_t component = 0; component < 4; ++component) {
        for (const float bad : {nan, infinity, -infinity}) {
            Input input{{1.0F, 0.5F, 0.0F, 0.0F}, 0.0F, 0.0F};
            input.stokes[component] = bad;
            all.push_back(input);
        }
    }
    all.push_back({{-1.0F, 0.5F, 0.0F, 0.0F}, 0.0F, 0.0F});
    all.push_back({{0.0F, 1e-20F, 0.0F, 0.0F}, 0.0F, 0.0F});
    const auto results = evaluate(all, "result = vec4(m.is_light, m.has_light, m.has_polarization, m.has_azimuth);");
    ASSERT_EQ(results.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Measures<double> m = measure(stokes_of(all[i]), shader_noise);
        EXPECT_EQ(results[i][0] == 1.0F, std::isfinite(m.dop)) << i;
        EXPECT_EQ(results[i][1] == 1.0F, m.has_light) << i;
        EXPECT_EQ(results[i][2] == 1.0F, m.has_polarization) << i;
        EXPECT_EQ(results[i][3] == 1.0F, m.has_azimuth) << i;
    }
}

// Bars are compared to 1e-6 of the quantity's range: they decide, by their width, what is undetermined.
TEST_F(ShaderFormulas, BarsAgreeWithTheEngine) {
    const std::vector<Input> all = inputs();
    const auto shares = evaluate(all,
                                 "result = vec4(share_bounds(m.polarized, s.x, missing, surplus),\n"
                                 "              share_bounds(abs(s.w), s.x, missing, surplus));");
    const auto ellipses =
        evaluate(all, "result = vec4(ellipticity_bounds(m, radius), ellipticity_angle_bounds(m, radius));");
    ASSERT_EQ(ellipses.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto bars = measure_bounds<double>(stokes_of(all[i]), all[i].missing, all[i].surplus);
        // Where the surplus may be all there is, the bar depends on the sign of a rounding error.
        const double total = all[i].stokes[0] + static_cast<double>(all[i].missing) - all[i].surplus;
        if (total > 1e-5 * (static_cast<double>(all[i].missing) + all[i].stokes[0])) {
            expect_near(shares[i][0], bars.dop.low, 0.0, all[i], "least DoP", promised);
            expect_near(shares[i][1], bars.dop.high, 0.0, all[i], "most DoP", promised);
            expect_near(shares[i][2], bars.docp.low, 0.0, all[i], "least DoCP", promised);
            expect_near(shares[i][3], bars.docp.high, 0.0, all[i], "most DoCP", promised);
        }
        const double distance = polarized_part(stokes_of(all[i]));
        if (!measure(stokes_of(all[i]), shader_noise).has_polarization || just_reaches(all[i], distance)) continue;
        expect_near(ellipses[i][0], bars.ellipticity.low, 0.0, all[i], "least ellipticity", promised);
        expect_near(ellipses[i][1], bars.ellipticity.high, 0.0, all[i], "most ellipticity", promised);
        expect_near(ellipses[i][2], bars.ellipticity_angle.low, 0.0, all[i], "least ellipticity angle", promised);
        expect_near(ellipses[i][3], bars.ellipticity_angle.high, 0.0, all[i], "most ellipticity angle", promised);
    }
}

// Also where a bar is 1e-9: the engine's difference of nearly equal numbers then is good to 1e-16, or 1e-7 of it.
TEST_F(ShaderFormulas, HalfWidthsOfBarsAgreeWithTheEngineHoweverSmall) {
    const std::vector<Input> all = inputs();
    const auto results =
        evaluate(all,
                 "result = vec4(share_half_width(m.polarized, s.x, missing, surplus),\n"
                 "              ellipticity_half_width(m, s.w, radius), azimuth_bound(m, radius), 0.0);");
    ASSERT_EQ(results.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Stokes<double> s = stokes_of(all[i]);
        const Measures<double> m = measure(s, shader_noise);
        if (!m.has_light) continue;
        const auto bars = measure_bounds<double>(s, all[i].missing, all[i].surplus);
        expect_near(results[i][0], half_width(bars.dop, m.dop), promised, all[i], "bar of DoP", 4e-16);
        if (m.has_polarization && !just_reaches(all[i], polarized_part(s))) {
            expect_near(results[i][1], half_width(bars.ellipticity, m.ellipticity), promised, all[i],
                        "bar of the ellipticity", 4e-16);
        }
        if (m.has_azimuth && !just_reaches(all[i], linear_part(s)))
            expect_near(results[i][2], bars.azimuth, promised, all[i], "bar of the azimuth");
    }
}

// Every row of quantities(): one without a formula in evaluate.glsl, or with another one than the engine's, fails.
TEST_F(ShaderFormulas, EveryMapAgreesWithTheEngine) {
    const std::vector<Input> all = inputs();
    StokesImage film;
    film.width = static_cast<int>(all.size());
    film.height = 1;
    film.bands = bands_at({550.0});
    film.brightest = {1.0};
    // So that half of the inputs are darker than a thousandth of it.
    film.peak = {1000.0};
    for (const Input& input : all) {
        film.stokes.push_back(stokes_of(input));
        film.residual.push_back(to_single(static_cast<double>(input.missing) - input.surplus));
        film.tail.push_back(input.surplus);
        film.samples.push_back(1U << (film.samples.size() % 20));
    }
    const ShownPicture shown(film, {});
    const LightFloats lights = light_floats(shown, 0, {0, 0, film.width, 1});
    constexpr double d65 = 0.75;
    for (const QuantityInfo& about : quantities()) {
        if (about.kind == ScaleKind::color) continue;
        SCOPED_TRACE(about.name);
        const auto results = evaluate_map(lights, about.quantity, d65, film.peak[0]);
        ASSERT_EQ(results.size(), all.size());
        std::size_t compared = 0;
        std::size_t of_other_state = 0;
        std::size_t dark = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            // As above: where a bar depends on the last digit.
            const Stokes<double> s = stokes_of(all[i]);
            const bool is_on_edge = just_reaches(all[i], polarized_part(s)) || just_reaches(all[i], linear_part(s)) ||
                                    s.s0 + film.residual[i] <= 1e-5 * (s.s0 + all[i].missing);
            if (is_on_edge) continue;
            const MapPixel expected = evaluate_light(shown.light(0, i), about.quantity, d65);
            if (static_cast<PixelState>(results[i][2]) != expected.state) {
                ++of_other_state;
            } else if (expected.state == PixelState::dark) {
                ++dark;
            } else if (expected.state == PixelState::defined) {
                ++compared;
                const double slack = promised * about.rounding_size;
                expect_near(results[i][0], expected.value, promised, all[i], "value", slack);
                expect_near(results[i][1], expected.weight, promised, all[i], "weight");
                expect_near(results[i][3], expected.certainty, 0.0, all[i], "certainty", 10.0 * promised);
            }
        }
        EXPECT_GT(compared, all.size() / 8);
        const bool has_bar = about.has_bar && about.quantity != Quantity::intensity;
        EXPECT_EQ(dark > all.size() / 100, has_bar) << dark;
        // Light at the very limit of being undetermined, dark, or no light.
        EXPECT_LT(of_other_state, all.size() / 1000);
    }
}

}  // namespace
}  // namespace pol
