// SPDX-License-Identifier: Apache-2.0
#include "viewer/picture/picture_renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/contract.h"
#include "core/result.h"
#include "maps/color_picture.h"
#include "maps/evaluate.h"
#include "viewer/gl/program.h"
#include "viewer/gl/render_target.h"
#include "viewer/gl/shader_sources.h"
#include "viewer/picture/float_texture.h"
#include "viewer/picture/picture_floats.h"
#include "viewer/picture/shader_constants.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/picture_place.h"

namespace pol {

using Float2 = std::array<float, 2>;

/// What a program is made for; the rest are uniforms.
struct ProgramVariant {
    Quantity quantity{};
    bool over_intensity = false;
    bool is_difference = false;  ///< minus a reference: worked out in double and uploaded
    bool is_reduced = false;     ///< several pixels of the picture under one of the screen
    friend bool operator==(const ProgramVariant&, const ProgramVariant&) = default;
    friend bool operator<(const ProgramVariant& a, const ProgramVariant& b) {
        return std::tie(a.quantity, a.over_intensity, a.is_difference, a.is_reduced) <
               std::tie(b.quantity, b.over_intensity, b.is_difference, b.is_reduced);
    }
};

/// All that a drawn view depends on but for the textures' contents.
struct DrawnView {
    int width = 0;
    int height = 0;
    Float2 origin{};
    float zoom = 1.0F;
    float hatch = 1.0F;
    ProgramVariant variant;
    ColorScale scale{};
    bool fades = true;
    bool fades_by_bar = false;
    bool black_is_none = false;
    float low = 0.0F;
    float high = 1.0F;
    float brightest = 0.0F;
    float dark_below = 0.0F;
    float d65 = 1.0F;
    bool is_measured = true;
    bool has_polarimeter = false;
    Float4 polarimeter_row{};
    float gain = 1.0F;
    float offset = 0.0F;
    float gamma = 1.0F;
    friend bool operator==(const DrawnView&, const DrawnView&) = default;
};

namespace {

using Float3 = std::array<float, 3>;

constexpr Float4 background{0.1F, 0.1F, 0.1F, 1.0F};

/// Nodes of a color scale: all scales have their kinks at quarters.
constexpr int scale_nodes = 1025;

// Texture units.
enum Unit : int { unit_stokes, unit_left_out, unit_red, unit_green, unit_blue, unit_scale, unit_difference };

Float3 to_single3(const Rgb& color) {
    return {to_single(color[0]), to_single(color[1]), to_single(color[2])};
}

/// As a shader writes it: 0 to 1, still sRGB.
Float3 encoded(const Rgb8& color) {
    return to_single3(Rgb{color[0] / 255.0, color[1] / 255.0, color[2] / 255.0});
}

/// Colors of the states at a column of the first row, by state.
std::array<Float3, pixel_state_count> state_colors(int column, bool black_is_none) {
    std::array<Float3, pixel_state_count> colors{};
    for (std::size_t state = 1; state < pixel_state_count; ++state)
        colors[state] = encoded(state_color(static_cast<PixelState>(state), column, 0, black_is_none));
    return colors;
}

/// What fading ends in: the color of `undefined`, linear.
Float3 fade_ground() {
    const Rgb8 color = state_color(PixelState::undefined, 0, 0);
    return to_single3(Rgb{srgb_decode(color[0] / 255.0), srgb_decode(color[1] / 255.0), srgb_decode(color[2] / 255.0)});
}

/// Two rows: linear, and encoded for the screen.
void write_scale(FloatTexture& texture, ColorScale scale) {
    std::vector<Float4> linear;
    std::vector<Float4> encoded_too;
    for (int i = 0; i < scale_nodes; ++i) {
        const Rgb color = scale_color(scale, i / (scale_nodes - 1.0));
        const auto signal = [&](std::size_t c) { return std::clamp(srgb_encode(color[c]), 0.0, 1.0); };
        linear.push_back(to_single(color[0], color[1], color[2], 1.0));
        encoded_too.push_back(to_single(signal(0), signal(1), signal(2), 1.0));
    }
    texture.resize(scale_nodes, 2, GL_LINEAR);
    texture.write({0, 0, scale_nodes, 1}, linear);
    texture.write({0, 1, scale_nodes, 2}, encoded_too);
}

Result<Program> program_for(const ProgramVariant& variant) {
    const auto is = [](bool value) { return value ? "true" : "false"; };
    const std::string chosen = std::string("const bool over_intensity = ") + is(variant.over_intensity) +
                               ";\nconst bool is_difference = " + is(variant.is_difference) +
                               ";\nconst bool is_reduced = " + is(variant.is_reduced) + ";\n";
    using namespace shader_sources;
    auto program = Program::link(
        {fullscreen_vert()},
        {measures_glsl(), bounds_glsl(), shader_constants(variant.quantity), evaluate_glsl(), chosen, map_frag()});
    if (!program) return program;
    program.value().use();
    program.value().set("stokes", unit_stokes);
    program.value().set("left_out", unit_left_out);
    program.value().set("red", unit_red);
    program.value().set("green", unit_green);
    program.value().set("blue", unit_blue);
    program.value().set("scale_colors", unit_scale);
    program.value().set("difference", unit_difference);
    return program;
}

ShownPicture shown_on(const ShownSide& side, const Session& session) {
    return {side.document->picture(), session.polarimeter(), session.view().convention};
}

DrawnView what_to_draw(const Session& session, const ShownSide& side, int width, int height, double pixel_ratio) {
    const ViewSettings& view = session.view();
    const StokesImage& picture = side.document->picture();
    const MapScale look = map_look(session);
    const auto d65 = white_of(picture.bands[side.band]);
    const auto first_row = session.polarimeter().mueller().m[0];
    DrawnView drawn;
    drawn.width = width;
    drawn.height = height;
    const ViewTransform placed = of_part(session.transform(), corner_of(picture));
    drawn.origin = {to_single(placed.offset.x * pixel_ratio), to_single(placed.offset.y * pixel_ratio)};
    drawn.zoom = to_single(session.transform().scale * pixel_ratio);
    drawn.hatch = to_single(session.transform().scale);
    const bool is_picture = view.quantity == Quantity::color;
    drawn.variant = {view.quantity, view.over_intensity && !is_picture, side.is_difference, drawn.zoom < 1.0F};
    drawn.scale = look.scale;
    drawn.fades = look.can_fade();
    drawn.fades_by_bar = look.can_fade() && view.fade_by_bar;
    drawn.black_is_none = look.black_is_none;
    drawn.low = to_single(look.range.low);
    drawn.high = to_single(look.range.high);
    drawn.brightest = picture.brightest.empty() ? 0.0F : to_single(picture.brightest[side.band]);
    drawn.dark_below = picture.peak.empty() ? 0.0F : to_single(dark_share * picture.peak[side.band]);
    drawn.d65 = d65 ? to_single(d65.value()) : 0.0F;
    drawn.is_measured = shown_on(side, session).measures(view.quantity, side.band);
    drawn.has_polarimeter = !session.polarimeter().empty();
    drawn.polarimeter_row = to_single(first_row[0], first_row[1], first_row[2], first_row[3]);
    drawn.gain = to_single(std::exp2(view.exposure));
    drawn.offset = to_single(view.offset);
    drawn.gamma = to_single(view.gamma);
    return drawn;
}

void set_uniforms(const Program& program, const DrawnView& drawn) {
    program.set("viewport_height", static_cast<float>(drawn.height));
    program.set("origin", drawn.origin);
    program.set("zoom", drawn.zoom);
    program.set("hatch", drawn.hatch);
    program.set("background", background);
    program.set("low", drawn.low);
    program.set("high", drawn.high);
    program.set("brightest", drawn.brightest);
    program.set("dark_below", drawn.dark_below);
    program.set("d65", drawn.d65);
    program.set("is_measured", drawn.is_measured ? 1 : 0);
    program.set("noise", to_single(pixel_noise));
    program.set("full_weight", to_single(full_weight_polarization));
    program.set("fades", drawn.fades ? 1 : 0);
    program.set("fades_by_bar", drawn.fades_by_bar ? 1 : 0);
    program.set("has_polarimeter", drawn.has_polarimeter ? 1 : 0);
    program.set("polarimeter_row", drawn.polarimeter_row);
    program.set("gain", drawn.gain);
    program.set("offset", drawn.offset);
    program.set("gamma", drawn.gamma);
    program.set("ground", fade_ground());
    program.set("state_colors", state_colors(0, drawn.black_is_none));
    program.set("other_stripes", state_colors(4, drawn.black_is_none));
}

/// Adds a part of the picture `whole` in strips that take some milliseconds each, unless it waits already.
void add_strips(std::deque<TileRect>& left, const TileRect& rect, const TileRect& whole, std::size_t bands) {
    constexpr std::size_t numbers_at_once = std::size_t{1} << 18U;
    std::size_t waiting = 0;
    for (const TileRect& strip : left) waiting += strip.pixel_count();
    const bool is_late = waiting > 2 * whole.pixel_count();  // then the whole picture is less work
    if (is_late) left.clear();
    const TileRect& part = is_late ? whole : rect;
    const std::size_t numbers_a_row = static_cast<std::size_t>(part.width()) * bands;
    const int rows =
        static_cast<int>(std::max<std::size_t>(1, numbers_at_once / std::max<std::size_t>(1, numbers_a_row)));
    for (int y = part.y0; y < part.y1; y += rows) {
        const TileRect strip{part.x0, y, part.x1, std::min(y + rows, part.y1)};
        if (std::find(left.begin(), left.end(), strip) == left.end()) left.push_back(strip);
    }
}

}  // namespace

struct PictureRenderer::Gpu {
    PictureSide side{};
    std::map<ProgramVariant, Program> programs;  ///< made when first needed
    VertexArrayName no_vertices;
    RenderTarget target{GL_RGBA8};
    FloatTexture stokes;
    FloatTexture left_out;
    std::array<FloatTexture, 3> color;
    FloatTexture scale;
    FloatTexture difference;

