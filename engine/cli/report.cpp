// SPDX-License-Identifier: Apache-2.0
#include "cli/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <system_error>

namespace pol {

namespace {

namespace fs = std::filesystem;

/// Length of the UTF-8 character (RFC 3629) that `text` begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) >= 0xa0;
    const bool beyond = first == 0xf4 && byte(1) >= 0x90;
    const bool control = first == 0xc2 && byte(1) < 0xa0;
    return overlong || surrogate || beyond || control ? 0 : length;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code failed;
    if (fs::equivalent(a, b, failed) && !failed) return true;
    const fs::path real_a = fs::weakly_canonical(a, failed);
    const fs::path real_b = fs::weakly_canonical(b, failed);
    return !failed && real_a == real_b;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        const bool is_control = (first < 0x20 && first != '\n') || first == 0x7f;
        const std::size_t length = is_control ? 0 : character_length(text);
        out += length > 0 ? std::string(text.substr(0, length)) : fmt::format("\\x{:02x}", first);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

void remark(const std::string& text) {
    static_cast<void>(std::fputs(text.c_str(), stderr));
}

int report(const Error& error) {
    remark("polariscope: " + printable(to_string(error)) + "\n");
    return static_cast<int>(error.kind);
}

std::string duration_text(double seconds) {
    if (seconds < 0.9995) return fmt::format("{:.0f} ms", 1e3 * seconds);
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    const double whole = std::round(seconds);
    if (whole < 60.0) return fmt::format("{:.0f} s", whole);
    const double minutes = std::floor(whole / 60.0);
    if (minutes < 60.0) return fmt::format("{:.0f} min {:.0f} s", minutes, whole - 60.0 * minutes);
    const double hours = std::floor(minutes / 60.0);
    return fmt::format("{:.0f} h {:.0f} min", hours, minutes - 60.0 * hours);
}

std::string count_text(std::uint64_t count) {
    const auto number = static_cast<double>(count);
    if (count < 1'000'000) return fmt::format("{}", count);
    if (count < 1'000'000'000) return fmt::format("{:.2f} million", 1e-6 * number);
    return fmt::format("{:.2f} billion", 1e-9 * number);
}

std::optional<Error> output_problem(const fs::path& output, std::string_view ending,
                                    const std::vector<fs::path>& others) {
    const auto refuse = [&output](std::string what, std::string hint) {
        return Error{ErrorKind::usage, std::move(what), Place{output.string()}, {}, std::move(hint)};
    };
    if (!ending.empty() && lower(output.extension().string()) != ending) {
        const bool has_name = output.has_filename() && output.filename() != ending;
        const fs::path name = has_name ? output : output.parent_path() / "name";
        return refuse(fmt::format("the name of the output does not end in {}", ending),
                      fmt::format("for example {}", fs::path(name).replace_extension(ending).string()));
    }
    for (const fs::path& other : others) {
        if (!other.empty() && is_same_file(output, other))
            return refuse(fmt::format("would be written over {}", other.string()), "choose another name");
    }
    return std::nullopt;
}

}  // namespace pol
