// SPDX-License-Identifier: Apache-2.0
// What a timing has to say about the machine it was taken on (Linux; elsewhere the figures are unknown).
#pragma once

#include <string>

namespace pol::verify {

std::string cpu_name();

/// Load average over the last minute; NaN if unknown.
double load_average();

/// User and system time of all threads of this process so far, seconds.
double cpu_seconds();

/// "2026-11-25T18:00:00Z"
std::string utc_now();

}  // namespace pol::verify
