// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/pages/sphere_view.h"
#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// The Poincare sphere with the pinned pixels over all wavelengths, the pixels of a region, or the leaves of the pinned
/// pixel's tree. Dragging turns it; Shift and dragging draws a lasso that marks pixels in the picture; a click pins.
class SpherePanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    enum class Source : int { pins, region, leaves };

    void choose_source(const Session& session, Wishes& wishes);
    [[nodiscard]] std::vector<SpherePoint> points(const Session& session) const;
    void handle_mouse(const Session& session, Wishes& wishes, const DVec2& center, double radius);
    void draw_points(const Session& session, const DVec2& center, double radius) const;

    Source source_ = Source::pins;
    bool front_only_ = true;
    SphereView view_;
    bool is_lasso_ = false;
    std::vector<DVec2> lasso_;         // in the coordinates of SphereView::seen
    std::vector<SpherePoint> points_;  // of this frame
};

}  // namespace pol
