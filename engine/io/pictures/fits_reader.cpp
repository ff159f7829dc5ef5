// SPDX-License-Identifier: Apache-2.0
// Stokes cubes of radio astronomy: FITS 4.0 (Pence et al. 2010), the first array of a file, with an axis CTYPEn =
// 'STOKES'. Blocks of 2880 bytes, cards of 80; numbers are big-endian and the first row is the bottom one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/number_text.h"
#include "io/pictures/array_layout.h"
#include "io/pictures/convention_text.h"
#include "io/pictures/fits_format.h"
#include "io/pictures/picture_reading.h"
#include "io/pictures/stored_precision.h"

namespace pol {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(begin);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// Values of the cards by keyword, as written, without quotes and comments.
class Cards {
public:
    static Result<Cards> read(FileBytes& file) {
        constexpr std::size_t most_blocks = 1000;
        Cards cards;
        for (std::size_t block = 0; block < most_blocks; ++block) {
            std::array<char, fits::block_size> bytes{};
            if (!file.read(bytes.data(), bytes.size())) break;
            for (std::size_t at = 0; at < bytes.size(); at += fits::card_size) {
                const std::string_view card(bytes.data() + at, fits::card_size);
                const std::string_view keyword = trimmed(card.substr(0, 8));
                if (keyword == "END") return cards;
                if (card.substr(8, 2) == "= ") cards.values_.emplace(keyword, value_of(card.substr(10)));
            }
        }
        return input_error("ends within its header", "copy or save it again");
    }

    [[nodiscard]] std::string text(const std::string& keyword) const {
        const auto found = values_.find(keyword);
        return found == values_.end() ? std::string() : found->second;
    }
    [[nodiscard]] bool has(const std::string& keyword) const { return values_.count(keyword) > 0; }
    [[nodiscard]] Result<double> number(const std::string& keyword, double otherwise) const {
        if (!has(keyword)) return otherwise;
        std::string word = text(keyword);
        std::replace(word.begin(), word.end(), 'D', 'E');  // Fortran's double
        double number = 0.0;
        const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
        const auto [end, status] = std::from_chars(begin, word.data() + word.size(), number);
        if (status != std::errc() || end != word.data() + word.size() || !std::isfinite(number))
            return input_error(fmt::format("its card {} is no number: '{}'", keyword, word), "save it again");
        return number;
    }
    /// From 0 to `most`.
    [[nodiscard]] Result<std::uint64_t> whole(const std::string& keyword, std::uint64_t most) const {
        POL_TRY(const double value, number(keyword, -1.0));
        if (!(value >= 0.0) || value > static_cast<double>(most) || value != std::floor(value))
            return input_error(fmt::format("its card {} is missing or no size: '{}'", keyword, text(keyword)),
                               "save it again");
        return static_cast<std::uint64_t>(value);
    }

private:
    static std::string value_of(std::string_view field) {
        field = trimmed(field);
        if (!field.starts_with('\'')) return std::string(trimmed(field.substr(0, field.find('/'))));
        std::string value;
        for (std::size_t i = 1; i < field.size(); ++i) {
            if (field[i] == '\'' && (i + 1 == field.size() || field[i + 1] != '\'')) break;
            if (field[i] == '\'') ++i;
            value += field[i];
        }
        return std::string(trimmed(value));
    }
    std::map<std::string, std::string, std::less<>> values_;
};

Result<NumberFormat> number_format(const Cards& cards) {
    using Kind = NumberFormat::Kind;
    constexpr std::array<std::pair<int, Kind>, 5> known{
        {{8, Kind::unsigned8}, {16, Kind::signed16}, {32, Kind::signed32}, {-32, Kind::float32}, {-64, Kind::float64}}};
    POL_TRY(const double bits, cards.number("BITPIX", 0.0));
    for (const auto& [code, kind] : known)
        if (bits == code) {
            const NumberFormat format{kind, std::endian::big};
            if (format.is_whole() && cards.has("BLANK"))
                return input_error("has blank pixels among whole numbers (BLANK)", "save it as 32-bit floats");
            return format;
        }
    return input_error(fmt::format("holds numbers of BITPIX {}", cards.text("BITPIX")),
                       "8, 16, 32, -32 and -64 are read");
}

/// Component of each place on the axis.
Result<std::vector<unsigned>> stokes_of(const Cards& cards, const std::string& axis, std::uint64_t length) {
    constexpr std::array<std::string_view, 8> others{"RR", "LL", "RL", "LR", "XX", "YY", "XY", "YX"};
    POL_TRY(const double value, cards.number("CRVAL" + axis, 1.0));
    POL_TRY(const double place, cards.number("CRPIX" + axis, 1.0));
    POL_TRY(const double step, cards.number("CDELT" + axis, 1.0));
    std::vector<unsigned> components;
    for (std::uint64_t i = 1; i <= length; ++i) {
        const double code = value + (static_cast<double>(i) - place) * step;
        if (code <= -1.0 && code >= -8.0 && code == std::round(code))
            return input_error(
                fmt::format("has the correlations {} of two receivers (STOKES {}), not Stokes parameters",
                            others[static_cast<std::size_t>(-code) - 1], number_text(code)),
                "make I, Q, U and V of RR, LL, RL and LR, or of XX, YY, XY and YX, first");
        if (!(code >= 1.0 && code <= 4.0) || code != std::round(code))
            return input_error(fmt::format("has a plane with the STOKES code {}", number_text(code)),
                               "1, 2, 3 and 4 (I, Q, U and V) are read");
        const auto component = static_cast<unsigned>(code) - 1;
        if (std::find(components.begin(), components.end(), component) != components.end())
            return input_error("has a Stokes parameter twice", "save each once");
        components.push_back(component);
    }
    if (std::find(components.begin(), components.end(), 0U) == components.end())
        return input_error("has no I", "without it no other component means anything");
    return components;
}

/// What the sky's axes are to ours. A picture without them is taken as ours.
void note_convention(const Cards& cards, PictureOrigin& origin) {
    const auto begins = [&cards](const std::string& keyword, std::initializer_list<std::string_view> words) {
        const std::string type = cards.text(keyword);
        return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return type.starts_with(word); });
    };
    if (const auto ours = convention_of(cards.text(fits::convention_keyword))) {
        origin.convention = *ours;
        return;
    }
    if (!begins("CTYPE1", {"RA--", "GLON", "ELON"}) || !begins("CTYPE2", {"DEC-", "GLAT", "ELAT"})) {
        origin.assumed.emplace_back(
            "The azimuth counts from image right, counter-clockwise for the receiver, and S3 > 0 is right-handed: "
            "without axes on the sky, FITS does not say.");
        return;
    }
    const bool cosmo = cards.text("POLCCONV") == "COSMO";
    // IAU: angle from north (up) through east (left), V > 0 counter-clockwise for the receiver: S1, S2, S3 = -Q, -U,
    // -V.
    origin.convention = {true, false, 90.0};
    if (cosmo) origin.convention = {false, true, 90.0};  // U has the other sign: -Q, U, -V
    origin.assumed.push_back(fmt::format(
        "Q and U count from north {} ({}); V > 0 turns counter-clockwise for the receiver: observatories differ in the "
        "sign of V.",
        cosmo ? "through west" : "through east", cosmo ? "POLCCONV is COSMO" : "IAU"));
    const auto x = cards.number("CDELT1", -1.0);
    const auto y = cards.number("CDELT2", 1.0);
    const auto turn = cards.number("CROTA2", 0.0);
    if (!x || !y || !turn || !(x.value() < 0.0) || !(y.value() > 0.0) || turn.value() != 0.0)
        origin.remarks.emplace_back(
            "North is not up or east not left (CDELT, CROTA2): the azimuth is that of the sky, not of the picture.");
}

