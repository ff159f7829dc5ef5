// SPDX-License-Identifier: Apache-2.0
// A backward tree as optical programs print ray states: one line per segment, one column per number; and its paths as
// lines in space.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.h"
#include "tracer/explain.h"

namespace pol {

/// The tree with what a row needs to be made fast.
class RayTable {
public:
    /// Both must outlive the table.
    RayTable(const Plan& plan, const Explanation& explanation);

    struct Column {
        std::string_view name;  ///< "X", "k_x", "weight": head of the column and of the CSV file
        std::string_view help;  ///< with the unit
        /// One of the two; a number that does not exist (end of a ray that leaves the scene) is none.
        std::optional<double> (*number)(const RayTable&, int branch);
        std::string (*text)(const RayTable&, int branch);
    };
    /// Columns in the order in which they are printed.
    static std::span<const Column> columns();

    [[nodiscard]] int size() const { return static_cast<int>(explanation.tree.nodes.size()); }
    [[nodiscard]] const RayTreeNode& node(int branch) const {
        return explanation.tree.nodes[static_cast<std::size_t>(branch)];
    }
    /// Optical path from the camera to the end of the branch, sum of k . dr, scene units. None if it has no end.
    [[nodiscard]] std::optional<double> optical_path(int branch) const;

    const Plan& plan;
    const Explanation& explanation;

private:
    std::vector<double> optical_path_;
};

/// All rows with a head line, RFC 4180; numbers read back to the same bits, what does not exist is empty.
std::string ray_table_as_csv(const Plan& plan, const Explanation& explanation);

/// The segments as line elements of a Wavefront OBJ file, in groups by PathKind: camera, reflected, transmitted,
/// through_sheet, o, e and not_followed. A ray that leaves the scene is drawn over the length of the scene.
std::string paths_as_obj(const Plan& plan, const Explanation& explanation);

}  // namespace pol
