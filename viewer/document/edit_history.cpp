// SPDX-License-Identifier: Apache-2.0
#include "viewer/document/edit_history.h"

#include "core/contract.h"

namespace pol {

void EditHistory::push(Scene scene, const std::string& label) {
    steps_.resize(at_ + 1);
    Step& current = steps_[at_];
    if (current.open && current.label == label) {
        current.scene = std::move(scene);
        current.id = next_id_++;
        return;
    }
    current.open = false;
    steps_.push_back({std::move(scene), label, next_id_++, true});
    if (steps_.size() > longest) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void EditHistory::undo() {
    POL_EXPECTS(can_undo());
    seal();
    --at_;
    seal();
}

void EditHistory::redo() {
    POL_EXPECTS(can_redo());
    ++at_;
    seal();
}

}  // namespace pol
