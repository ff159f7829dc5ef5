// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/array_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/contract.h"
#include "core/join.h"
#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

/// Names of the bands that an array has no names for.
std::vector<Band> numbered_bands(std::uint64_t count, StokesComponents known) {
    std::vector<Band> bands;
    for (std::uint64_t b = 0; b < count; ++b) bands.push_back(named_band(std::to_string(b + 1), known));
    return bands;
}

std::vector<Band> color_bands(StokesComponents known) {
    return {named_band("R", known), named_band("G", known), named_band("B", known)};
}

enum class Role { row, column, stokes, band, bgr, channel };

/// A row of the table of shapes that scripts around Mitsuba, polanalyser and torch save.
struct Form {
    std::string_view name;
    std::string_view text;
    std::vector<Role> roles;
    bool (*may_be)(const ArrayShape&);  ///< the shape alone suggests it
    bool (*fits)(const ArrayShape&);    ///< it is possible, if asked for
    std::string_view assumed;           ///< beside assumed_frame
};

bool is_stokes(std::uint64_t length) {
    return length == 3 || length == 4;
}
bool is_tensor(std::uint64_t length) {
    return length >= 12 && length <= 16;
}

/// More than 64 bands of at most 64 columns are rather rows with bands behind the columns.
bool has_bands_behind(const ArrayShape& shape) {
    constexpr std::uint64_t most_bands = 64;
    return shape[0] > most_bands && shape[2] <= most_bands;
}

const std::vector<Form>& forms() {
    using Shape = ArrayShape;
    static const std::vector<Form> all{
        {"hwc",
         "rows, columns, Stokes",
         {Role::row, Role::column, Role::stokes},
         // (4, H, 3) is planes: a picture four rows high is rarer than one of three columns in a test.
         [](const Shape& s) { return s.size() == 3 && (s[2] == 4 || (s[2] == 3 && s[0] != 4)); },
         [](const Shape& s) { return s.size() == 3 && is_stokes(s[2]); },
         {}},
        {"chw",
         "Stokes, rows, columns",
         {Role::stokes, Role::row, Role::column},
         [](const Shape& s) { return s.size() == 3 && s[0] == 4; },
         [](const Shape& s) { return s.size() == 3 && is_stokes(s[0]); },
         {}},
        {"tensor",
         "rows, columns, channels of a Mitsuba tensor",
         {Role::row, Role::column, Role::channel},
         [](const Shape& s) { return s.size() == 3 && is_tensor(s[2]); },
         [](const Shape& s) { return s.size() == 3 && is_tensor(s[2]); },
         "The last 12 numbers of a pixel are S0.R S0.G S0.B S1.R ... S3.B, as Mitsuba's integrator 'stokes' orders "
         "them: they have no names here."},
        {"bgr",
         "rows, columns, blue green red, Stokes",
         {Role::row, Role::column, Role::bgr, Role::stokes},
         [](const Shape& s) { return s.size() == 4 && s[2] == 3 && is_stokes(s[3]); },
         [](const Shape& s) { return s.size() == 4 && s[2] == 3 && is_stokes(s[3]); },
         "The third axis is blue, green, red, as polanalyser and OpenCV order colors. If the polarizer angles were "
         "calibrated with y down, S2 has the other sign."},
        {"nhwc",
         "bands, rows, columns, Stokes",
         {Role::band, Role::row, Role::column, Role::stokes},
         [](const Shape& s) { return s.size() == 4 && s[3] == 4 && s[2] != 3 && !has_bands_behind(s); },
         [](const Shape& s) { return s.size() == 4 && is_stokes(s[3]); },
         {}},
        {"hwnc",
         "rows, columns, bands, Stokes",
         {Role::row, Role::column, Role::band, Role::stokes},
         [](const Shape& s) { return s.size() == 4 && s[3] == 4 && s[2] != 3 && has_bands_behind(s); },
         [](const Shape& s) { return s.size() == 4 && is_stokes(s[3]); },
         "The third axis is the bands: as the first one it would be too many (--layout nhwc if it is)."},
    };
    return all;
}

/// Pictures four columns wide, or the Mueller matrices of a row or a picture of pixels.
bool may_be_matrices(const ArrayShape& shape) {
    const std::size_t axes = shape.size();
    return (axes == 3 || axes == 4) && shape[axes - 2] == 4 && shape[axes - 1] == 4;
}

