// SPDX-License-Identifier: Apache-2.0
#include "compare/error_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.h"
#include "film/picture_error.h"
#include "maps/color_picture.h"
#include "polarization/coherence_matrix.h"
#include "polarization/measures.h"

namespace pol {

namespace {

bool is_finite(const Stokes<double>& s) {
    return std::isfinite(s.s0) && std::isfinite(s.s1) && std::isfinite(s.s2) && std::isfinite(s.s3);
}

StokesComponents known_in_all(const StokesImage& image) {
    StokesComponents known = StokesComponents::all();
    for (const Band& band : image.bands) known = known & band.known;
    return known;
}

/// sqrt(weighted mean of squares) and the distribution of the per-pixel values.
class Accumulator {
public:
    void weigh(double error, double weight) {
        squares_ += weight * error * error;
        weights_ += weight;
    }
    void list(double error) { errors_.push_back(error); }

    [[nodiscard]] double mean_square() const { return weights_ > 0.0 ? squares_ / weights_ : 0.0; }
    [[nodiscard]] double root_mean() const { return std::sqrt(mean_square()); }
    /// Per-pixel values divided by `unit`.
    [[nodiscard]] Metric metric(double whole, double unit) {
        Metric result;
        result.whole = whole;
        if (errors_.empty() || unit == 0.0) return result;
        const std::size_t rank = (errors_.size() - 1) * 99 / 100;
        std::nth_element(errors_.begin(), errors_.begin() + static_cast<std::ptrdiff_t>(rank), errors_.end());
        result.p99 = errors_[rank] / unit;
        result.largest = *std::max_element(errors_.begin(), errors_.end()) / unit;
        return result;
    }

private:
    double squares_ = 0.0;
    double weights_ = 0.0;
    std::vector<double> errors_;
};

/// A relative error: of nothing, nothing is 0 and anything else infinite.
double relative(double error, double unit) {
    if (unit > 0.0) return error / unit;
    return error > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

ErrorMetrics error_metrics(const StokesImage& test, const StokesImage& reference) {
    POL_EXPECTS(test.width == reference.width && test.height == reference.height &&
                test.stokes.size() == reference.stokes.size());
    constexpr double faint = 1e-3;
    ErrorMetrics result;
    double brightest = 0.0;
    for (const Stokes<double>& s : reference.stokes)
        if (is_finite(s)) brightest = std::max(brightest, s.s0);

    Accumulator fro, s0, relative_s0, analyzer, dop, azimuth, ellipticity, poincare;
    double fro_of_reference = 0.0;
    double s0_of_reference = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < reference.stokes.size(); ++i) {
        const Stokes<double>& r = reference.stokes[i];
        const Stokes<double>& t = test.stokes[i];
        if (!is_finite(r) || !is_finite(t)) {
            ++result.nan_count;
            continue;
        }
        const Stokes<double> d = t - r;
        const double polarized = polarized_part(r);
        const double linear = linear_part(r);
        const double difference = polarized_part(d);
        fro_of_reference += frobenius_square(r);
        s0_of_reference += r.s0 * r.s0;
        count += 1.0;
        const double fro_error = std::sqrt(frobenius_square(d));
        fro.weigh(fro_error, 1.0);
        fro.list(fro_error);
        s0.weigh(d.s0, 1.0);
        s0.list(std::abs(d.s0));
        if (const double scale = r.s0 + 0.01 * brightest; scale > 0.0) {
            relative_s0.weigh(d.s0 / scale, 1.0);
            relative_s0.list(d.s0 * d.s0 / (scale * scale));
        }
        analyzer.list(0.5 * (std::abs(d.s0) + difference));
        if (!(r.s0 > 0.0) || !(t.s0 > 0.0)) continue;
        const Measures<double> of_reference = measure(r);
        const Measures<double> of_test = measure(t);
        const double dop_error = std::abs(of_test.dop - of_reference.dop);
        dop.weigh(dop_error, r.s0);
        if (r.s0 > faint * brightest) dop.list(dop_error);
        if (of_reference.has_azimuth && of_test.has_azimuth) {
            const double angle = line_angle(of_test.azimuth, of_reference.azimuth);
            azimuth.weigh(angle, linear);
            if (linear > faint * brightest) azimuth.list(angle);
        }
        if (of_reference.has_polarization && of_test.has_polarization) {
            const double angle = std::abs(of_test.ellipticity_angle - of_reference.ellipticity_angle);
            ellipticity.weigh(angle, polarized);
            const double on_sphere = half_poincare_angle(t, r);
            poincare.weigh(on_sphere, polarized);
            if (!(polarized > faint * brightest)) continue;
            ellipticity.list(angle);
            poincare.list(on_sphere);
        }
    }
    const double fro_unit = count > 0.0 ? std::sqrt(fro_of_reference / count) : 0.0;
    const double s0_unit = count > 0.0 ? std::sqrt(s0_of_reference / count) : 0.0;
    constexpr double nothing_to_compare = std::numeric_limits<double>::infinity();
    result.fro_c = fro.metric(count > 0.0 ? relative(fro.root_mean(), fro_unit) : nothing_to_compare, fro_unit);
    result.rel_rmse_s0 = s0.metric(relative(s0.root_mean(), s0_unit), s0_unit);
    result.mrse_s0 = relative_s0.metric(relative_s0.mean_square(), 1.0);
    result.analyzer_inf = analyzer.metric(0.0, 1.0);
    result.analyzer_inf.whole = result.analyzer_inf.largest;
    result.dop_w = dop.metric(dop.root_mean(), 1.0);
    result.azimuth_w = azimuth.metric(azimuth.root_mean(), 1.0);
    result.ellip_w = ellipticity.metric(ellipticity.root_mean(), 1.0);
    result.poincare_w = poincare.metric(poincare.root_mean(), 1.0);

    const StokesComponents known = known_in_all(test) & known_in_all(reference);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const NamedMetric& named : named_metrics)
        if (!known.has(named.needs)) result.*named.metric = Metric{unknown, unknown, unknown};
    return result;
}

LightDefects light_defects(const StokesImage& image, double rounding) {
    POL_EXPECTS(image.brightest.size() == image.bands.size());
    LightDefects result;
    for (std::size_t w = 0; w < image.bands.size(); ++w) {
        const double brightest = image.brightest[w];
        for (std::size_t p = 0; p < image.pixel_count(); ++p) {
            const Stokes<double>& s = image.at(w, p);
            if (polarized_part(s) - s.s0 > rounding * brightest) ++result.not_psd;
            if (brightest > 0.0) result.s0_over_max = std::max(result.s0_over_max, s.s0 / brightest);
        }
    }
    return result;
}

double matrix_rms(const StokesImage& image) {
    double sum = 0.0;
    for (const Stokes<double>& s : image.stokes) sum += frobenius_square(s);
    return image.stokes.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(image.stokes.size()));
}

