// SPDX-License-Identifier: Apache-2.0
// Which regions of space a surface may have points in.
#pragma once

#include <vector>

#include "core/vec.h"
#include "geometry/overlap.h"
#include "plan/plan.h"

namespace pol {

/// The solid as geometry/overlap.h takes it; borrows.
SolidRef solid_ref(const Solid& solid);

/// How far a surface may be from where it belongs, see geometry/mesh_check.h.
double slack(const SurfaceShape& shape);

/// A box along the axes.
struct Box {
    DVec3 low{};
    DVec3 high{};

    /// Whether the boxes are apart by more than `margin` along some axis.
    [[nodiscard]] bool apart(const Box& other, double margin) const;
};
Box box_around(const SurfaceShape& shape);
Box box_around(const Solid& solid);

/// Answers for the solids of one plan, which are borrowed.
class Reach {
public:
    explicit Reach(const std::vector<Solid>& solids);

    /// False: the surface surely has no point in the region. Lying on a boundary is outside.
    [[nodiscard]] bool into(const Region& region, const SurfaceShape& shape) const;

private:
    struct Known {
        const Solid* solid = nullptr;
        Box box{};
        double slack = 0.0;
    };
    std::vector<Known> solids_;
};

}  // namespace pol
