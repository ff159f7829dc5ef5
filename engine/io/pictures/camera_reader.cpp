// SPDX-License-Identifier: Apache-2.0
// Pictures of polarization cameras: four photographs behind polarizers, or behind any number of them, and the mosaic of
// Sony's sensors (IMX250MZR: rows 90 45 / 135 0, as elerac/polanalyser has it); a lone photograph is S0.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/join.h"
#include "core/number_text.h"
#include "io/pictures/photograph.h"
#include "io/pictures/picture_reading.h"
#include "io/pictures/polarizer_angles.h"
#include "spectrum/color.h"

namespace pol {

namespace {

namespace fs = std::filesystem;

constexpr std::array<double, 4> set_angles{0.0, 45.0, 90.0, 135.0};

/// What the header tells of how far numbers are from light.
void note_header(const Photograph& photo, PictureOrigin& origin) {
    if (photo.says_encoded)
        origin.remarks.emplace_back(
            "S1 and S2 are meaningless in gamma-encoded files, and this file says that it is one (gAMA or sRGB "
            "chunk).");
    else if (!photo.says_linear)
        origin.assumed.emplace_back("The numbers are proportional to light: the PNG does not say so (no gAMA of 1.0).");
    if (!photo.scale)
        origin.assumed.emplace_back("The largest number of the format is 1: the unit of light is unknown.");
    if (photo.has_alpha) origin.remarks.emplace_back("Transparency (the alpha channel) is left out.");
}

/// What the numbers tell of themselves.
void note_codes(const std::vector<std::uint16_t>& codes, std::uint32_t most, StokesImage& image) {
    PictureOrigin& origin = image.origin;
    const std::uint32_t power = common_power_of_two(codes);
    const std::uint32_t bits = (most == 255 ? 8U : 16U) - static_cast<std::uint32_t>(std::countr_zero(power));
    image.stored.spacing *= power;
    if (power > 1)
        origin.remarks.push_back(
            fmt::format("All numbers are multiples of {}: numbers of {} bits in the high bits. The whole range of {} "
                        "counts as full.",
                        power, bits, most));
    const auto full =
        std::count_if(codes.begin(), codes.end(), [&](std::uint16_t code) { return code >= most - (power - 1); });
    if (full > 0)
        origin.remarks.push_back(
            fmt::format("{} numbers are at the upper end of the range: there may have been more light, and S0, S1 and "
                        "S2 are wrong.",
                        full));
}

StokesImage picture_like(const Photograph& photo, int width, int height, std::vector<Band> bands, std::string layout) {
    StokesImage image;
    image.width = width;
    image.height = height;
    image.bands = std::move(bands);
    image.origin.layout = std::move(layout);
    image.origin.assumed.emplace_back(
        "The polarizer angles count from image right, counter-clockwise for the camera; with angles that were "
        "calibrated with y down, S2 has the other sign.");
    note_header(photo, image.origin);
    return image;
}

std::string missing_s3() {
    return "Linear polarizers measure no S3: it is unknown, not 0.";
}

/// Root mean square of what the fit leaves, relative to the mean S0.
struct Misfit {
    double squares = 0.0;
    double light = 0.0;
    std::size_t numbers = 0;

