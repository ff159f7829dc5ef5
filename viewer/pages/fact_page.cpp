// SPDX-License-Identifier: Apache-2.0
#include "viewer/pages/fact_page.h"

#include <memory>

namespace pol {

FactPage make_fact_page(const Session& session) {
    const ShownFact shown = *session.current()->fact();
    FactPage page;
    page.fact = shown.fact;
    page.view = &shown.fact->views[shown.view];
    const PixelAddress pixel{page.view->x, page.view->y};
    page.pinned = session.selection().pinned() == pixel && session.selection().sample == 0;

    std::shared_ptr<const Explanation> explanation = page.pinned ? session.explanation() : nullptr;
    if (explanation && (!explanation->exact() || explanation->result.failures != 0)) {
        page.trouble = explanation->exact() ? "the tree of the pixel has numbers that went bad"
                                            : "the tree of the pixel is not what the picture is made of";
        explanation.reset();
    }
    for (const verify::Reading& reading : shown.fact->readings) {
        if (reading.view != shown.view) continue;
        FactRow row{&reading};
        if (explanation) row.result = judge(reading, *explanation);
        page.rows.push_back(row);
    }
    return page;
}

}  // namespace pol