/// One band for each place on an axis that is neither of the picture nor STOKES.
Result<std::vector<Band>> bands_of(const Cards& cards, const std::string& axis, std::uint64_t length,
                                   StokesComponents known) {
    std::vector<Band> bands;
    if (axis.empty()) return std::vector<Band>{named_band("mono", known)};
    POL_TRY(const double value, cards.number("CRVAL" + axis, 1.0));
    POL_TRY(const double place, cards.number("CRPIX" + axis, 1.0));
    POL_TRY(const double step, cards.number("CDELT" + axis, 1.0));
    const std::string type = cards.text("CTYPE" + axis);
    const std::string unit = cards.text("CUNIT" + axis);
    for (std::uint64_t i = 1; i <= length; ++i) {
        const double number = value + (static_cast<double>(i) - place) * step;
        const std::string keyword = fmt::format("{}{}", fits::band_keyword, i);
        bands.push_back(named_band(
            fmt::format("{} {}{}{}", type.empty() ? "band" : type, number_text(number), unit.empty() ? "" : " ", unit),
            known));
        if (!cards.has(keyword)) continue;
        const std::string name = cards.text(keyword);
        double nm = 0.0;
        const auto [end, status] = std::from_chars(name.data(), name.data() + name.size(), nm);
        if (status == std::errc() && std::string_view(end) == " nm" && nm > 0.0 && std::isfinite(nm))
            bands.back() = {nm, {}, known};
        else
            bands.back().name = name;
    }
    double last = 0.0;
    for (const Band& band : bands)
        if (band.wavelength_nm && !(*band.wavelength_nm > std::exchange(last, *band.wavelength_nm)))
            return input_error("its wavelengths do not ascend", "save the bands in their order");
    return bands;
}

