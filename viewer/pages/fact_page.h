// SPDX-License-Identifier: Apache-2.0
// What the current document's fact expects at its pixel beside what is found there. No ImGui.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/facts/fact.h"
#include "viewer/session/session.h"

namespace pol {

struct FactRow {
    const verify::Reading* reading = nullptr;
    std::optional<verify::ReadingResult> result{};  ///< none until the tree of the fact's pixel is there
};

struct FactPage {
    const verify::Fact* fact = nullptr;
    const verify::FactView* view = nullptr;
    bool pinned = false;          ///< the pinned pixel and sample are those that the fact is about
    std::string trouble{};        ///< why the tree says nothing about the fact; empty: it does
    std::vector<FactRow> rows{};  ///< the readings of the view
};

/// Requires: the current document has a fact.
FactPage make_fact_page(const Session& session);

}  // namespace pol
