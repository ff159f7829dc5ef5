// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/machine.h"

#include <array>
#include <ctime>
#include <fstream>
#include <limits>

namespace pol::verify {

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

double load_average() {
    double load = std::numeric_limits<double>::quiet_NaN();
    std::ifstream file("/proc/loadavg");
    return file >> load ? load : std::numeric_limits<double>::quiet_NaN();
}

double cpu_seconds() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

}  // namespace pol::verify
