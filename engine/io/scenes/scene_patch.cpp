// SPDX-License-Identifier: Apache-2.0
// Long because it is one algorithm: where a value stands, how it is written, and what a change of it means.
//
// save_scene() writes both scenes, with every key. Where the two texts differ, the value of the same key path in the
// source is changed, or the nearest that contains it. Whether that was right is seen by reading the result.
#include "io/scenes/scene_patch.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/number_text.h"
#include "core/overloaded.h"
#include "core/units.h"
#include "io/scenes/scene_file.h"
#include "io/scenes/scene_hash.h"
#include "scene/medium_fields.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

/// The change cannot be made in the source. Thrown and caught in this file.
struct CannotBeSaid {};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_one_of(char c, std::string_view characters) {
    return characters.find(c) != std::string_view::npos;
}

std::optional<double> number_in(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string rounded(double value, int digits) {
    return number_text(number_in(fmt::format("{:.{}g}", value, digits)).value_or(value));
}

/// The value of `key`; not defined if there is none.
YAML::Node child(const YAML::Node& map, const std::string& key) {
    for (const auto& pair : map)
        if (pair.first.IsScalar() && pair.first.Scalar() == key) return pair.second;
    return YAML::Node(YAML::NodeType::Undefined);
}

bool has(const YAML::Node& map, const std::string& key) {
    return child(map, key).IsDefined();
}

/// The value of that key of a medium is a refractive index.
bool is_index(std::string_view key) {
    bool found = false;
    for_each_kind([&](const auto& kind) {
        for_each_field(kind,
                       Overloaded{[&](const auto& row, const RefractiveIndex&) { found = found || row.key == key; },
                                  [](const auto&, const Absorption&) {}, [](const auto&, const DVec3&) {},
                                  [](const auto&, AxisSpace) {}});
    });
    return found;
}

/// YAML as text and as a tree: which characters a value is made of.
class Text {
public:
    explicit Text(std::string text) : text_(std::move(text)), root_(YAML::Load(text_)) {}

    [[nodiscard]] const std::string& all() const { return text_; }
    [[nodiscard]] const YAML::Node& root() const { return root_; }

    [[nodiscard]] std::size_t begin(const YAML::Node& node) const {
        const YAML::Mark mark = node.Mark();
        if (mark.is_null() || static_cast<std::size_t>(mark.pos) >= text_.size()) throw CannotBeSaid{};
        return static_cast<std::size_t>(mark.pos);
    }
    /// Behind its last character.
    [[nodiscard]] std::size_t end(const YAML::Node& node) const {
        const std::size_t first = begin(node);
        if (is_one_of(text_[first], "[{")) return end_of_brackets(first);
        if (node.IsScalar()) {
            if (is_one_of(text_[first], "\"'")) return end_of_quotes(first);
            // A plain scalar of one line stands there as it is read.
            const std::string& word = node.Scalar();
            if (word.empty() || text_.compare(first, word.size(), word) != 0) throw CannotBeSaid{};
            return first + word.size();
        }
        if (node.size() == 0) throw CannotBeSaid{};  // nothing, or an alias
        std::size_t last = first;
        for (const auto& item : node) last = std::max(last, end(node.IsMap() ? item.second : item));
        return last;
    }
    [[nodiscard]] std::string of(const YAML::Node& node) const {
        return text_.substr(begin(node), end(node) - begin(node));
    }
    /// In brackets, as in JSON.
    [[nodiscard]] bool is_flow(const YAML::Node& node) const { return is_one_of(text_[begin(node)], "[{"); }

    [[nodiscard]] std::size_t start_of_line(std::size_t index) const {
        const std::size_t found = index == 0 ? std::string::npos : text_.rfind('\n', index - 1);
        return found == std::string::npos ? 0 : found + 1;
    }
    /// Before the one or two characters that end the line.
    [[nodiscard]] std::size_t end_of_line(std::size_t index) const {
        const std::size_t found = std::min(text_.find('\n', index), text_.size());
        return found > index && text_[found - 1] == '\r' ? found - 1 : found;
    }
    /// The first character from `index` on that is no space.
    [[nodiscard]] std::size_t next_word(std::size_t index) const {
        return std::min(text_.find_first_not_of(" \t\r\n", index), text_.size());
    }

private:
    [[nodiscard]] std::size_t end_of_quotes(std::size_t first) const {
        const char quote = text_[first];
        for (std::size_t i = first + 1; i < text_.size(); ++i) {
            const bool is_escape = quote == '"' ? text_[i] == '\\' : text_.compare(i, 2, "''") == 0;
            if (is_escape)
                ++i;
            else if (text_[i] == quote)
                return i + 1;
        }
        throw CannotBeSaid{};
    }
    [[nodiscard]] std::size_t end_of_brackets(std::size_t first) const {
        int depth = 0;
        char before = ' ';  // the last character that is no space
        for (std::size_t i = first; i < text_.size(); ++i) {
            const char c = text_[i];
            if (is_one_of(c, "\"'") && is_one_of(before, "[{,:")) {
                i = end_of_quotes(i) - 1;
            } else if (c == '#' && is_one_of(text_[i - 1], " \t\n")) {
                i = end_of_line(i);
            } else if (is_one_of(c, "[{")) {
                ++depth;
            } else if (is_one_of(c, "]}") && --depth == 0) {
                return i + 1;
            }
            if (!is_one_of(c, " \t\r\n")) before = c;
        }
        throw CannotBeSaid{};
    }

    std::string text_;
    YAML::Node root_;
};

/// Collects what is to be changed in the source.
class Patch {
public:
    Patch(const Text& source, const Text& before, const Text& after) : source_(source), before_(before), after_(after) {
        const YAML::Node& root = source.root();
        is_json_ = source.is_flow(root) && root.size() > 0 && source.all()[source.begin(root.begin()->first)] == '"';
        compare(root, before.root(), after.root(), "");
    }

    /// Files that the source names beside itself, in `from`, as seen from `to`.
    void name_files(const YAML::Node& node, const std::string& key, const fs::path& from, const fs::path& to) {
        if (node.IsMap()) {
            for (const auto& pair : node)
                if (pair.first.IsScalar()) name_files(pair.second, pair.first.Scalar(), from, to);
        } else if (node.IsSequence()) {
            for (const auto& item : node) name_files(item, key, from, to);
        } else if (node.IsScalar()) {
            const std::string& name = node.Scalar();
            const bool is_name = is_one_of(key, {"file", "texture", "include"}) || name.ends_with(".yml") ||
                                 name.ends_with(".yaml") || name.find('/') != std::string::npos;
            std::error_code failed;
            if (!is_name || fs::path(name).is_absolute() || !fs::is_regular_file(from / name, failed)) return;
            const std::string there = fs::relative(from / name, to, failed).generic_string();
            if (failed || there.empty() || there.find_first_of("\"\\\n") != std::string::npos) throw CannotBeSaid{};
            changes_.push_back({source_.begin(node), source_.end(node), '"' + there + '"'});
        }
    }

    [[nodiscard]] std::string result() const {
        std::vector<Change> changes = changes_;
        std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
            return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
        });
        std::string text;
        std::size_t copied = 0;
        for (const Change& change : changes) {
            if (change.begin < copied) throw CannotBeSaid{};  // two changes of one thing
            text += source_.all().substr(copied, change.begin - copied) + change.text;
            copied = change.end;
        }
        return text + source_.all().substr(copied);
    }

