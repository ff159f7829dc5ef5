// SPDX-License-Identifier: Apache-2.0
#include "viewer/fact_sheet.h"

#include <memory>

namespace pol {

FactSheet make_fact_sheet(const Session& session) {
    const ShownFact shown = *session.current()->fact();
    FactSheet sheet;
    sheet.fact = shown.fact;
    sheet.view = &shown.fact->views[shown.view];
    const PixelAddress pixel{sheet.view->x, sheet.view->y};
    sheet.pinned = session.selection.pinned() == pixel && session.selection.sample == 0;

    std::shared_ptr<const Explanation> explanation = sheet.pinned ? session.explanation() : nullptr;
    if (explanation && (!explanation->exact() || explanation->result.failures != 0)) {
        sheet.trouble = explanation->exact() ? "the tree of the pixel has numbers that went bad"
                                             : "the tree of the pixel is not what the picture is made of";
        explanation.reset();
    }
    for (const verify::Reading& reading : shown.fact->readings) {
        if (reading.view != shown.view) continue;
        FactRow row{&reading};
        if (explanation) row.result = judge(reading, *explanation);
        sheet.rows.push_back(row);
    }
    return sheet;
}

}  // namespace pol