Result<const Form*> form_of(const ArrayShape& shape, std::string_view asked) {
    if (!asked.empty()) {
        for (const Form& form : forms()) {
            if (form.name != asked) continue;
            if (form.fits(shape)) return &form;
            return usage_error(fmt::format("an array of shape {} is not {}: {}", shape_text(shape), asked, form.text),
                               "leave --layout out to see what it may be");
        }
        return usage_error(fmt::format("the layout '{}' is not one of arrays", asked),
                           "of arrays: hwc, chw, tensor, bgr, nhwc, hwnc");
    }
    std::vector<std::string> names;
    const Form* found = nullptr;
    for (const Form& form : forms()) {
        if (!form.may_be(shape)) continue;
        found = &form;
        names.push_back(fmt::format("{} ({})", form.name, form.text));
    }
    if (names.empty())
        return input_error(
            fmt::format("an array of shape {} is not known as a Stokes picture", shape_text(shape)),
            "(H, W, 3), (H, W, 4), (4, H, W), (H, W, 12 to 16), (H, W, 3, 3), (H, W, 3, 4) and (n, H, W, 4) are; "
            "planes of one component go with --stokes s0=FILE,...");
    if (names.size() == 1 && may_be_matrices(shape)) names.emplace_back("Mueller matrices, which are not read");
    if (names.size() > 1)
        return input_error(fmt::format("an array of shape {} can be {}", shape_text(shape), join(names, " or ")),
                           fmt::format("say which with --layout, for example --layout {}", found->name));
    return found;
}

std::vector<AxisStep> even_steps(std::uint64_t count, std::size_t stride) {
    std::vector<AxisStep> steps;
    for (std::size_t i = 0; i < count; ++i) steps.push_back({i * stride, 0});
    return steps;
}

/// The last 12 of a pixel are components of colors; what stands before them is none of the picture's.
std::vector<AxisStep> tensor_steps(std::uint64_t count, std::size_t pixels) {
    std::vector<AxisStep> steps(count - 12, AxisStep{0, 4});
    for (unsigned component = 0; component < 4; ++component)
        for (std::size_t color = 0; color < 3; ++color) steps.push_back({color * pixels, component});
    return steps;
}

}  // namespace

std::string shape_text(const ArrayShape& shape) {
    std::string text;
    for (const std::uint64_t length : shape) text += fmt::format("{}{}", text.empty() ? "" : ", ", length);
    return fmt::format("({}{})", text, shape.size() == 1 ? "," : "");
}

std::optional<std::uint64_t> number_count(const ArrayShape& shape) {
    std::uint64_t count = 1;
    for (const std::uint64_t length : shape) {
        if (length != 0 && count > (std::uint64_t{1} << 63U) / length) return std::nullopt;
        count *= length;
    }
    return count;
}

Result<Done> check_picture_size(std::uint64_t width, std::uint64_t height, std::uint64_t bands) {
    if (width == 0 || height == 0 || bands == 0) return input_error("has no pixel", "is it the right file?");
    constexpr std::uint64_t longest = std::numeric_limits<int>::max();
    constexpr double stokes_bytes = sizeof(Stokes<double>);
    const double bytes =
        static_cast<double>(width) * static_cast<double>(height) * static_cast<double>(bands) * stokes_bytes;
    if (width > longest || height > longest || bytes > max_picture_bytes)
        return input_error(fmt::format("{} x {} pixels in {} bands are more than {:.0f} GiB in memory", width, height,
                                       bands, max_picture_bytes / 0x1p30),
                           "cut a smaller picture out of it");
    return Done{};
}

