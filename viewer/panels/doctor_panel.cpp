// SPDX-License-Identifier: Apache-2.0
#include "viewer/panels/doctor_panel.h"

#include <imgui.h>

#include "viewer/widgets/ink.h"
#include "viewer/widgets/question.h"

namespace pol {

void DoctorPanel::draw(const Session& session, Wishes& wishes) {
    const Document* document = session.current();
    const Document* reference = session.reference();
    if (document == nullptr || reference == nullptr || document == reference) {
        asked_.reset();
        ImGui::TextWrapped(
            "Which convention makes one picture from another? Take one for the reference (Shift+X) and show "
            "the other.");
        return;
    }
    const Patients shown{document->picture_layout(), document->picture_version(), reference->picture_layout(),
                         reference->picture_version()};
    const bool is_answered =
        asked_ && asked_->layout == shown.layout && asked_->reference_layout == shown.reference_layout;
    // While one of them is rendered the answer stays as it was until it is asked for again.
    const bool is_stale = is_answered && *asked_ != shown && !document->tracing() && !reference->tracing();
    if (button("Ask the convention doctor") || is_stale) {
        const auto advice = session.convention_advice();
        answer_ = advice ? advice.value().verdict : to_string(advice.error());
        adopt_ = advice ? advice.value().adopt : std::nullopt;
        asked_ = shown;
    }
    tooltip("Which change of handedness, axes or frame makes this picture from the reference (V).");
    if (!asked_ || asked_->layout != shown.layout || asked_->reference_layout != shown.reference_layout) return;
    ImGui::TextWrapped("%s", answer_.c_str());
    if (!adopt_) return;
    ImGui::TextWrapped("Its numbers may be: %s.", adopt_->text().c_str());
    if (button("Take them for that")) {
        wishes.add([of = document, convention = *adopt_](Session& s) { s.take_numbers_for(of, convention); });
    }
    tooltip("Sets what the numbers of this picture are taken for (Scene tab), which can be changed back there.");
}

}  // namespace pol
