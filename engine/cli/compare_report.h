// SPDX-License-Identifier: Apache-2.0
// What `polariscope compare` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/agreement.h"
#include "compare/convention_doctor.h"
#include "compare/error_metrics.h"
#include "compare/pairing.h"

namespace pol {

/// One of the two pictures, as the user sees it.
struct ComparedPicture {
    std::string name;
    int width = 0;
    int height = 0;
    int left = 0;
    int top = 0;
    std::vector<std::string> bands;
    PictureOrigin origin;  ///< as it was read
};

/// How far apart the pictures are under one assumption on B.
struct Distance {
    ErrorMetrics metrics;  ///< of B, A the reference
    compare::Agreement agreement;
};

struct ComparisonReport {
    ComparedPicture a;
    ComparedPicture b;
    std::vector<std::string> remarks;
    compare::ConventionVerdict verdict;
    std::optional<StokesConvention> adoptable;
    bool adopted = false;  ///< `distance` is with it
    /// Empty if nothing can be subtracted: B lies across.
    std::optional<Distance> distance;
    std::optional<ErrorMetrics> with_adoptable;  ///< what it would be
    std::vector<std::string> compared_bands;
    std::optional<double> tolerance;  ///< Agreement::distance up to which the user takes them for the same
    int box = 1;                      ///< pixels of A along a side of what is compared
    int left = 0;                     ///< pixel of A's whole picture at which that begins
    int top = 0;

    [[nodiscard]] bool is_same() const { return distance && distance->agreement.is_same(); }
    /// Never where the polarizations contradict each other: a weak component hardly counts in a distance.
    [[nodiscard]] bool is_within_tolerance() const;
    /// The doctor found nothing wrong with the polarization of B, or that was adopted.
    [[nodiscard]] bool has_our_convention() const;
};

std::string comparison_text(const ComparisonReport& report);
std::string comparison_json(const ComparisonReport& report);

}  // namespace pol
