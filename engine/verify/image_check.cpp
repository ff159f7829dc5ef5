// SPDX-License-Identifier: Apache-2.0
#include "verify/image_check.h"

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

/// Spacing of the smallest 32-bit floats: absolute rounding where they lose relative precision.
constexpr double float_step = 0x1p-149;

bool is_finite(const Stokes<double>& s) {
    return std::isfinite(s.s0) && std::isfinite(s.s1) && std::isfinite(s.s2) && std::isfinite(s.s3);
}

/// Counts one kind of defect and keeps the pixel where `badness` is largest.
class Counter {
public:
    Counter(std::string name, std::string value_name) : defect_{std::move(name), std::move(value_name), 0, {}} {}
    void add(const PixelValue& at, double badness) {
        ++defect_.count;
        if (defect_.worst && !(badness > badness_)) return;
        badness_ = badness;
        defect_.worst = at;
    }
    [[nodiscard]] const ImageDefect& defect() const { return defect_; }

private:
    ImageDefect defect_;
    double badness_ = 0.0;
};

std::vector<ImageDefect> find_defects(const StokesImage& image) {
    Counter not_finite("not a number or infinite", "S0");
    Counter negative("negative S0", "S0");
    Counter polarized("more polarized than 32-bit rounding allows", "|s|/S0 - 1");
    for (std::size_t w = 0; w < image.wavelengths_nm.size(); ++w)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Stokes<double>& s = image.at(w, image.pixel(x, y));
                PixelValue at{x, y, image.wavelengths_nm[w], s.s0};
                const double length = polarized_part(s);
                if (!is_finite(s)) {
                    not_finite.add(at, 0.0);
                } else if (s.s0 < 0.0) {
                    negative.add(at, -s.s0);
                } else if (length > s.s0 * (1.0 + float_excess) + 2.0 * float_step) {
                    at.value = s.s0 > 0.0 ? length / s.s0 - 1.0 : std::numeric_limits<double>::infinity();
                    polarized.add(at, at.value);
                }
            }
    return {not_finite.defect(), negative.defect(), polarized.defect()};
}

DopStatistics dop_statistics(const StokesImage& image) {
    DopStatistics out;
    std::vector<double> dops;
    double sum = 0.0;
    for (const Stokes<double>& s : image.stokes) {
        if (!is_finite(s) || s.s0 < 0.0) continue;
        if (s.s0 == 0.0) {
            ++out.dark;
            continue;
        }
        dops.push_back(polarized_part(s) / s.s0);
        sum += dops.back();
    }
    out.lit = dops.size();
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

/// Signs of S1, S2 or S3 over the picture, noise below float_excess of S0 left out.
struct Signs {
    std::size_t positive = 0;
    std::size_t negative = 0;
    std::size_t nonzero = 0;  ///< noise included
};

std::vector<std::string> find_oddities(const StokesImage& image, const ImageReport& report) {
    std::vector<std::string> remarks;
    const std::array<double Stokes<double>::*, 3> components{&Stokes<double>::s1, &Stokes<double>::s2,
                                                             &Stokes<double>::s3};
    std::array<Signs, 3> signs{};
    for (const Stokes<double>& s : image.stokes) {
        if (!is_finite(s)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = s.*components[i];
            if (value != 0.0) ++signs[i].nonzero;
            if (value > float_excess * s.s0) ++signs[i].positive;
            if (value < -float_excess * s.s0) ++signs[i].negative;
        }
    }
    if (report.dop.lit == 0) remarks.emplace_back("no pixel has any light");
    const std::size_t polarized = signs[0].nonzero + signs[1].nonzero + signs[2].nonzero;
    if (report.dop.lit > 0 && polarized == 0)
        remarks.emplace_back("S1, S2 and S3 are exactly 0 everywhere: was polarization traced?");
    const std::array<const char*, 3> absent{
        "S1 is exactly 0 everywhere, S2 or S3 is not: is a channel missing, or the frame at 45 degrees?",
        "S2 is exactly 0 everywhere, S1 or S3 is not: right if everything lies along the picture's axes",
        "S3 is exactly 0 everywhere: right without total reflection, metal, retarders and circular light"};
    for (std::size_t i = 0; i < 3; ++i) {
        if (polarized > 0 && signs[i].nonzero == 0) remarks.emplace_back(absent[i]);
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
    if (report.dop.lit >= enough && report.dop.least > 1.0 - 1e-6) remarks.emplace_back("all light is fully polarized");
    const ImageDefect& excess = report.defects.back();
    if (excess.worst && excess.worst->value <= half_excess)
        remarks.emplace_back("the excess of |s| over S0 is what 16-bit floats make: write 32-bit floats");
    return remarks;
}

}  // namespace

bool ImageReport::physical() const {
    return std::all_of(defects.begin(), defects.end(), [](const ImageDefect& d) { return d.count == 0; });
}

ImageReport check_image(const StokesImage& image) {
    ImageReport report;
    report.defects = find_defects(image);
    report.dop = dop_statistics(image);
    report.remarks = find_oddities(image, report);
    return report;
}

}  // namespace pol::verify