private:
    static constexpr int digits_of_any_double = 17;

    /// `text` instead of the characters from `begin` to `end` of the source.
    struct Change {
        std::size_t begin;
        std::size_t end;
        std::string text;
    };

    /// `text` is the source's spelling of `before`; `key` the one it stands behind, if any.
    void compare(const YAML::Node& text, const YAML::Node& before, const YAML::Node& after, const std::string& key) {
        if (before_.of(before) == after_.of(after)) return;
        if (text.IsMap() && before.IsMap() && after.IsMap()) return compare_maps(text, before, after, key);
        const bool are_lists = text.IsSequence() && before.IsSequence() && after.IsSequence();
        // Objects of included files follow those of the source.
        const bool may_be_longer = key == "objects";
        if (!are_lists || before.size() != after.size() || (text.size() != before.size() && !may_be_longer))
            return replace(text, after, key);
        for (std::size_t i = 0; i < text.size(); ++i) compare(text[i], before[i], after[i], "");
    }

    void compare_maps(const YAML::Node& text, const YAML::Node& before, const YAML::Node& after,
                      const std::string& key) {
        if (key == "polarization" && turn(text, before, after)) return;
        // Other keys than those that are saved, as in {crystal: calcite}: a key that is missing has no place there.
        const bool is_spelled_otherwise = std::any_of(text.begin(), text.end(), [&](const auto& pair) {
            const std::string& word = pair.first.Scalar();
            return word != "include" && !has(before, word) && !has(after, word);
        });
        // Another kind of thing, such as a Stokes vector instead of a crystal plate.
        if (std::none_of(text.begin(), text.end(), [&](const auto& pair) { return has(after, pair.first.Scalar()); }))
            return replace(text, after, key);
        const std::size_t changes_outside = changes_.size();
        bool fits = true;
        for (const auto& pair : after) {
            const std::string& word = pair.first.Scalar();
            const YAML::Node old = child(before, word);
            const YAML::Node there = child(text, word);
            if (old.IsDefined() && before_.of(old) == after_.of(pair.second)) continue;
            if (there.IsDefined() && old.IsDefined())
                compare(there, old, pair.second, word);
            else if (there.IsDefined())
                replace(there, pair.second, word);
            else if (is_spelled_otherwise)
                fits = false;
            else
                insert(text, after, word, value(pair.second, old, word));
        }
        for (const auto& pair : before) {
            const std::string& word = pair.first.Scalar();
            if (has(after, word)) continue;
            if (has(text, word))
                remove(text, word);
            else
                fits = fits && !is_spelled_otherwise;
        }
        if (fits) return;
        changes_.resize(changes_outside);
        replace(text, after, key);
    }

    /// Linear light of {dop: p, azimuth: psi} that has only been turned: (s1, s2) = p (cos 2 psi, sin 2 psi). The
    /// azimuth with the fewest digits that gives these very numbers; false if none does.
    bool turn(const YAML::Node& text, const YAML::Node& before, const YAML::Node& after) {
        const YAML::Node azimuth = child(text, "azimuth");
        const YAML::Node stokes = child(after, "stokes");
        if (!azimuth.IsDefined() || has(text, "ellipticity") || !stokes.IsDefined()) return false;
        if (before_.of(child(before, "x_axis")) != after_.of(child(after, "x_axis"))) return false;
        const auto degree = number_in(child(text, "dop").Scalar());
        const auto s1 = number_in(after_.of(stokes[0]));
        const auto s2 = number_in(after_.of(stokes[1]));
        if (!degree || !s1 || !s2 || after_.of(stokes[2]) != "0") return false;
        const double azimuth_deg = degrees(0.5 * std::atan2(*s2, *s1));
        for (int digits = 1; digits <= digits_of_any_double; ++digits) {
            for (const double half_turn_deg : {0.0, 180.0}) {
                const std::string word = rounded(azimuth_deg + half_turn_deg, digits);
                const double twice = 2.0 * radians(number_in(word).value_or(0.0));
                if (*degree * std::cos(twice) != *s1 || *degree * std::sin(twice) != *s2) continue;
                changes_.push_back({source_.begin(azimuth), source_.end(azimuth), word});
                return true;
            }
        }
        return false;
    }

    void replace(const YAML::Node& text, const YAML::Node& after, const std::string& key) {
        const std::string old = source_.of(text);
        if (old.find('#') != std::string::npos) throw CannotBeSaid{};  // a comment would be lost
        const bool in_radians = is_angle(key) && old.find(" rad") != std::string::npos;
        changes_.push_back({source_.begin(text), source_.end(text),
                            in_radians ? angle(after_.of(after), true) : value(after, {}, key)});
    }

    /// Behind the last entry of one line that stays, else as the first entry.
    void insert(const YAML::Node& map, const YAML::Node& after, const std::string& key, const std::string& value) {
        const std::string entry = key_text(key) + value;
        std::size_t place = source_.begin(map);
        const YAML::Node first_key = map.begin()->first;
        const bool in_brackets = source_.is_flow(map);
        bool found = false;
        for (const auto& pair : map) {
            const bool is_line = in_brackets || pair.second.IsScalar() || source_.is_flow(pair.second);
            if (!is_line || !has(after, pair.first.Scalar())) continue;
            place = source_.end(pair.second);
            found = true;
        }
        if (in_brackets) {
            if (!found) throw CannotBeSaid{};
            changes_.push_back({place, place, ", " + entry});
            return;
        }
        const std::size_t column = source_.begin(first_key) - source_.start_of_line(source_.begin(first_key));
        const std::string indent(column, ' ');
        const std::string end = source_.all().find("\r\n") == std::string::npos ? "\n" : "\r\n";
        if (found) place = source_.end_of_line(place);
        changes_.push_back({place, place, found ? end + indent + entry : entry + end + indent});
    }

    void remove(const YAML::Node& map, const std::string& key) {
        const auto entry = std::find_if(map.begin(), map.end(), [&](const auto& p) { return p.first.Scalar() == key; });
        const std::string& all = source_.all();
        std::size_t begin = source_.begin(entry->first);
        std::size_t end = source_.end(entry->second);
        if (source_.is_flow(map)) {
            const std::size_t before = all.find_last_not_of(" \t\r\n", begin - 1);
            const std::size_t behind = source_.next_word(end);
            if (all[before] == ',')
                begin = before;
            else if (all[behind] == ',')
                end = source_.next_word(behind + 1);
        } else {
            begin = source_.start_of_line(begin);
            const std::size_t line_end = source_.end_of_line(end);
            const bool is_alone = all.find_first_not_of(" \t", begin) == source_.begin(entry->first) &&
                                  source_.next_word(end) >= line_end && map.size() > 1;
            if (!is_alone) throw CannotBeSaid{};
            end = std::min(all.find('\n', line_end), all.size() - 1) + 1;
        }
        if (all.substr(begin, end - begin).find('#') != std::string::npos) throw CannotBeSaid{};
        changes_.push_back({begin, end, ""});
    }

    [[nodiscard]] std::string key_text(const std::string& key) const {
        return is_json_ ? '"' + key + "\": " : key + ": ";
    }

    /// As people write it: on one line, short where the format allows it. Of a section that the source does not have
    /// (`old`: as it was), only what changed.
    [[nodiscard]] std::string value(const YAML::Node& node, const YAML::Node& old, const std::string& key) const {
        if (node.IsScalar()) return scalar(after_.of(node), key);
        if (node.IsSequence()) {
            if (is_index(key) && node.size() == 2 && after_.of(node[1]) == "0") return value(node[0], {}, key);
            std::string items;
            for (const auto& item : node) items += (items.empty() ? "" : ", ") + value(item, {}, "");
            return "[" + items + "]";
        }
        const bool is_glass = node.size() == 2 && has(node, "index") && has(node, "absorption");
        if (is_glass && after_.of(child(node, "absorption")) == "0") return value(child(node, "index"), {}, "index");
        std::string entries;
        for (const auto& pair : node) {
            const std::string& word = pair.first.Scalar();
            const YAML::Node before = old.IsMap() ? child(old, word) : YAML::Node(YAML::NodeType::Undefined);
            if (before.IsDefined() && before_.of(before) == after_.of(pair.second)) continue;
            entries += (entries.empty() ? "" : ", ") + key_text(word) + value(pair.second, {}, word);
        }
        return "{" + entries + "}";
    }

    [[nodiscard]] std::string scalar(const std::string& saved, const std::string& key) const {
        const std::string text = is_angle(key) ? angle(saved, false) : saved;
        if (!is_json_ || text[0] == '"' || number_in(text)) return text;
        return text == "on" ? "true" : text == "off" ? "false" : '"' + text + '"';
    }

    static bool is_angle(const std::string& key) {
        return is_one_of(key, {"fov", "angle", "retardance", "apex_angle", "crown_angle", "pavilion_angle"});
    }

    /// Degrees with as few digits as give the same radians, or radians.
    static std::string angle(const std::string& saved, bool in_radians) {
        constexpr std::string_view unit = " rad";
        const bool was_in_radians = saved.ends_with(unit);
        const auto number =
            number_in(std::string_view(saved).substr(0, saved.size() - (was_in_radians ? unit.size() : 0)));
        if (!number) return saved;
        const double angle_rad = was_in_radians ? *number : radians(*number);
        if (in_radians) return number_text(angle_rad) + std::string(unit);
        for (int digits = 1; digits <= digits_of_any_double; ++digits) {
            const std::string text = rounded(degrees(angle_rad), digits);
            const auto angle_deg = number_in(text);
            if (angle_deg && radians(*angle_deg) == angle_rad) return text;
        }
        return saved;
    }

    const Text& source_;
    const Text& before_;
    const Text& after_;
    bool is_json_ = false;
    std::vector<Change> changes_;
};

}  // namespace

std::optional<std::string> patch_scene(const std::string& source, const Scene& before, const Scene& edited,
                                       const fs::path& from, const fs::path& to) {
    // Marks of YAML do not count the mark of UTF-8.
    const std::string utf8_mark = source.starts_with("\xef\xbb\xbf") ? "\xef\xbb\xbf" : "";
    std::string text;
    try {
        const Text there(source.substr(utf8_mark.size()));
        const Text saved_before(save_scene(before));
        const Text saved_after(save_scene(edited));
        Patch patch(there, saved_before, saved_after);
        if (from.parent_path() != to.parent_path())
            patch.name_files(there.root(), "", from.parent_path(), to.parent_path());
        text = utf8_mark + patch.result();
    } catch (const CannotBeSaid&) {
        return std::nullopt;
    } catch (const YAML::Exception&) {
        return std::nullopt;
    }
    const Result<Scene> read = parse_scene(text, to.string(), to.parent_path());
    const bool is_right = read && read.value().title == edited.title && scene_hash(read.value()) == scene_hash(edited);
    return is_right ? std::optional(text) : std::nullopt;
}

}  // namespace pol