namespace {

/// Bounds of |dS0| and of |dC|_F, light that a pixel lacks or has too much.
struct PixelBound {
    double s0 = 0.0;
    double matrix = 0.0;
};

PixelBound bound_of(const StokesImage& image, std::size_t wavelength, std::size_t pixel) {
    if (image.brightest.empty()) return {};
    const double residual = image.plane_value(image.residual, wavelength, pixel);
    const double tail = image.plane_value(image.tail, wavelength, pixel);
    const double brightest = image.brightest[wavelength];
    return {(residual + tail) * brightest, truncation_bound(residual, tail) * brightest};
}

}  // namespace

double relative_bound(const StokesImage& image, const StokesImage& reference) {
    POL_EXPECTS(image.brightest.size() == image.bands.size());
    double sum = 0.0;
    for (std::size_t w = 0; w < image.bands.size(); ++w)
        for (std::size_t p = 0; p < image.pixel_count(); ++p) sum += std::pow(bound_of(image, w, p).matrix, 2);
    return relative(std::sqrt(sum / static_cast<double>(image.stokes.size())), matrix_rms(reference));
}

BoundCoverage bound_coverage(const StokesImage& test, const StokesImage& reference, double rounding) {
    POL_EXPECTS(!test.stokes.empty() && test.stokes.size() == reference.stokes.size() &&
                test.brightest.size() == test.bands.size());
    constexpr double known_better = 0.1;
    BoundCoverage result;
    std::vector<double> ratios;
    std::size_t inside = 0;
    double sum = 0.0;
    for (std::size_t w = 0; w < test.bands.size(); ++w) {
        for (std::size_t p = 0; p < test.pixel_count(); ++p) {
            const PixelBound bound = bound_of(test, w, p);
            const PixelBound of_reference = bound_of(reference, w, p);
            const Stokes<double> difference = test.at(w, p) - reference.at(w, p);
            const double error = std::abs(difference.s0);
            const double allowed = rounding * test.brightest[w];
            if (error <= bound.s0 + of_reference.s0 + allowed &&
                std::sqrt(frobenius_square(difference)) <= bound.matrix + of_reference.matrix + allowed)
                ++inside;
            if (bound.s0 > 0.0 && of_reference.s0 <= known_better * bound.s0) ratios.push_back(error / bound.s0);
            const double share = test.brightest[w] > 0.0 ? bound.s0 / test.brightest[w] : 0.0;
            sum += share;
            result.largest = std::max(result.largest, share);
        }
    }
    const auto all = static_cast<double>(test.stokes.size());
    result.covered = static_cast<double>(inside) / all;
    result.mean = sum / all;
    if (!ratios.empty()) {
        const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
        std::nth_element(ratios.begin(), middle, ratios.end());
        result.ratio = *middle;
    }
    return result;
}

double color_difference(const StokesImage& test, const StokesImage& reference) {
    POL_EXPECTS(test.width == reference.width && test.height == reference.height);
    const std::vector<Rgb> a = color_picture(test);
    const std::vector<Rgb> b = color_picture(reference);
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            difference += (a[i][c] - b[i][c]) * (a[i][c] - b[i][c]);
            size += b[i][c] * b[i][c];
        }
    }
    return size > 0.0 ? std::sqrt(difference / size) : 0.0;
}

}  // namespace pol
