// SPDX-License-Identifier: Apache-2.0
// The scene in space: solids, light sources, camera, optic axes, and the paths of the pinned pixel.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"
#include "viewer/space/space_paths.h"
#include "viewer/space/space_view.h"
#include "viewer/space/space_wireframe.h"

namespace pol {

/// Drag turns, Shift or the right button moves, the wheel zooms, a click selects a branch of the tree.
class SpacePanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    /// Pieces of one body's lines, for one place of the eye.
    struct BodyPieces {
        int body = -1;
        std::vector<SpacePiece> pieces;
    };

    void follow(const Document& document, const std::shared_ptr<const Explanation>& explanation);
    void reset();
    void look_from_camera();
    void draw_buttons();
    void draw_canvas(const Session& session, Wishes& wishes);
    void draw_bodies();
    void draw_camera_and_axes();
    void draw_paths(const Session& session);
    void draw_selected(const Session& session);
    void draw_triad();
    void draw_legend(const Session& session);
    void move_view();
    void select(Wishes& wishes);

    std::shared_ptr<const Plan> plan_;  // what the lines below belong to
    const Document* document_ = nullptr;
    std::vector<BodyLines> bodies_;
    BoundingBall ball_;
    DVec3 up_{};  // of the scene's camera
    SpaceView view_;
    std::optional<SpaceView> pieces_view_;  // that pieces_ were made for
    std::vector<BodyPieces> pieces_;
    std::shared_ptr<const Explanation> explanation_;
    std::vector<PathSegment> segments_;

    DVec2 origin_{};  // of the canvas in the window
    DVec2 size_{};
    bool show_camera_ = true;
    bool show_axes_ = true;
    bool show_paths_ = true;
};

}  // namespace pol
