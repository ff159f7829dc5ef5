// SPDX-License-Identifier: Apache-2.0
#include "verify/degenerate/degenerate_case.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/random.h"
#include "verify/degenerate/case_lists.h"

namespace pol::verify {

std::vector<double> decades(int from, int to, int per_decade) {
    std::vector<double> settings;
    const int direction = to < from ? -1 : 1;
    const int steps = (to - from) * direction * per_decade;
    for (int i = 0; i <= steps; ++i)
        settings.push_back(std::pow(10.0, from + direction * static_cast<double>(i) / per_decade));
    return settings;
}

const std::vector<DegenerateCase>& degenerate_cases() {
    static const std::vector<DegenerateCase> all = [] {
        std::pair<const char*, std::vector<DegenerateCase>> groups[] = {
            {"axis", axis_cases()},    {"incidence", incidence_cases()}, {"index", index_cases()},
            {"states", state_cases()}, {"paths", path_cases()},          {"scenes", scene_cases()},
            {"pairs", pair_cases()}};
        std::vector<DegenerateCase> cases;
        for (auto& [group, part] : groups) {
            for (DegenerateCase& one : part) {
                one.group = group;
                cases.push_back(std::move(one));
            }
        }
        return cases;
    }();
    return all;
}

const std::vector<UntestedCase>& untested_cases() {
    const std::string biaxial = "the program has no biaxial media: a scene that asks for one is refused";
    static const std::vector<UntestedCase> cases = {
        {"e refracted to the side of the incident ray",
         "covered by the rays of axis-in-plane, not by a knob of its own"},
        {"coherent phases in scenes of any scale", "paths add incoherently: no phase over a distance is ever formed"},
        {"biaxial, on an optic axis", biaxial},
        {"biaxial, near an optic axis", biaxial},
        {"biaxial that is almost uniaxial", biaxial},
        {"triangles thinner than 1e-7 of a mesh", "welded or refused with their number when the mesh is read"},
    };
    return cases;
}

Turn::Turn(std::size_t number) : number_(number) {
    const auto element = [number](std::uint32_t i) {
        return 2.0 * random_unit(RandomKey{1, 0, static_cast<std::uint32_t>(number), 0}, i) - 1.0;
    };
    x_ = unit(DVec3(element(0), element(1), element(2)));
    y_ = unit(cross(DVec3(element(3), element(4), element(5)), x_));
    z_ = cross(x_, y_);
}

DegenerateResult run(const DegenerateCase& degenerate_case) {
    DegenerateResult result;
    result.of = &degenerate_case;
    result.sound = true;
    for (const double setting : degenerate_case.settings) {
        const double loss = degenerate_case.loss ? degenerate_case.loss(setting) : 1.0;
        DegeneratePoint worst;
        for (std::size_t number = 0; number < degenerate_case.turns; ++number) {
            Experiment experiment = degenerate_case.at(setting, Turn(number));
            const std::vector<double>& seconds = degenerate_case.second_settings;
            DegeneratePoint point{setting, seconds.empty() ? 0.0 : seconds[number % seconds.size()],
                                  examine(experiment), 0.0, std::move(experiment.inputs)};
            point.limit = loss * point.finding.chain;
            const bool worse = point.finding.ratio * worst.limit > worst.finding.ratio * point.limit;
            if (number == 0 || !point.finding.finite || (worst.finding.finite && worse)) worst = std::move(point);
        }
        const Finding& found = worst.finding;
        result.finite = result.finite && found.finite;
        result.sound = result.sound && found.finite && found.ratio <= worst.limit;
        if (result.points.empty() || found.error > result.worst.finding.error) result.worst = worst;
        if (result.points.empty() || found.ratio * result.limit > result.ratio * worst.limit) {
            result.ratio = found.ratio;
            result.limit = worst.limit;
        }
        result.points.push_back(std::move(worst));
    }
    return result;
}

}  // namespace pol::verify
