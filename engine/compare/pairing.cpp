// SPDX-License-Identifier: Apache-2.0
#include "compare/pairing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/contract.h"
#include "core/join.h"
#include "maps/color_picture.h"
#include "spectrum/color.h"
#include "spectrum/wavelength_grid.h"

namespace pol::compare {
namespace {

int whole_width(const StokesImage& image) {
    return image.whole_width > 0 ? image.whole_width : image.width;
}
int whole_height(const StokesImage& image) {
    return image.whole_height > 0 ? image.whole_height : image.height;
}
bool is_crop(const StokesImage& image) {
    return image.width != whole_width(image) || image.height != whole_height(image);
}
Area all_of(const StokesImage& image) {
    return {0, 0, image.width, image.height};
}

/// Which pixels are compared.
Result<Done> place(const StokesImage& a, const StokesImage& b, Pairing& pairing) {
    pairing.in_a = all_of(a);
    pairing.in_b = all_of(b);
    if (const auto shared = shared_area(a, b)) {
        pairing.in_a = shared->in_a;
        pairing.in_b = shared->in_b;
        if (pairing.in_a != all_of(a) || pairing.in_b != all_of(b))
            pairing.remarks.push_back(fmt::format("Compared are the {} x {} pixels that both pictures have.",
                                                  pairing.in_a.width, pairing.in_a.height));
        return Done{};
    }
    if (a.width == b.width && a.height == b.height) {
        if (is_crop(a) || is_crop(b))
            pairing.remarks.emplace_back("Both are taken to be the same part of the picture; the files do not say so.");
        return Done{};
    }
    const auto times = [](const StokesImage& large, const StokesImage& small) {
        const int box = large.width / small.width;
        return box * small.width == large.width && box * small.height == large.height && !is_crop(large) &&
                       !is_crop(small)
                   ? box
                   : 0;
    };
    pairing.box_a = std::max(1, times(a, b));
    pairing.box_b = std::max(1, times(b, a));
    if (pairing.box_a > 1 || pairing.box_b > 1) {
        pairing.remarks.push_back(fmt::format("Each pixel of {0} is compared with the mean of {1} x {1} pixels of {2}.",
                                              pairing.box_a > 1 ? "B" : "A", std::max(pairing.box_a, pairing.box_b),
                                              pairing.box_a > 1 ? "A" : "B"));
        return Done{};
    }
    pairing.lies_across = a.width == b.height && a.height == b.width;
    if (pairing.lies_across) return Done{};
    return Error{ErrorKind::usage,
                 fmt::format("A has {} x {} pixels and B {} x {}: neither is a whole multiple of the other", a.width,
                             a.height, b.width, b.height),
                 {},
                 {},
                 "compare pictures of one size, or render ours at the size of the other"};
}

std::vector<double> only(std::size_t band, std::size_t count) {
    std::vector<double> weights(count, 0.0);
    weights[band] = 1.0;
    return weights;
}

/// Weights of the linear sRGB components.
std::array<std::vector<double>, 3> color_parts(const std::vector<Band>& bands) {
    std::array<std::vector<double>, 3> parts;
    for (const Rgb& color : band_colors(bands))
        for (std::size_t c = 0; c < 3; ++c) parts[c].push_back(color[c]);
    return parts;
}

bool has_color(const std::vector<Band>& bands) {
    return rgb_bands(bands).has_value() || wavelengths_of(bands).size() > 1;
}

std::string labels_of(const std::vector<Band>& bands) {
    std::vector<std::string> labels;
    for (const Band& band : bands) labels.push_back(band.label().empty() ? "one without a name" : band.label());
    return join(labels, ", ");
}

/// Is this what the user calls "580", "580 nm" or "R"?
bool is_called(const std::string& label, const std::string& word) {
    constexpr double same_nm = 1e-3;
    if (label == word) return true;
    double asked = 0.0, has = 0.0;
    const auto read = [](const std::string& text, double& number) {
        const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
        const std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
        return status == std::errc() && (rest.empty() || rest == "nm" || rest == " nm");
    };
    return read(word, asked) && label.ends_with(" nm") && read(label, has) && std::abs(asked - has) <= same_nm;
}

/// Luminance of the three primaries, or equal shares.
void share_out(std::vector<BandPair>& pairs) {
    const bool is_rgb = pairs.size() == 3 && pairs[0].label == "R" && pairs[1].label == "G" && pairs[2].label == "B";
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        Rgb primary{};
        if (is_rgb) primary[i] = 1.0;
        pairs[i].share = is_rgb ? to_xyz(primary)[1] : 1.0 / static_cast<double>(pairs.size());
    }
}

std::vector<BandPair> same_bands(const std::vector<Band>& a, const std::vector<Band>& b) {
    std::vector<BandPair> pairs;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (const auto j = matching_band(b, a[i]))
            pairs.push_back({a[i].label(), only(i, a.size()), only(*j, b.size())});
    if (rgb_bands(a) && rgb_bands(b)) {
        const std::array<std::string_view, 3> order{"R", "G", "B"};
        std::stable_sort(pairs.begin(), pairs.end(), [&](const BandPair& p, const BandPair& q) {
            return std::find(order.begin(), order.end(), p.label) < std::find(order.begin(), order.end(), q.label);
        });
    }
    return pairs;
}

/// A band without a wavelength of one that has no others, against one of several.
std::size_t stand_in(const std::vector<Band>& bands, const std::string& asked) {
    for (std::size_t i = 0; i < bands.size(); ++i)
        if (is_called(bands[i].label(), asked)) return i;
    const std::vector<double> wavelengths = wavelengths_of(bands);
    return wavelengths.empty() ? 0 : nearest_wavelength(wavelengths, default_wavelength_nm);
}

Result<Done> pair_bands(const std::vector<Band>& a, const std::vector<Band>& b, const std::string& asked,
                        Pairing& pairing) {
    const bool single = (a.size() == 1 && !a[0].wavelength_nm) || (b.size() == 1 && !b[0].wavelength_nm);
    bool is_chosen = asked.empty();
    pairing.bands = same_bands(a, b);
    if (pairing.bands.empty() && single) {
        const std::size_t i = a.size() == 1 ? 0 : stand_in(a, asked);
        const std::size_t j = b.size() == 1 ? 0 : stand_in(b, asked);
        const auto shown = [](const Band& band) {
            return band.label().empty() ? "a band without a name" : band.label();
        };
        pairing.bands.push_back(
            {a[i].wavelength_nm ? a[i].label() : b[j].label(), only(i, a.size()), only(j, b.size())});
        pairing.remarks.push_back(fmt::format("{} of A is taken for what {} of B is.", shown(a[i]), shown(b[j])));
        is_chosen = is_chosen || is_called(a[i].label(), asked) || is_called(b[j].label(), asked);
    } else if (pairing.bands.empty() && has_color(a) && has_color(b)) {
        const auto parts_a = color_parts(a);
        const auto parts_b = color_parts(b);
        const std::array<std::string, 3> names{"R", "G", "B"};
        for (std::size_t c = 0; c < 3; ++c) pairing.bands.push_back({names[c], parts_a[c], parts_b[c]});
        pairing.remarks.emplace_back(
            "Compared are linear sRGB colors, of wavelengths by the CIE 1931 observer and D65.");
    }
    if (pairing.bands.empty())
        return Error{ErrorKind::usage,
                     fmt::format("the bands do not fit: A has {}; B has {}", labels_of(a), labels_of(b)),
                     {},
                     {},
                     rgb_bands(a) || rgb_bands(b)
                         ? "colors need several wavelengths: render ours with --wavelengths 380:780:20"
                         : "render ours at the wavelengths of the other (--wavelengths)"};
    if (!is_chosen) {
        const std::string all = join(
            [&] {
                std::vector<std::string> labels;
                for (const BandPair& pair : pairing.bands) labels.push_back(pair.label);
                return labels;
            }(),
            ", ");
        std::erase_if(pairing.bands, [&](const BandPair& pair) { return !is_called(pair.label, asked); });
        if (pairing.bands.empty())
            return Error{ErrorKind::usage,
                         fmt::format("the pictures have no band '{}' in common", asked),
                         {},
                         "--band",
                         "they have " + all};
    }
    share_out(pairing.bands);
    return Done{};
}

std::vector<double> mix_of(const Pairing& pairing, std::vector<double> BandPair::*weights) {
    std::vector<double> mix((pairing.bands.front().*weights).size(), 0.0);
    for (const BandPair& pair : pairing.bands)
        for (std::size_t b = 0; b < mix.size(); ++b) mix[b] += pair.share * (pair.*weights)[b];
    return mix;
}

/// Fills one band of `result`.
void add_band(const StokesImage& from, const Area& area, int box, const BandPair& pair,
              const std::vector<double>& weights, CommonPicture& result) {
    StokesImage& to = result.image;
    Band band;
    band.name = pair.label;
    const bool bounds = !from.brightest.empty() && (!from.residual.empty() || !from.tail.empty());
    const double share = 1.0 / (static_cast<double>(box) * box);
    for (std::size_t b = 0; b < weights.size(); ++b)
        if (weights[b] != 0.0) band.known = band.known & from.bands[b].known;
    to.bands.push_back(band);
    for (int y = 0; y < to.height; ++y) {
        for (int x = 0; x < to.width; ++x) {
            Stokes<double> sum, square_error;
            double bound = 0.0;
            for (int v = 0; v < box; ++v) {
                for (int u = 0; u < box; ++u) {
                    const std::size_t p = from.pixel(area.x + x * box + u, area.y + y * box + v);
                    Stokes<double> error;  // at most: bands may share their samples
                    for (std::size_t b = 0; b < weights.size(); ++b) {
                        const double w = share * weights[b];
                        if (w == 0.0) continue;
                        sum += w * from.at(b, p);
                        if (bounds)
                            bound += std::abs(w) * from.brightest[b] *
                                     (from.plane_value(from.residual, b, p) + from.plane_value(from.tail, b, p));
                        if (!from.sampling_error.empty())
                            error += std::abs(w) * from.sampling_error[b * from.pixel_count() + p];
                    }
                    square_error +=
                        {error.s0 * error.s0, error.s1 * error.s1, error.s2 * error.s2, error.s3 * error.s3};
                }
            }
            to.stokes.push_back(sum);
            if (bounds) result.bound.push_back(bound);
            if (!from.sampling_error.empty())
                to.sampling_error.push_back({std::sqrt(square_error.s0), std::sqrt(square_error.s1),
                                             std::sqrt(square_error.s2), std::sqrt(square_error.s3)});
        }
    }
}

CommonPicture common_picture(const StokesImage& from, const Area& area, int box, const Pairing& pairing,
                             std::vector<double> BandPair::*weights) {
    CommonPicture result;
    result.image.width = area.width / box;
    result.image.height = area.height / box;
    result.image.stored = from.stored;
    const double eighths = from.origin.convention.azimuth_zero_deg / 45.0;
    result.is_plain = box == 1 && eighths == std::round(eighths);
    for (const BandPair& pair : pairing.bands) {
        const std::vector<double>& w = pair.*weights;
        const auto zeros = static_cast<std::size_t>(std::count(w.begin(), w.end(), 0.0));
        const auto ones = static_cast<std::size_t>(std::count(w.begin(), w.end(), 1.0));
        result.is_color = result.is_color || ones != 1 || zeros + 1 != w.size();
        add_band(from, area, box, pair, w, result);
    }
    result.is_plain = result.is_plain && !result.is_color;
    return result;
}

}  // namespace