    [[nodiscard]] std::optional<double> relative() const {
        if (numbers == 0 || !(light > 0.0)) return std::nullopt;
        const auto count = static_cast<double>(numbers);
        return std::sqrt(squares / count) / (light / count);
    }
};

void note_misfit(const Misfit& misfit, bool is_four, PictureOrigin& origin) {
    const auto relative = misfit.relative();
    if (!relative) return;
    origin.remarks.push_back(fmt::format(
        "{} is {:.2g} % of S0 (root mean square): noise, and what the camera does wrong.",
        is_four ? "The residual of the four angles, I0 + I90 - I45 - I135," : "What the fit of the angles leaves",
        100.0 * *relative));
}

/// StoredNumbers::spacing of the component that adds up the most light.
double spacing_of(const Photograph& photo, const AngleFit& fit) {
    double most = 0.0;
    for (const std::vector<double>& weights : fit.weights) {
        double sum = 0.0;
        for (const double weight : weights) sum += std::abs(weight);
        most = std::max(most, sum);
    }
    return most * photo.scale.value_or(1.0) / photo.most;
}

/// One pixel and band from its light at the angles.
Stokes<double> fitted(const AngleFit& fit, const std::vector<double>& light, bool is_four, Misfit& misfit) {
    std::array<double, 3> s{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < light.size(); ++k) s[i] += fit.weights[i][k] * light[k];
    double squares = 0.0;
    if (is_four) {
        const double residual = light[0] + light[2] - light[1] - light[3];
        squares = residual * residual;
    } else {
        for (std::size_t k = 0; k < light.size(); ++k) {
            const double left = light[k] - (s[0] + s[1] * fit.cosine[k] + s[2] * fit.sine[k]) / 2.0;
            squares += left * left / static_cast<double>(light.size());
        }
    }
    misfit.squares += squares;
    misfit.light += s[0];
    ++misfit.numbers;
    return {s[0], s[1], s[2], 0.0};
}

/// "x_045.png" ends in the second of four angles, written in three digits.
struct SetName {
    std::string stem;    ///< "x_"
    std::string ending;  ///< ".png"
    bool three_digits = false;
};

fs::path member_of(const fs::path& path, const SetName& name, double angle) {
    return path.parent_path() /
           (name.stem + (name.three_digits ? fmt::format("{:03.0f}", angle) : fmt::format("{:.0f}", angle)) +
            name.ending);
}

/// Whether at least as many photographs of the set are there under names of three digits as under short ones.
bool has_more_in_three_digits(const fs::path& path, SetName name) {
    const auto those_there = [&](bool three) {
        name.three_digits = three;
        return std::count_if(set_angles.begin(), set_angles.end(), [&](double angle) {
            std::error_code failed;
            return fs::is_regular_file(member_of(path, name, angle), failed);
        });
    };
    return those_there(true) >= those_there(false);
}

std::optional<SetName> set_name(const fs::path& path) {
    const std::string stem = path.stem().string();
    for (const bool three : {true, false})
        for (const double angle : set_angles) {
            const std::string digits = three ? fmt::format("_{:03.0f}", angle) : fmt::format("_{:.0f}", angle);
            if (!stem.ends_with(digits)) continue;
            SetName name{stem.substr(0, stem.size() - digits.size() + 1), path.extension().string(), three};
            // 135 is written alike in both: those beside it tell which.
            if (three && angle == set_angles.back()) name.three_digits = has_more_in_three_digits(path, name);
            return name;
        }
    return std::nullopt;
}

Result<UnfilledPicture> open_photographs(const std::vector<fs::path>& files, const std::vector<double>& angles,
                                         std::string layout) {
    POL_TRY(const AngleFit fit, fit_angles(angles));
    std::optional<Photograph> first;
    for (const fs::path& file : files) {
        POL_TRY(const Photograph photo, read_photograph(file, false));
        if (!first) first = photo;
        if (photo.width != first->width || photo.height != first->height || photo.channels != first->channels ||
            photo.most != first->most || photo.scale != first->scale)
            return input_error(
                fmt::format("has another size or another kind of numbers than {}", files.front().string()),
                "the photographs of a set differ in the polarizer only", file);
    }
    StokesImage image =
        picture_like(*first, first->width, first->height, first->bands(StokesComponents::linear()), std::move(layout));
    image.stored.spacing = spacing_of(*first, fit);
    image.origin.remarks.push_back(missing_s3());
    return UnfilledPicture{
        image,
        [files, fit, is_four = std::equal(angles.begin(), angles.end(), set_angles.begin(), set_angles.end())](
            StokesImage& target, const ReadProgress& progress) -> Result<Done> {
            std::vector<Photograph> photos;
            std::vector<std::uint16_t> all;
            for (const fs::path& file : files) {
                POL_TRY(photos.emplace_back(), read_photograph(file, true));
                all.insert(all.end(), photos.back().codes.begin(), photos.back().codes.end());
                if (progress && !progress(static_cast<double>(photos.size()) / static_cast<double>(files.size() + 1)))
                    return was_stopped();
            }
            const Photograph& first_photo = photos.front();
            const std::size_t pixels = target.pixel_count();
            for (const Photograph& photo : photos)
                if (photo.codes.size() != pixels * target.bands.size())
                    return input_error("has changed while it was read", "open it again");
            const double unit = first_photo.scale.value_or(1.0) / first_photo.most;
            Misfit misfit;
            std::vector<double> light(photos.size());
            for (std::size_t b = 0; b < target.bands.size(); ++b)
                for (std::size_t p = 0; p < pixels; ++p) {
                    for (std::size_t k = 0; k < photos.size(); ++k)
                        light[k] = unit * photos[k].codes[first_photo.at(p, b)];
                    target.stokes[b * pixels + p] = fitted(fit, light, is_four, misfit);
                }
            note_codes(all, first_photo.most, target);
            if (photos.size() > 3) note_misfit(misfit, is_four, target.origin);
            return Done{};
        }};
}

/// Which pixel of a cell of the mosaic has which angle: place as row, column.
constexpr std::array<std::array<std::size_t, 2>, 4> mosaic_places{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};

/// `in_color`: cells of one angle each under one color of R G / G B, 4 x 4 pixels in all (IMX250MYR).
Result<UnfilledPicture> open_mosaic(const fs::path& path, bool in_color) {
    POL_TRY(const Photograph photo, read_photograph(path, false));
    const int cell = in_color ? 4 : 2;
    if (photo.channels != 1)
        return input_error("is a colored picture, not the mosaic of a sensor", "save the raw picture, in gray", path);
    if (photo.width % cell != 0 || photo.height % cell != 0)
        return input_error(fmt::format("has {} x {} pixels, which are no whole cells of {} x {}", photo.width,
                                       photo.height, cell, cell),
                           "save the whole raw picture", path);
    Photograph shape = photo;
    shape.channels = in_color ? 3 : 1;
    StokesImage image =
        picture_like(photo, photo.width / cell, photo.height / cell, shape.bands(StokesComponents::linear()),
                     in_color ? "color mosaic of polarizers" : "mosaic of polarizers");
    POL_TRY(const AngleFit fit, fit_angles(set_angles));
    image.stored.spacing = spacing_of(photo, fit);
    image.origin.assumed.emplace_back(
        "The cells of the sensor are 90 45 / 135 0 degrees from the upper left corner on; a cell is one pixel.");
    if (in_color) image.origin.assumed.emplace_back("Colors are R G / G B; G is the mean of two cells.");
    image.origin.remarks.push_back(missing_s3());
    return UnfilledPicture{
        image, [path, in_color, cell, fit](StokesImage& target, const ReadProgress&) -> Result<Done> {
            POL_TRY(const Photograph raw, read_photograph(path, true));
            if (raw.width != target.width * cell || raw.height != target.height * cell)
                return input_error("has changed while it was read", "open it again");
            const double unit = raw.scale.value_or(1.0) / raw.most;
            const auto width = static_cast<std::size_t>(raw.width);
            Misfit misfit;
            // Corners of the 2 x 2 cells of each band.
            using Corners = std::vector<std::array<std::size_t, 2>>;
            const std::vector<Corners> bands =
                in_color ? std::vector<Corners>{{{0, 0}}, {{0, 2}, {2, 0}}, {{2, 2}}} : std::vector<Corners>{{{0, 0}}};
            std::vector<double> light(4);
            for (std::size_t b = 0; b < bands.size(); ++b)
                for (int y = 0; y < target.height; ++y)
                    for (int x = 0; x < target.width; ++x) {
                        std::fill(light.begin(), light.end(), 0.0);
                        for (const auto& corner : bands[b])
                            for (std::size_t k = 0; k < 4; ++k) {
                                const std::size_t row =
                                    static_cast<std::size_t>(y * cell) + corner[0] + mosaic_places[k][0];
                                const std::size_t column =
                                    static_cast<std::size_t>(x * cell) + corner[1] + mosaic_places[k][1];
                                light[k] +=
                                    unit * raw.codes[row * width + column] / static_cast<double>(bands[b].size());
                            }
                        target.stokes[b * target.pixel_count() + target.pixel(x, y)] = fitted(fit, light, true, misfit);
                    }
            note_codes(raw.codes, raw.most, target);
            note_misfit(misfit, true, target.origin);
            return Done{};
        }};
}

/// S0 of what any other program wrote, decoded to light.
Result<UnfilledPicture> open_single(const fs::path& path) {
    POL_TRY(const Photograph photo, read_photograph(path, false));
    StokesImage image;
    image.width = photo.width;
    image.height = photo.height;
    image.bands = photo.bands(StokesComponents::s0());
    const std::vector<double> table = decoding_table(photo.most, photo.gamma);
    image.stored.spacing =
        photo.scale.value_or(1.0) * std::max(table[1] - table[0], table[photo.most] - table[photo.most - 1]);
    image.origin.layout = "photograph";
    image.origin.remarks.emplace_back("A photograph says nothing of polarization: S1, S2 and S3 are unknown.");
    if (photo.says_encoded)
        image.origin.remarks.push_back(
            photo.gamma == 0.0
                ? "The numbers were decoded by the sRGB curve, as the file says."
                : fmt::format("The numbers were decoded by the file's gAMA of {}.", number_text(photo.gamma)));
    else if (!photo.says_linear)
        image.origin.assumed.emplace_back("The numbers were decoded by the sRGB curve: the file does not say how.");
    if (photo.has_alpha) image.origin.remarks.emplace_back("Transparency (the alpha channel) is left out.");
    return UnfilledPicture{image, [path](StokesImage& target, const ReadProgress&) -> Result<Done> {
                               POL_TRY(const Photograph read, read_photograph(path, true));
                               const std::size_t pixels = target.pixel_count();
                               if (read.codes.size() != pixels * target.bands.size())
                                   return input_error("has changed while it was read", "open it again");
                               const std::vector<double> light = decoding_table(read.most, read.gamma);
                               for (std::size_t b = 0; b < target.bands.size(); ++b)
                                   for (std::size_t p = 0; p < pixels; ++p)
                                       target.stokes[b * pixels + p].s0 =
                                           read.scale.value_or(1.0) * light[read.codes[read.at(p, b)]];
                               return Done{};
                           }};
}

}  // namespace

Result<UnfilledPicture> open_png(const PictureSource& source) {
    const fs::path& path = source.path();
    if (source.layout == "mosaic") return open_mosaic(path, false);
    if (source.layout == "color-mosaic") return open_mosaic(path, true);
    const std::optional<SetName> name = source.layout == "photograph" ? std::nullopt : set_name(path);
    if (!name) {
        if (source.layout == "four-angles")
            return usage_error("four-angles is known by names: they end in _0, _45, _90 and _135, or _000, _045, ...",
                               "name the files and their --angles");
        return open_single(path);
    }
    std::vector<fs::path> files;
    std::vector<std::string> missing;
    for (const double angle : set_angles) {
        files.push_back(member_of(path, *name, angle));
        std::error_code failed;
        if (!fs::is_regular_file(files.back(), failed)) missing.push_back(files.back().filename().string());
    }
    const bool is_alone = missing.size() == 3 && source.layout.empty();
    if (is_alone) return open_single(path);
    if (!missing.empty())
        return input_error(fmt::format("is one of four photographs, of which {} missing: {}",
                                       missing.size() == 1 ? "one is" : "some are", join(missing, ", ")),
                           "put them side by side, or open it with --layout photograph");
    return open_photographs(files, {set_angles.begin(), set_angles.end()},
                            "four photographs at 0, 45, 90, 135 degrees");
}

Result<UnfilledPicture> open_angles(const PictureSource& source) {
    if (source.files.size() != source.angles_deg.size())
        return usage_error(fmt::format("{} angles for {} files", source.angles_deg.size(), source.files.size()),
                           "one angle for each file, in their order");
    if (!source.layout.empty())
        return usage_error("photographs at angles have no other layout", "leave --layout or --angles out");
    return open_photographs(source.files, source.angles_deg,
                            fmt::format("{} photographs behind polarizers", source.files.size()));
}

}  // namespace pol
