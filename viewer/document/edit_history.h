// SPDX-License-Identifier: Apache-2.0
// The edits of a scene, step by step. A step is a whole scene: values that share meshes and textures, so it costs
// kilobytes and cannot be undone wrongly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace pol {

class EditHistory {
public:
    /// Steps that are kept; the oldest are forgotten.
    static constexpr std::size_t longest = 200;

    EditHistory() : EditHistory(Scene{}) {}
    /// `scene` is what the file says.
    explicit EditHistory(Scene scene) { steps_.push_back({std::move(scene), {}, next_id_++, false}); }

    [[nodiscard]] const Scene& scene() const { return steps_[at_].scene; }

    /// Adds a step, named by what it changes ("index of glass"). Edits with the same label join into one step until
    /// seal(): a slider that is dragged is undone at once.
    void push(Scene scene, const std::string& label);
    /// The next edit is a step of its own, whatever its label.
    void seal() { steps_[at_].open = false; }

    [[nodiscard]] bool can_undo() const { return at_ > 0; }
    [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
    /// Label of the edit that undo() takes back. Requires: can_undo().
    [[nodiscard]] const std::string& undo_label() const { return steps_[at_].label; }
    /// Requires: can_redo().
    [[nodiscard]] const std::string& redo_label() const { return steps_[at_ + 1].label; }
    /// Scene after undo() or redo(), to see first whether it can be rendered. Requires: can_undo(), can_redo().
    [[nodiscard]] const Scene& scene_before() const { return steps_[at_ - 1].scene; }
    [[nodiscard]] const Scene& scene_after() const { return steps_[at_ + 1].scene; }
    void undo();
    void redo();

    /// The current scene is what the file says.
    void mark_saved() {
        saved_id_ = steps_[at_].id;
        seal();
    }
    [[nodiscard]] bool dirty() const { return steps_[at_].id != saved_id_; }

private:
    struct Step {
        Scene scene;
        std::string label;
        std::uint64_t id = 0;  // of this very content
        bool open = false;     // takes further edits of the same label
    };
    std::vector<Step> steps_;  // never empty
    std::size_t at_ = 0;
    std::uint64_t next_id_ = 1;
    std::uint64_t saved_id_ = 1;
};

}  // namespace pol
