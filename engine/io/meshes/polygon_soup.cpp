// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/polygon_soup.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace pol {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

template <class T>
std::optional<T> parsed(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    T value{};
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc() || end != word.data() + word.size() || word.empty()) return std::nullopt;
    return value;
}

}  // namespace

Error mesh_error(std::string what, int line, std::string hint) {
    Error error;
    error.what = std::move(what);
    error.place.line = line;
    error.hint = std::move(hint);
    return error;
}

Error mesh_error_at_byte(const std::string& what, std::size_t offset, std::string hint) {
    return mesh_error("at byte " + std::to_string(offset) + ": " + what, 0, std::move(hint));
}

std::string_view TextCursor::take_line() {
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    const std::string_view line = text_.substr(start, at_ - start);
    if (!at_end()) at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++line_;
    return line;
}

std::string_view TextCursor::take_word() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_)
        line_ += text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_, 2) != "\r\n");
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
}

std::string quoted(std::string_view word) {
    return "'" + std::string(word.substr(0, 40)) + "'";
}

std::string_view take_word_of(std::string_view& line) {
    std::size_t start = 0;
    while (start < line.size() && is_space(line[start])) ++start;
    std::size_t end = start;
    while (end < line.size() && !is_space(line[end])) ++end;
    const std::string_view word = line.substr(start, end - start);
    line.remove_prefix(end);
    return word;
}

std::optional<double> finite_number(std::string_view word) {
    const std::optional<double> value = parsed<double>(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> whole_number(std::string_view word) {
    return parsed<std::int64_t>(word);
}

}  // namespace pol