struct Cube {
    ArrayLayout layout;
    NumberFormat format;
    double scale = 1.0;
    double zero = 0.0;
};

Result<Cube> cube_of(const Cards& cards, const FileBytes& file) {
    Cube cube;
    POL_TRY(cube.format, number_format(cards));
    POL_TRY(cube.scale, cards.number("BSCALE", 1.0));
    POL_TRY(cube.zero, cards.number("BZERO", 0.0));
    constexpr std::uint64_t most_axes = 9;
    POL_TRY(const std::uint64_t axes, cards.whole("NAXIS", 999));
    if (axes < 2 || axes > most_axes)
        return input_error(fmt::format("its first array has {} axes, and only that one is read", axes),
                           "save a picture with an axis STOKES there");
    ArrayShape shape;
    std::string stokes_axis;
    std::string band_axis;
    for (std::uint64_t n = 1; n <= axes; ++n) {
        const std::string axis = std::to_string(n);
        POL_TRY(shape.emplace_back(), cards.whole("NAXIS" + axis, std::uint64_t{1} << 31U));
        if (n > 2 && cards.text("CTYPE" + axis) == "STOKES") {
            stokes_axis = axis;
        } else if (n > 2 && (shape.back() > 1 || band_axis.empty())) {
            if (shape.back() > 1 && !band_axis.empty() && shape[std::stoul(band_axis) - 1] > 1)
                return input_error("has more than one axis besides the picture's and STOKES",
                                   "save a cube with one of them");
            band_axis = axis;
        }
    }
    if (stokes_axis.empty())
        return input_error(
            "has no axis STOKES behind the two of the picture, so that nothing says what its numbers are",
            "CTYPE3 = 'STOKES' with the codes 1 to 4");
    const std::optional<std::uint64_t> count = number_count(shape);
    if (!count || *count > file.left() / cube.format.bytes())
        return input_error(
            fmt::format("promises an array of {}, but only {} bytes follow", shape_text(shape), file.left()),
            "copy or save it again");
    POL_TRY(const std::vector<unsigned> components, stokes_of(cards, stokes_axis, shape[std::stoul(stokes_axis) - 1]));
    StokesComponents known;
    for (const unsigned component : components) known = known.with(component);
    const std::uint64_t bands = band_axis.empty() ? 1 : shape[std::stoul(band_axis) - 1];
    POL_TRY_DONE(check_picture_size(shape[0], shape[1], bands));

    StokesImage& image = cube.layout.image;
    image.width = static_cast<int>(shape[0]);
    image.height = static_cast<int>(shape[1]);
    POL_TRY(image.bands, bands_of(cards, band_axis, bands, known));
    note_precision(image, cube.format);
    image.stored.spacing *= std::abs(cube.scale);
    image.origin.layout = "FITS";
    note_convention(cards, image.origin);
    const std::size_t width = shape[0];
    for (std::uint64_t n = 1; n <= axes; ++n) {
        std::vector<AxisStep> steps;
        for (std::size_t i = 0; i < shape[n - 1]; ++i) {
            if (n == 1)
                steps.push_back({i, 0});
            else if (n == 2)  // the first row is the bottom one
                steps.push_back({(shape[1] - 1 - i) * width, 0});
            else if (std::to_string(n) == stokes_axis)
                steps.push_back({0, components[i]});
            else
                steps.push_back({i * image.pixel_count(), 0});
        }
        cube.layout.axes.push_back(std::move(steps));
    }
    return cube;
}

}  // namespace

Result<UnfilledPicture> open_fits(const std::filesystem::path& path) {
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(path, failed);
    if (failed) return input_error("cannot be read", "check its permissions");
    const auto file = std::make_shared<FileBytes>(path, 0, size);
    POL_TRY(const Cards cards, Cards::read(*file));
    POL_TRY(const Cube cube, cube_of(cards, *file));
    return UnfilledPicture{cube.layout.image,
                           [file, cube](StokesImage& target, const ReadProgress& progress) -> Result<Done> {
                               // NAXIS1 changes fastest, as the first axis does in Fortran's order.
                               POL_TRY_DONE(read_numbers(*file, cube.format, cube.layout, true, target, progress));
                               const bool scaled = cube.scale != 1.0 || cube.zero != 0.0;
                               const StokesComponents known = target.bands.front().known;
                               for (Stokes<double>& s : target.stokes) {
                                   if (scaled) {
                                       s.s0 = cube.scale * s.s0 + cube.zero;
                                       if (known.has(1)) s.s1 = cube.scale * s.s1 + cube.zero;
                                       if (known.has(2)) s.s2 = cube.scale * s.s2 + cube.zero;
                                       if (known.has(3)) s.s3 = cube.scale * s.s3 + cube.zero;
                                   }
                                   s = target.origin.convention.to_ours(s);
                               }
                               return Done{};
                           }};
}

}  // namespace pol
