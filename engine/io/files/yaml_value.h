// SPDX-License-Identifier: Apache-2.0
// A YAML document read with a ruler in hand: every value knows its file, line, column and key path, and every access
// says what it expects. Used by the readers of this folder only.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/source_place.h"
#include "core/vec.h"

namespace pol {

/// How a reader gives up. Thrown and caught inside io/, never seen outside.
struct YamlComplaint {
    Error error;
};

/// What all values of one file share.
struct YamlFile {
    std::string name;  ///< for messages
    int index = 0;     ///< SourcePlace::file
    /// Places of all values that were read, by key path; shared between a scene and its includes.
    std::map<std::string, Place>* places = nullptr;
};

class YamlMap;

/// One node of the document. Cheap to copy; refers to a YamlFile that must outlive it.
class YamlValue {
public:
    YamlValue(const YAML::Node& node, const YamlFile& file, std::string path);

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] SourcePlace place() const;
    [[nodiscard]] Place message_place() const;
    /// Throws YamlComplaint at this value.
    [[noreturn]] void fail(std::string what, std::string hint) const;

    [[nodiscard]] bool is_map() const { return node_.IsMap(); }
    [[nodiscard]] bool is_list() const { return node_.IsSequence(); }
    [[nodiscard]] bool is_scalar() const { return node_.IsScalar(); }
    /// A plain (unquoted) scalar that starts like a number, nan and inf included.
    [[nodiscard]] bool looks_like_number() const;

    // Each of these throws YamlComplaint if the value is something else.
    /// A map of which only `known` keys may occur, each once. Here and in entries(), merge keys (<<) are followed: keys
    /// of the map itself win, then those of the first merged map.
    [[nodiscard]] YamlMap map(const std::vector<std::string_view>& known) const;
    [[nodiscard]] YamlMap map(std::initializer_list<std::string_view> known) const;
    /// A map whose keys are names the user chose, each once, in the order of the file.
    [[nodiscard]] std::vector<std::pair<std::string, YamlValue>> entries() const;
    /// The only entry of a map that holds exactly one of `known`: a tagged value such as {sphere: {...}}.
    [[nodiscard]] std::pair<std::string, YamlValue> tagged(std::initializer_list<std::string_view> known) const;
    /// Key paths count from `first`, for lists that continue another file's.
    [[nodiscard]] std::vector<YamlValue> list(std::size_t first = 0) const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string choice(std::initializer_list<std::string_view> known) const;
    /// The place of the word in `known`, counted from 0.
    [[nodiscard]] int choice_of(const std::vector<std::string_view>& known) const;
    [[nodiscard]] bool truth() const;
    /// Finite number.
    [[nodiscard]] double number() const;
    /// Degrees, or "<number> rad". Returns radians.
    [[nodiscard]] double angle() const;
    [[nodiscard]] int whole() const;
    [[nodiscard]] std::uint64_t natural64() const;
    [[nodiscard]] std::vector<double> numbers() const;
    [[nodiscard]] DVec2 vec2() const;
    [[nodiscard]] DVec3 vec3() const;

private:
    friend class YamlMap;
    struct Pair {
        std::string key;
        Place place;  ///< of the key
        YAML::Node value;
    };
    [[nodiscard]] std::vector<Pair> pairs() const;
    void add_pairs(const YAML::Node& map, std::set<std::string>& taken, int& merged, std::vector<Pair>& result) const;
    [[nodiscard]] const std::string& plain(const char* expected) const;
    [[nodiscard]] std::string kind() const;
    [[nodiscard]] std::vector<double> numbers(std::size_t count) const;

    YAML::Node node_;
    const YamlFile* file_;
    std::string path_;
};

/// A map with a fixed set of keys.
class YamlMap {
public:
    /// The value of `key`; throws YamlComplaint at the map if there is none.
    [[nodiscard]] YamlValue at(const std::string& key) const;
    [[nodiscard]] std::optional<YamlValue> find(const std::string& key) const;
    [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) > 0; }
    [[nodiscard]] const YamlValue& self() const { return self_; }

private:
    friend class YamlValue;
    explicit YamlMap(YamlValue self) : self_(std::move(self)) {}

    YamlValue self_;
    std::map<std::string, YamlValue> values_;
};

/// What is wrong with `text`, which the parser gave up at `problem`: a tab that indents, if that is its place.
Error yaml_text_problem(const YAML::Exception& problem, std::string_view text, const std::string& file_name);

/// The one document of `text`. Throws YamlComplaint if it is empty, not YAML, or more than one document.
YamlValue yaml_document(const std::string& text, const YamlFile& file);

/// "a, b or c".
std::string one_of(const std::vector<std::string_view>& words);

/// Hint for an unknown word: the nearest known one, else all of them.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace pol
