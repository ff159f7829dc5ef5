// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/stokes_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "io/pictures/channel_rules.h"
#include "io/pictures/picture_reading.h"

namespace pol {
namespace {

using channels::Fit;

struct Rule {
    std::string_view layout;
    Result<std::optional<Fit>> (*fit)(const std::vector<std::string>& names, std::string_view generator);
    bool is_last_resort = false;  ///< not looked at where another fits
};
constexpr std::array<Rule, 6> rules{{{"spectral", channels::spectral},
                                     {"mitsuba", channels::mitsuba},
                                     {"mitsuba-array", channels::mitsuba_array},
                                     {"named", channels::named},
                                     {"bare", channels::bare},
                                     {"plain", channels::plain, true}}};

Error nothing_fits(const std::vector<std::string>& names) {
    return input_error(fmt::format("no Stokes channels; found {}", channels::some_of(names)),
                       "expected S0.580,000000nm to S3.580,000000nm (Fichet, Pacanowski & Wilkie 2021), S0.R to S3.B, "
                       "S0 to S3, or R, G and B; S0, S1 and S2 belong together");
}

Result<StokesChannels> insist(std::string_view layout, const std::vector<std::string>& names,
                              std::string_view generator) {
    const auto* const rule =
        std::find_if(rules.begin(), rules.end(), [&](const Rule& candidate) { return candidate.layout == layout; });
    if (rule == rules.end())
        return input_error(fmt::format("layout {} is not one of named channels, which this picture has", layout),
                           "leave --layout out, or name another");
    POL_TRY(auto fit, rule->fit(names, generator));
    if (fit) return std::move(fit->channels);
    return input_error(
        fmt::format("does not have the channels of layout {}; found {}", layout, channels::some_of(names)),
        "leave --layout out, or name another");
}

}  // namespace

Result<StokesChannels> find_stokes_channels(const std::vector<std::string>& all_names, std::string_view generator,
                                            std::string_view layout) {
    // A message may have a channel without a name; an empty name stands for a component that is not there.
    std::vector<std::string> names;
    std::copy_if(all_names.begin(), all_names.end(), std::back_inserter(names),
                 [](const std::string& name) { return !name.empty(); });
    if (!layout.empty()) return insist(layout, names, generator);
    std::vector<std::string_view> fitting;
    std::optional<StokesChannels> found;
    for (const Rule& rule : rules) {
        if (rule.is_last_resort && found) break;
        POL_TRY(auto fit, rule.fit(names, generator));
        if (!fit) continue;
        if (fit->is_certain) return std::move(fit->channels);
        fitting.push_back(rule.layout);
        found = std::move(fit->channels);
    }
    if (!found) return nothing_fits(names);
    if (fitting.size() > 1)
        return input_error(fmt::format("has the channels of two layouts, {} and {}", fitting[0], fitting[1]),
                           fmt::format("say which: --layout {} or --layout {}", fitting[0], fitting[1]));
    return std::move(*found);
}

Result<StokesChannels> find_component_channels(const std::vector<std::string>& names) {
    if (auto fit = channels::one_component(names)) return std::move(*fit);
    return input_error(fmt::format("is not one Stokes component; found {}", channels::some_of(names)),
                       "expected R, G and B, or one channel");
}

void merge_equal_colors(StokesImage& image) {
    if (image.bands.size() != 3) return;
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    const auto same = [&](const Stokes<double>& a, const Stokes<double>& b) {
        return bits(a.s0) == bits(b.s0) && bits(a.s1) == bits(b.s1) && bits(a.s2) == bits(b.s2) &&
               bits(a.s3) == bits(b.s3);
    };
    const std::size_t pixels = image.pixel_count();
    for (std::size_t i = 0; i < pixels; ++i)
        if (!same(image.at(0, i), image.at(1, i)) || !same(image.at(0, i), image.at(2, i))) return;
    image.stokes.resize(pixels);
    image.stokes.shrink_to_fit();
    image.bands = {named_band("mono", image.bands.front().known)};
    if (const std::size_t comma = image.origin.layout.rfind(", "); comma != std::string::npos)
        image.origin.layout.resize(comma);
    image.origin.layout += ", mono";
    std::erase(image.origin.remarks, channels::remark_of_colors);
}

}  // namespace pol
