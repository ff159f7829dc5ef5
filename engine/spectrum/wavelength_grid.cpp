// SPDX-License-Identifier: Apache-2.0
#include "spectrum/wavelength_grid.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "core/contract.h"
#include "core/number_text.h"

namespace pol {
namespace {

constexpr const char* forms = "write one wavelength in nm (580), a list (450,550,650), or first:last:step (380:780:20)";

Error usage_error(std::string what, std::string hint = forms) {
    return Error{ErrorKind::usage, std::move(what), {}, "wavelengths", std::move(hint)};
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// The numbers between the separators.
Result<std::vector<double>> parse_numbers(std::string_view text, char separator) {
    std::vector<double> numbers;
    for (bool more = true; more;) {
        const std::size_t cut = text.find(separator);
        more = cut != std::string_view::npos;
        const std::string_view word = trimmed(text.substr(0, cut));
        if (more) text.remove_prefix(cut + 1);

        if (word.empty()) return usage_error("a number is missing");
        double value = 0.0;
        const std::from_chars_result parsed = std::from_chars(word.data(), word.data() + word.size(), value);
        if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size()) {
            std::string what = "not a number: ";
            what += word.substr(0, 40);
            return usage_error(std::move(what));
        }
        numbers.push_back(value);
        if (numbers.size() > max_wavelength_count) {
            return usage_error("more than " + std::to_string(max_wavelength_count) + " wavelengths",
                               "use a larger step");
        }
    }
    return numbers;
}

Result<std::vector<double>> expand_range(double first, double last, double step) {
    for (const double value : {first, last, step}) {
        if (!std::isfinite(value) || value <= 0.0) {
            return usage_error("first, last and step must be positive numbers, not " + number_text(value));
        }
    }
    if (last < first) return usage_error("the range runs from " + number_text(first) + " down to " + number_text(last));
    const double steps = std::floor((last - first) / step + 1e-9);
    if (steps >= static_cast<double>(max_wavelength_count)) {
        return usage_error("more than " + std::to_string(max_wavelength_count) + " wavelengths", "use a larger step");
    }
    std::vector<double> list;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i)
        list.push_back(first + static_cast<double>(i) * step);
    return list;
}

}  // namespace

std::size_t nearest_wavelength(const std::vector<double>& wavelengths_nm, double nm) {
    POL_EXPECTS(!wavelengths_nm.empty());
    const auto nearest = std::min_element(wavelengths_nm.begin(), wavelengths_nm.end(),
                                          [nm](double a, double b) { return std::abs(a - nm) < std::abs(b - nm); });
    return static_cast<std::size_t>(nearest - wavelengths_nm.begin());
}

std::optional<Error> wavelength_problem(double wavelength_nm) {
    const std::string text = number_text(wavelength_nm);
    if (!std::isfinite(wavelength_nm) || wavelength_nm <= 0.0) return usage_error(text + " is not a wavelength");
    if (wavelength_nm >= shortest_light_nm) return std::nullopt;
    return usage_error(text + " nm is no light: were micrometres meant?",
                       "wavelengths are in nm: " + text + " um is " + number_text(1000.0 * wavelength_nm));
}

Result<std::vector<double>> checked_wavelengths(std::vector<double> wavelengths_nm) {
    if (wavelengths_nm.empty()) return usage_error("no wavelength given");
    if (wavelengths_nm.size() > max_wavelength_count) {
        return usage_error("more than " + std::to_string(max_wavelength_count) + " wavelengths", "use a larger step");
    }
    double previous = 0.0;
    for (const double nm : wavelengths_nm) {
        if (const auto problem = wavelength_problem(nm)) return *problem;
        if (nm <= previous) {
            return usage_error(number_text(nm) + " nm comes after " + number_text(previous) + " nm",
                               "list wavelengths once each, in ascending order");
        }
        previous = nm;
    }
    return wavelengths_nm;
}

Result<std::vector<double>> parse_wavelengths(std::string_view text) {
    const bool is_range = text.find(':') != std::string_view::npos;
    Result<std::vector<double>> numbers = parse_numbers(text, is_range ? ':' : ',');
    if (!numbers) return numbers;
    if (!is_range) return checked_wavelengths(std::move(numbers).value());
    const std::vector<double>& range = numbers.value();
    if (range.size() != 3) return usage_error("a range has three parts");
    Result<std::vector<double>> list = expand_range(range[0], range[1], range[2]);
    if (!list) return list;
    return checked_wavelengths(std::move(list).value());
}

}  // namespace pol
