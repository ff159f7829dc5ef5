// SPDX-License-Identifier: Apache-2.0
#include "verify/invariants/image_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "polarization/measures.h"

namespace pol::verify {

namespace {

/// From so many pixels on a pattern of signs is worth a remark.
constexpr std::size_t enough = 100;

bool is_finite(const Stokes<double>& s) {
    return std::isfinite(s.s0) && std::isfinite(s.s1) && std::isfinite(s.s2) && std::isfinite(s.s3);
}

/// Counts one kind of defect and keeps the pixel where `badness` is largest.
class Counter {
public:
    explicit Counter(std::string name) : defect_{std::move(name), {}, 0, {}} {}
    void add(const PixelValue& at, const char* value_name, double badness) {
        ++defect_.count;
        if (defect_.worst && !(badness > badness_)) return;
        badness_ = badness;
        defect_.value_name = value_name;
        defect_.worst = at;
    }
    [[nodiscard]] const ImageDefect& defect() const { return defect_; }

private:
    ImageDefect defect_;
    double badness_ = 0.0;
};

struct NamedPart {
    const char* name;
    double value;
};
NamedPart first_not_finite(const Stokes<double>& s) {
    for (const NamedPart& part : {NamedPart{"S0", s.s0}, {"S1", s.s1}, {"S2", s.s2}})
        if (!std::isfinite(part.value)) return part;
    return {"S3", s.s3};
}

/// The light that a pixel is judged by, and which of its components are known. R, G and B of a spectrum may each be of
/// either sign and more than fully polarized without a fault: the weights of linear sRGB are partly negative. Their
/// luminance (Rec. 709) has positive weights of the observer, so it is judged in their place, called band R.
class Judged {
public:
    explicit Judged(const StokesImage& image) : image_(image), primaries_(rgb_bands(image.bands)) {
        for (std::size_t b = 0; b < image.bands.size(); ++b) {
            if (primaries_ && (b == (*primaries_)[1] || b == (*primaries_)[2])) continue;
            bands_.push_back(b);
            known_.push_back(image.bands[b].known);
            if (!is_primary(b)) continue;
            for (const std::size_t primary : *primaries_)
                for (unsigned i = 0; i < 4; ++i)
                    if (!image.bands[primary].known.has(i)) known_.back() = known_.back().without(i);
        }
    }

    [[nodiscard]] bool has_luminance() const { return primaries_.has_value(); }
    [[nodiscard]] bool is_luminance(std::size_t judged) const { return is_primary(bands_[judged]); }
    [[nodiscard]] std::size_t count() const { return bands_.size(); }
    /// Band of the picture that stands for the judged one.
    [[nodiscard]] std::size_t band(std::size_t judged) const { return bands_[judged]; }
    [[nodiscard]] StokesComponents known(std::size_t judged) const { return known_[judged]; }
    [[nodiscard]] Stokes<double> light(std::size_t judged, std::size_t pixel) const {
        if (!is_primary(bands_[judged])) return image_.at(bands_[judged], pixel);
        Stokes<double> sum{};
        for (std::size_t c = 0; c < 3; ++c) sum += luminance[c] * image_.at((*primaries_)[c], pixel);
        return only(known_[judged], sum);
    }
    /// What |s| may exceed S0 by rounding of the numbers as they were stored: excess_of of what was added.
    [[nodiscard]] double allowed(std::size_t judged, std::size_t pixel) const {
        const double excess = excess_of(image_.stored.rounding());
        if (!is_primary(bands_[judged]))
            return excess * image_.at(bands_[judged], pixel).s0 + 2.0 * image_.stored.step();
        double added = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const Stokes<double>& s = image_.at((*primaries_)[c], pixel);
            added += luminance[c] * std::max(std::abs(s.s0), polarized_part(s));
        }
        return excess * added + 2.0 * image_.stored.step();
    }

private:
    static constexpr std::array<double, 3> luminance{0.2126, 0.7152, 0.0722};
    [[nodiscard]] bool is_primary(std::size_t b) const { return primaries_ && b == (*primaries_)[0]; }