    std::deque<TileRect> light_left;  ///< not yet written into `stokes` and `left_out`
    std::deque<TileRect> color_left;

    // What the textures hold, or will when nothing is left.
    std::optional<std::uint64_t> layout;  ///< none: no picture
    std::uint64_t picture_version = 0;
    std::size_t wavelength = 0;
    Polarimeter polarimeter;
    Convention convention;
    std::optional<std::uint64_t> difference_version;  ///< of the session's shown map; none: no difference
    std::optional<ColorScale> scale_shown;
    /// What the target shows; none: not what the textures hold now.
    std::optional<DrawnView> drawn;
};

PictureRenderer::PictureRenderer(std::unique_ptr<Gpu> gpu) : gpu_(std::move(gpu)) {}

PictureRenderer::~PictureRenderer() = default;

Result<std::unique_ptr<PictureRenderer>> PictureRenderer::create(PictureSide side) {
    auto gpu = std::make_unique<Gpu>();
    gpu->side = side;
    const ProgramVariant first{};
    POL_TRY(auto program, program_for(first));
    gpu->programs.emplace(first, std::move(program));
    return std::unique_ptr<PictureRenderer>(new PictureRenderer(std::move(gpu)));
}

bool PictureRenderer::upload(const Session& session, double seconds) {
    const auto side = session.side(gpu_->side);
    if (!side || side->document->picture().pixel_count() == 0) {
        gpu_->layout.reset();
        return false;
    }
    const Document* document = side->document;
    const StokesImage& picture = document->picture();
    const TileRect everything{0, 0, picture.width, picture.height};
    const bool is_new = gpu_->layout != document->picture_layout();
    const std::vector<TileRect> changes =
        is_new ? std::vector{everything} : document->changes_since(gpu_->picture_version);
    const bool is_other_light = side->band != gpu_->wavelength || session.polarimeter() != gpu_->polarimeter ||
                                session.view().convention != gpu_->convention;
    if (is_new) {
        gpu_->stokes.resize(picture.width, picture.height);
        gpu_->left_out.resize(picture.width, picture.height);
        for (FloatTexture& channel : gpu_->color) channel.resize(picture.width, picture.height);
        gpu_->light_left.clear();
        gpu_->color_left.clear();
    }
    gpu_->layout = document->picture_layout();
    gpu_->picture_version = document->picture_version();
    gpu_->wavelength = side->band;
    gpu_->polarimeter = session.polarimeter();
    gpu_->convention = session.view().convention;
    if (is_other_light) {
        gpu_->light_left.clear();
        add_strips(gpu_->light_left, everything, everything, 1);
    }
    for (const TileRect& rect : changes) {
        if (!is_other_light) add_strips(gpu_->light_left, rect, everything, 1);
        add_strips(gpu_->color_left, rect, everything, picture.bands.size());
    }

    const ShownPicture shown = shown_on(*side, session);
    const std::vector<Rgb> weights = band_colors(picture.bands);
    const auto write_light = [&](const TileRect& rect) {
        const LightFloats floats = light_floats(shown, gpu_->wavelength, rect);
        gpu_->stokes.write(rect, floats.stokes);
        gpu_->left_out.write(rect, floats.left_out);
    };
    const auto write_color = [&](const TileRect& rect) {
        const ColorFloats floats = color_floats(picture, weights, rect);
        for (std::size_t c = 0; c < floats.size(); ++c) gpu_->color[c].write(rect, floats[c]);
    };
    const auto begin = std::chrono::steady_clock::now();
    bool is_time_over = false;  // one strip is always written
    const auto write = [&](std::deque<TileRect>& left, const auto& write_one) {
        while (!left.empty() && !is_time_over) {
            write_one(left.front());
            left.pop_front();
            gpu_->drawn.reset();
            is_time_over = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >= seconds;
        }
    };
    // What is on screen comes first.
    const bool is_color = session.view().quantity == Quantity::color;
    if (is_color) write(gpu_->color_left, write_color);
    write(gpu_->light_left, write_light);
    if (!is_color) write(gpu_->color_left, write_color);
    upload_difference(session, *side);
    return !gpu_->light_left.empty() || !gpu_->color_left.empty();
}

void PictureRenderer::upload_difference(const Session& session, const ShownSide& side) {
    const ShownMap& map = session.shown_map();
    if (!side.is_difference) {
        gpu_->difference_version.reset();
        return;
    }
    if (gpu_->difference_version == map.version()) return;
    gpu_->difference_version = map.version();
    gpu_->drawn.reset();
    const StokesImage& picture = side.document->picture();
    std::vector<Float4> floats(picture.pixel_count(), Float4{});
    if (map.values().size() == floats.size()) {
        // A row that was not looked at yet is shown as the one above it: coarse first, like the picture.
        int known = 0;
        for (int y = 0; y < picture.height; ++y) {
            if (map.knows_row(y)) known = y;
            if (!map.knows_row(known)) continue;
            for (int x = 0; x < picture.width; ++x) {
                const std::size_t from = picture.pixel(x, known);
                floats[picture.pixel(x, y)] =
                    to_single(map.values()[from], map.weights()[from], static_cast<double>(map.states()[from]), 1.0);
            }
        }
    }
    gpu_->difference.resize(picture.width, picture.height);
    gpu_->difference.write({0, 0, picture.width, picture.height}, floats);
}

std::uint32_t PictureRenderer::render(const Session& session, int width, int height, double pixel_ratio) {
    const auto side = session.side(gpu_->side);
    if (!side || gpu_->layout != side->document->picture_layout()) {
        gpu_->drawn.reset();
        gpu_->target.begin(width, height);
        glClearColor(background[0], background[1], background[2], background[3]);
        glClear(GL_COLOR_BUFFER_BIT);
        RenderTarget::end();
        return gpu_->target.texture();
    }
    const DrawnView drawn = what_to_draw(session, *side, width, height, pixel_ratio);
    if (gpu_->drawn == drawn) return gpu_->target.texture();
    gpu_->drawn = drawn;
    if (!gpu_->programs.contains(drawn.variant)) {
        // Variants differ by constants only, so they all compile if the first one did.
        auto program = program_for(drawn.variant);
        POL_EXPECTS(program);
        gpu_->programs.emplace(drawn.variant, std::move(program).value());
    }
    const Program& program = gpu_->programs.at(drawn.variant);

    gpu_->target.begin(width, height);
    if (gpu_->scale_shown != drawn.scale) write_scale(gpu_->scale, drawn.scale);
    gpu_->scale_shown = drawn.scale;
    gpu_->stokes.bind(unit_stokes);
    gpu_->left_out.bind(unit_left_out);
    gpu_->color[0].bind(unit_red);
    gpu_->color[1].bind(unit_green);
    gpu_->color[2].bind(unit_blue);
    gpu_->scale.bind(unit_scale);
    gpu_->difference.bind(unit_difference);
    program.use();
    set_uniforms(program, drawn);
    glBindVertexArray(gpu_->no_vertices.id());
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    draw_fullscreen();
    RenderTarget::end();
    glBindVertexArray(0);
    return gpu_->target.texture();
}

}  // namespace pol
