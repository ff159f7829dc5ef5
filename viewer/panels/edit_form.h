// SPDX-License-Identifier: Apache-2.0
// Widgets that edit the current document's scene: each change is an edit of its own, a drag is one step of undo, and
// what cannot be rendered is explained under the field that asked for it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// A number in degrees that drags an angle in radians; true if it changed.
bool drag_angle(const std::string& label, double& angle_rad);

/// Made anew for every frame. A field's label names its edit; `hint` is its tooltip.
class EditForm {
public:
    /// Requires: a scene is shown.
    EditForm(const Session& session, Wishes& wishes)
        : scene(session.current()->scene()), session_(session), wishes_(wishes) {}

    /// The scene as it is; fields change it and wish that the document has it so.
    Scene scene;

    /// Names of the measured refractive indices that ship with the program.
    [[nodiscard]] const std::vector<std::string>& index_records() const {
        return session_.shipped_files().index_records;
    }

    /// Drag or Ctrl+click and type. `per_point`: how much one point of the mouse changes.
    void number(const std::string& label, double& value, double per_point, const char* hint = "");
    void vector(const std::string& label, DVec3& value, double per_point, const char* hint = "");
    /// In degrees on screen.
    void angle(const std::string& label, double& radians, const char* hint = "");
    void whole(const std::string& label, int& value, float per_point, const char* hint = "");
    void flag(const std::string& label, bool& value, const char* hint = "");
    /// Returns the index of the choice that was taken, or -1.
    int choice(const std::string& label, int current, std::span<const std::string> names, const char* hint = "");
    /// To be called after the caller has changed the scene: one step of undo.
    void apply(const std::string& label);

    /// To be called after a widget that changed the scene if `changed`.
    void after(const std::string& label, bool changed, const char* hint);
    /// What was typed is not even a value.
    void refuse(const std::string& label, const Error& error);

    /// A refusal of an edit of that label, in words; nothing if there is none.
    void complaint(const std::string& label) const;

private:
    void wish_edit(const std::string& label);
    void wish_end();

    const Session& session_;
    Wishes& wishes_;
};

}  // namespace pol