    const StokesImage& image_;
    std::optional<std::array<std::size_t, 3>> primaries_;
    std::vector<std::size_t> bands_;
    std::vector<StokesComponents> known_;
};

std::vector<ImageDefect> find_defects(const StokesImage& image, const Judged& judged) {
    Counter not_finite("not a number or infinite");
    Counter negative("negative S0");
    Counter polarized(image.stored.spacing > 0.0
                          ? "more polarized than whole numbers allow"
                          : fmt::format("more polarized than {}-bit rounding allows", image.stored.bits));
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double>& s = image.at(b, image.pixel(x, y));
                if (is_finite(s)) continue;
                const NamedPart part = first_not_finite(s);
                not_finite.add({image.left + x, image.top + y, b, false, part.value}, part.name, 0.0);
            }
    for (std::size_t j = 0; j < judged.count(); ++j)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double> s = judged.light(j, image.pixel(x, y));
                if (!is_finite(s)) continue;
                PixelValue at{image.left + x, image.top + y, judged.band(j), judged.is_luminance(j), s.s0};
                const double length = polarized_part(s);
                const double allowed = judged.allowed(j, image.pixel(x, y));
                if (s.s0 < (judged.is_luminance(j) ? -allowed : 0.0)) {
                    negative.add(at, "S0", -s.s0);
                } else if (length > s.s0 + allowed) {
                    at.value = s.s0 > 0.0 ? length / s.s0 - 1.0 : std::numeric_limits<double>::infinity();
                    polarized.add(at, "|s|/S0 - 1", at.value);
                }
            }
    return {not_finite.defect(), negative.defect(), polarized.defect()};
}

/// Of the bands whose components are all known, else of those that have S1 and S2.
DopStatistics dop_statistics(const StokesImage& image, const Judged& judged) {
    DopStatistics out;
    std::vector<double> dops;
    double sum = 0.0;
    out.is_linear = true;
    for (std::size_t j = 0; j < judged.count(); ++j)
        if (judged.known(j) == StokesComponents::all()) out.is_linear = false;
    const StokesComponents needed = out.is_linear ? StokesComponents::linear() : StokesComponents::all();
    for (std::size_t j = 0; j < judged.count(); ++j) {
        const bool is_measured = judged.known(j).has(needed);
        for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
            const Stokes<double> s = judged.light(j, pixel);
            if (!is_finite(s) || s.s0 < 0.0) continue;
            if (s.s0 == 0.0) {
                ++out.dark;
                continue;
            }
            ++out.lit;
            if (!is_measured) continue;
            dops.push_back(polarized_part(s) / s.s0);
            sum += dops.back();
        }
    }
    out.measured = dops.size();
    if (dops.empty()) return out;
    std::sort(dops.begin(), dops.end());
    const auto rank = [&](double share) {
        return dops[static_cast<std::size_t>(std::lround(share * static_cast<double>(dops.size() - 1)))];
    };
    out.mean = sum / static_cast<double>(dops.size());
    out.least = dops.front();
    out.percentile_1 = rank(0.01);
    out.median = rank(0.5);
    out.percentile_99 = rank(0.99);
    out.most = dops.back();
    return out;
}

/// Signs of S1, S2 or S3 over the picture, noise below the rounding of S0 left out.
struct Signs {
    std::size_t positive = 0;
    std::size_t negative = 0;
    std::size_t nonzero = 0;  ///< noise included
};

/// What the way a picture was stored has to do with light that is more than fully polarized; empty: there is none.
std::string origin_of_excess(const StoredNumbers& stored, const ImageReport& report) {
    const ImageDefect& excess = report.defects.back();
    if (excess.count == 0 && report.dop.most <= 1.0 + float_excess) return {};
    if (!stored.lossy.empty())
        return fmt::format("of some percent may come from {}, a lossy compression: write ZIP or PIZ", stored.lossy);
    if (stored.spacing > 0.0)
        return fmt::format("comes from whole numbers where light is dark: they are {:.2g} apart", stored.spacing);
    const double allowed = excess_of(stored.rounding());
    if (stored.bits == 24)
        return fmt::format("up to {:.2g} comes from PXR24, which keeps 24 bits of a number: write ZIP or PIZ", allowed);
    if (stored.bits == 16) return fmt::format("up to {:.2g} comes from 16-bit floats: write 32-bit floats", allowed);
    if (excess.worst && excess.worst->value <= half_excess)
        return "is what 16-bit floats make: were the numbers rounded to them before they were written?";
    return {};
}

