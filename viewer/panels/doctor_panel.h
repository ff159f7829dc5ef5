// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// What the convention doctor says of the picture on screen and the reference, once it is asked.
class DoctorPanel {
public:
    void draw(const Session& session, Wishes& wishes);

private:
    /// That the answer is about.
    struct Patients {
        std::uint64_t layout = 0;
        std::uint64_t version = 0;
        std::uint64_t reference_layout = 0;
        std::uint64_t reference_version = 0;
        friend bool operator==(const Patients&, const Patients&) = default;
    };
    std::optional<Patients> asked_;
    std::string answer_;
    std::optional<StokesConvention> adopt_;
};

}  // namespace pol