Result<ArrayLayout> array_layout(const ArrayShape& shape, std::string_view asked) {
    POL_TRY(const Form* const form, form_of(shape, asked));
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t bands = 1;
    StokesComponents known = StokesComponents::all();
    ArrayLayout layout;
    for (std::size_t axis = 0; axis < shape.size(); ++axis) {
        switch (form->roles[axis]) {
            case Role::row:
                height = shape[axis];
                break;
            case Role::column:
                width = shape[axis];
                break;
            case Role::band:
            case Role::bgr:
                bands = shape[axis];
                break;
            case Role::stokes:
                if (shape[axis] == 3) known = StokesComponents::linear();
                break;
            case Role::channel:
                bands = 3;
                break;
        }
    }
    POL_TRY_DONE(check_picture_size(width, height, bands));
    StokesImage& image = layout.image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.origin.layout = fmt::format("array {}: {}", shape_text(shape), form->text);
    image.origin.assumed.emplace_back(assumed_frame);
    if (!form->assumed.empty()) image.origin.assumed.emplace_back(form->assumed);
    image.bands = numbered_bands(bands, known);
    if (form->roles.size() == 3 && bands == 1) image.bands = {named_band("mono", known)};
    const std::size_t pixels = image.pixel_count();
    for (std::size_t axis = 0; axis < shape.size(); ++axis) {
        const std::uint64_t length = shape[axis];
        switch (form->roles[axis]) {
            case Role::row:
                layout.axes.push_back(even_steps(length, width));
                break;
            case Role::column:
                layout.axes.push_back(even_steps(length, 1));
                break;
            case Role::band:
                layout.axes.push_back(even_steps(length, pixels));
                break;
            case Role::bgr:
                layout.axes.push_back({{2 * pixels, 0}, {pixels, 0}, {0, 0}});
                image.bands = color_bands(known);
                break;
            case Role::stokes:
                layout.axes.push_back({{0, 0}, {0, 1}, {0, 2}});
                if (length == 4) layout.axes.back().push_back({0, 3});
                break;
            case Role::channel:
                layout.axes.push_back(tensor_steps(length, pixels));
                image.bands = color_bands(known);
                layout.may_be_mono = true;
                break;
        }
    }
    return layout;
}

Result<ArrayLayout> plane_layout(const ArrayShape& shape, unsigned component) {
    const bool in_color = shape.size() == 3 && shape[2] == 3;
    if (shape.size() != 2 && !in_color)
        return input_error(fmt::format("an array of shape {} is not one component of a picture", shape_text(shape)),
                           "(H, W), or (H, W, 3) for R, G and B");
    POL_TRY_DONE(check_picture_size(shape[1], shape[0], in_color ? 3 : 1));
    ArrayLayout layout;
    StokesImage& image = layout.image;
    image.width = static_cast<int>(shape[1]);
    image.height = static_cast<int>(shape[0]);
    image.bands =
        in_color ? color_bands(StokesComponents()) : std::vector<Band>{named_band("mono", StokesComponents())};
    for (Band& band : image.bands) band.known = band.known.with(component);
    layout.axes = {even_steps(shape[0], shape[1]), even_steps(shape[1], 1)};
    if (in_color) layout.axes.push_back(even_steps(3, image.pixel_count()));
    for (AxisStep& step : layout.axes[0]) step.component = component;
    return layout;
}

Result<Done> read_numbers(ByteSource& bytes, const NumberFormat& format, const ArrayLayout& layout, bool fortran_order,
                          StokesImage& image, const ReadProgress& progress) {
    std::vector<const std::vector<AxisStep>*> axes;  // the fastest first
    for (const std::vector<AxisStep>& axis : layout.axes) {
        POL_EXPECTS(!axis.empty());
        axes.push_back(&axis);
    }
    if (!fortran_order) std::reverse(axes.begin(), axes.end());
    std::uint64_t count = 1;
    for (const auto* axis : axes) count *= axis->size();

    constexpr std::uint64_t numbers_at_once = 1U << 16U;
    std::vector<char> chunk(numbers_at_once * format.bytes());
    std::vector<std::size_t> at(axes.size(), 0);
    for (std::uint64_t done = 0; done < count;) {
        const auto numbers = static_cast<std::size_t>(std::min(numbers_at_once, count - done));
        if (!bytes.read(chunk.data(), numbers * format.bytes()))
            return input_error("ends too early, or is damaged", "copy or save it again");
        for (std::size_t i = 0; i < numbers; ++i) {
            AxisStep to;
            for (std::size_t axis = 0; axis < axes.size(); ++axis) {
                const AxisStep& step = (*axes[axis])[at[axis]];
                to.value += step.value;
                to.component += step.component;
            }
            if (to.component < stokes_components.size())
                image.stokes[to.value].*stokes_components[to.component] = format.at(chunk.data() + i * format.bytes());
            for (std::size_t axis = 0; axis < axes.size() && ++at[axis] == axes[axis]->size(); ++axis) at[axis] = 0;
        }
        done += numbers;
        if (progress && !progress(static_cast<double>(done) / static_cast<double>(count))) return was_stopped();
    }
    return Done{};
}

}  // namespace pol