/// Components that some band has and some band has not.
std::vector<std::string> find_unmeasured(const StokesImage& image) {
    std::vector<std::string> remarks;
    for (unsigned i = 1; i < 4; ++i) {
        std::string without;
        std::size_t count = 0;
        for (const Band& band : image.bands) {
            if (band.known.has(i)) continue;
            ++count;
            without += (without.empty() ? "" : ", ") + band.label();
        }
        if (count == 0) continue;
        remarks.push_back(fmt::format("S{} was not measured{}: what depends on it is unknown, not 0", i,
                                      count == image.bands.size() ? "" : " in band " + without));
    }
    return remarks;
}

std::vector<std::string> find_oddities(const StokesImage& image, const Judged& judged, const ImageReport& report) {
    std::vector<std::string> remarks = find_unmeasured(image);
    if (judged.has_luminance())
        remarks.emplace_back(
            "R, G and B of a spectrum may be negative or more than fully polarized each: the luminance is judged");
    const std::array<double Stokes<double>::*, 3> components{&Stokes<double>::s1, &Stokes<double>::s2,
                                                             &Stokes<double>::s3};
    const double noise = excess_of(image.stored.rounding());
    std::array<Signs, 3> signs{};
    std::array<bool, 3> is_measured{};
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
            const Stokes<double>& s = image.at(b, pixel);
            if (!is_finite(s)) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                if (!image.bands[b].known.has(static_cast<unsigned>(i) + 1)) continue;
                is_measured[i] = true;
                const double value = s.*components[i];
                if (value != 0.0) ++signs[i].nonzero;
                if (value > noise * s.s0 + image.stored.step()) ++signs[i].positive;
                if (value < -noise * s.s0 - image.stored.step()) ++signs[i].negative;
            }
        }
    if (report.dop.lit == 0) remarks.emplace_back("no pixel has any light");
    const std::size_t polarized = signs[0].nonzero + signs[1].nonzero + signs[2].nonzero;
    const bool has_all = is_measured[0] && is_measured[1] && is_measured[2];
    if (report.dop.lit > 0 && polarized == 0 && has_all)
        remarks.emplace_back("S1, S2 and S3 are exactly 0 everywhere: was polarization traced?");
    const std::array<const char*, 3> absent{
        "S1 is exactly 0 everywhere, S2 or S3 is not: is a channel missing, or the frame at 45 degrees?",
        "S2 is exactly 0 everywhere, S1 or S3 is not: right if everything lies along the picture's axes",
        "S3 is exactly 0 everywhere: right without total reflection, metal, retarders and circular light"};
    for (std::size_t i = 0; i < 3; ++i) {
        if (polarized > 0 && is_measured[i] && signs[i].nonzero == 0) remarks.emplace_back(absent[i]);
        const std::size_t seen = signs[i].positive + signs[i].negative;
        if (seen >= enough && (signs[i].positive == 0 || signs[i].negative == 0))
            remarks.push_back(
                fmt::format("S{} is {} wherever it is not 0 ({} values): right for some scenes, wrong signs in others",
                            i + 1, signs[i].positive > 0 ? "positive" : "negative", seen));
    }
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i + 1; j < 3; ++j) {
            const bool same = std::all_of(image.stokes.begin(), image.stokes.end(), [&](const Stokes<double>& s) {
                return s.*components[i] == s.*components[j];
            });
            if (same && signs[i].nonzero >= enough)
                remarks.push_back(fmt::format("S{} and S{} are the same everywhere: is one a copy?", i + 1, j + 1));
        }
    if (report.dop.measured >= enough && !report.dop.is_linear && report.dop.least > 1.0 - 1e-6)
        remarks.emplace_back("all light is fully polarized");
    if (const std::string origin = origin_of_excess(image.stored, report); !origin.empty())
        remarks.push_back("an excess of |s| over S0 " + origin);
    return remarks;
}

}  // namespace

bool ImageReport::physical() const {
    return std::all_of(defects.begin(), defects.end(), [](const ImageDefect& d) { return d.count == 0; });
}

ImageReport check_image(const StokesImage& image) {
    ImageReport report;
    const Judged judged(image);
    report.defects = find_defects(image, judged);
    report.dop = dop_statistics(image, judged);
    report.remarks = find_oddities(image, judged, report);
    return report;
}

}  // namespace pol::verify