std::optional<SharedArea> shared_area(const StokesImage& a, const StokesImage& b) {
    if (whole_width(a) != whole_width(b) || whole_height(a) != whole_height(b)) return std::nullopt;
    const int left = std::max(a.left, b.left);
    const int top = std::max(a.top, b.top);
    const int width = std::min(a.left + a.width, b.left + b.width) - left;
    const int height = std::min(a.top + a.height, b.top + b.height) - top;
    if (width <= 0 || height <= 0) return std::nullopt;
    return SharedArea{{left - a.left, top - a.top, width, height}, {left - b.left, top - b.top, width, height}};
}

std::optional<std::size_t> comparable_band(const std::vector<Band>& ours, std::size_t band,
                                           const std::vector<Band>& theirs) {
    if (const auto same = matching_band(theirs, ours[band])) return same;
    const auto is_lone = [](const std::vector<Band>& bands) { return bands.size() == 1 && !bands[0].wavelength_nm; };
    if (is_lone(theirs)) return 0;
    return is_lone(ours) ? std::optional(stand_in(theirs, {})) : std::nullopt;
}

Result<Pairing> pair_up(const StokesImage& a, const StokesImage& b, const std::string& band) {
    Pairing pairing;
    POL_TRY_DONE(place(a, b, pairing));
    POL_TRY_DONE(pair_bands(a.bands, b.bands, band, pairing));
    return pairing;
}

ConventionVerdict diagnose(const StokesImage& a, const StokesImage& b, const Pairing& pairing,
                           std::optional<double> pixel_tangent) {
    // The doctor counts pixels of B.
    if (pixel_tangent) *pixel_tangent *= static_cast<double>(pairing.box_a) / pairing.box_b;
    return diagnose(plane_of(a, pairing.in_a, mix_of(pairing, &BandPair::of_a), pairing.box_a),
                    plane_of(b, pairing.in_b, mix_of(pairing, &BandPair::of_b), pairing.box_b), pixel_tangent);
}

CommonPictures common_pictures(const StokesImage& a, const StokesImage& b, const Pairing& pairing) {
    POL_EXPECTS(!pairing.lies_across);
    CommonPictures result{common_picture(a, pairing.in_a, pairing.box_a, pairing, &BandPair::of_a),
                          common_picture(b, pairing.in_b, pairing.box_b, pairing, &BandPair::of_b)};
    result.a.image.left = a.left + pairing.in_a.x;
    result.a.image.top = a.top + pairing.in_a.y;
    result.b.image.left = result.a.image.left;
    result.b.image.top = result.a.image.top;
    return result;
}

}  // namespace pol::compare
