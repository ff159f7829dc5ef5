// SPDX-License-Identifier: Apache-2.0
// Long because every kind of value has its own complaint, and all of them share how places and words are shown.
#include "io/files/yaml_value.h"

#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <system_error>

#include "core/nearest_word.h"
#include "core/units.h"

namespace pol {
namespace {

/// Characters that look like a space or like nothing, and that YAML takes for letters.
constexpr std::pair<std::string_view, std::string_view> unseen[] = {
    {"\u00a0", "U+00A0"}, {"\u00ad", "U+00AD"}, {"\u2007", "U+2007"}, {"\u2009", "U+2009"},
    {"\u200b", "U+200B"}, {"\u202f", "U+202F"}, {"\u3000", "U+3000"}, {"\ufeff", "U+FEFF"}};

std::string shortened(const std::string& text) {
    std::string result = text.size() <= 40 ? text : text.substr(0, 37) + "...";
    for (const auto& [bytes, name] : unseen) {
        for (std::size_t at = result.find(bytes); at != std::string::npos; at = result.find(bytes))
            result.replace(at, bytes.size(), "<" + std::string(name) + ">");
    }
    return result;
}

std::string quoted(const std::string& text) {
    return "'" + shortened(text) + "'";
}

std::string child_path(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

Place place_of(const YAML::Mark& mark, const YamlFile& file) {
    if (mark.is_null()) return {file.name, 0, 0};
    return {file.name, mark.line + 1, mark.column + 1};
}

[[noreturn]] void complain(Place place, std::string field, std::string what, std::string hint) {
    throw YamlComplaint{{ErrorKind::input, std::move(what), std::move(place), std::move(field), std::move(hint)}};
}

/// The whole of `text` as a T, a leading plus allowed as in YAML.
template <class T>
std::errc parse(const std::string& text, T& value) {
    const char* first = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc{}) return error;
    return end == last ? std::errc{} : std::errc::invalid_argument;
}

/// YAML 1.2 core schema spells infinity and NaN with a dot; people and other programs do not.
bool spells_no_finite_number(std::string text) {
    for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    static const std::set<std::string> words{".nan",  "nan",  ".inf",     "inf",       "+.inf",     "+inf",
                                             "-.inf", "-inf", "infinity", "-infinity", "+infinity", "-nan"};
    return words.count(text) > 0;
}

std::vector<std::string_view> words(std::initializer_list<std::string_view> list) {
    return {list.begin(), list.end()};
}

}  // namespace

YamlValue::YamlValue(const YAML::Node& node, const YamlFile& file, std::string path)
    : node_(node), file_(&file), path_(std::move(path)) {
    if (file_->places != nullptr) file_->places->insert_or_assign(path_, message_place());
}

Place YamlValue::message_place() const {
    return place_of(node_.Mark(), *file_);
}

SourcePlace YamlValue::place() const {
    const Place at = message_place();
    return {file_->index, at.line, at.column};
}

void YamlValue::fail(std::string what, std::string hint) const {
    complain(message_place(), path_, std::move(what), std::move(hint));
}

std::string YamlValue::kind() const {
    if (node_.IsMap()) return "a map";
    if (node_.IsSequence()) return "a list";
    if (node_.IsScalar()) return quoted(node_.Scalar());
    return "nothing";
}

bool YamlValue::looks_like_number() const {
    if (!node_.IsScalar() || node_.Tag() == "!") return false;
    const std::string& text = node_.Scalar();
    if (spells_no_finite_number(text)) return true;
    double value = 0.0;
    return parse(text, value) != std::errc::invalid_argument;
}

const std::string& YamlValue::plain(const char* expected) const {
    if (!node_.IsScalar()) fail("found " + kind() + ", expected " + expected, std::string("write ") + expected);
    if (node_.Tag() == "!") {
        fail("found the text " + quoted(node_.Scalar()) + ", expected " + expected, "leave the quotes out");
    }
    return node_.Scalar();
}

YamlMap YamlValue::map(std::initializer_list<std::string_view> known) const {
    return map(words(known));
}

YamlMap YamlValue::map(const std::vector<std::string_view>& known) const {
    YamlMap result(*this);
    for (const Pair& pair : pairs()) {
        bool is_known = false;
        for (const std::string_view word : known) is_known = is_known || word == pair.key;
        if (!is_known) {
            // The key, not its value: an unknown word is best pointed at itself.
            complain(pair.place, child_path(path_, pair.key), "unknown key '" + shortened(pair.key) + "'",
                     did_you_mean(pair.key, known));
        }
        result.values_.emplace(pair.key, YamlValue(pair.value, *file_, child_path(path_, pair.key)));
    }
    return result;
}

std::vector<std::pair<std::string, YamlValue>> YamlValue::entries() const {
    std::vector<std::pair<std::string, YamlValue>> result;
    for (const Pair& pair : pairs())
        result.emplace_back(pair.key, YamlValue(pair.value, *file_, child_path(path_, pair.key)));
    return result;
}

std::vector<YamlValue::Pair> YamlValue::pairs() const {
    if (!node_.IsMap()) fail("found " + kind() + ", expected a map", "write 'key: value' lines or {key: value}");
    std::vector<Pair> result;
    std::set<std::string> taken;
    int merged = 0;
    add_pairs(node_, taken, merged, result);
    return result;
}

void YamlValue::add_pairs(const YAML::Node& map, std::set<std::string>& taken, int& merged,
                          std::vector<Pair>& result) const {
    const char* const merge_key = "<<";
    std::map<std::string, Place> seen;
    std::vector<YAML::Node> sources;
    for (const auto& pair : map) {
        const Place place = place_of(pair.first.Mark(), *file_);
        if (!pair.first.IsScalar())
            complain(place, path_, "a key must be a word", "remove the brackets around the key");
        const std::string key = pair.first.Scalar();
        const auto [first, is_new] = seen.emplace(key, place);
        if (!is_new) {
            complain(place, child_path(path_, key), "the key " + quoted(key) + " occurs twice",
                     key == merge_key ? "write one list: <<: [*a, *b]"
                                      : "the first one is in line " + std::to_string(first->second.line));
        }
        if (key != merge_key || pair.first.Tag() == "!") {
            if (taken.insert(key).second) result.push_back({key, place, pair.second});
        } else if (pair.second.IsSequence()) {
            for (const YAML::Node& source : pair.second) sources.push_back(source);
        } else {
            sources.push_back(pair.second);
        }
    }
    // yaml.org/type/merge.html: a key of the map itself wins, then the first of the merged maps that has it.
    for (const YAML::Node& source : sources) {
        const Place place = seen.at(merge_key);
        const std::string path = child_path(path_, merge_key);
        if (!source.IsMap()) complain(place, path, "only maps can be merged", "write <<: *name or <<: [*a, *b]");
        // Also ends where a map merges itself.
        if (++merged > 100) complain(place, path, "more than 100 maps are merged", "write the keys out");
        add_pairs(source, taken, merged, result);
    }
}

std::pair<std::string, YamlValue> YamlValue::tagged(std::initializer_list<std::string_view> known) const {
    const std::string choices = one_of(words(known));
    if (!node_.IsMap()) fail("found " + kind() + ", expected a map with one of " + choices, "write {KEY: {...}}");
    const YamlMap checked = map(known);
    if (checked.values_.size() != 1) {
        fail("expected exactly one of " + choices + ", found " + std::to_string(checked.values_.size()), "keep one");
    }
    return *checked.values_.begin();
}

std::vector<YamlValue> YamlValue::list(std::size_t first) const {
    if (!node_.IsSequence()) fail("found " + kind() + ", expected a list", "write [a, b, ...] or '- ' lines");
    std::vector<YamlValue> result;
    for (const auto& item : node_) {
        result.emplace_back(item, *file_, path_ + "[" + std::to_string(first + result.size()) + "]");
    }
    return result;
}

std::string YamlValue::text() const {
    if (!node_.IsScalar() || node_.Scalar().empty()) fail("found " + kind() + ", expected text", "write a word");
    return node_.Scalar();
}

std::string YamlValue::choice(std::initializer_list<std::string_view> known) const {
    return std::string(known.begin()[choice_of(words(known))]);
}

int YamlValue::choice_of(const std::vector<std::string_view>& known) const {
    if (!node_.IsScalar()) fail("found " + kind() + ", expected " + one_of(known), "write one of these words");
    const std::string word = node_.Scalar();
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) fail("unknown word " + quoted(word), did_you_mean(word, known));
    return static_cast<int>(found - known.begin());
}

bool YamlValue::truth() const {
    const std::string& word = plain("on or off");
    if (word == "on" || word == "true" || word == "yes") return true;
    if (word == "off" || word == "false" || word == "no") return false;
    fail("found " + quoted(word) + ", expected on or off", "write on or off");
}

double YamlValue::number() const {
    const std::string& word = plain("a number");
    if (spells_no_finite_number(word)) fail(quoted(word) + " is not a finite number", "write a finite number");
    double value = 0.0;
    const std::errc error = parse(word, value);
    if (error == std::errc::result_out_of_range) {
        fail(quoted(word) + " does not fit a 64-bit floating-point number", "write a number between 1e-307 and 1e308");
    }
    if (error != std::errc{})
        fail("found " + quoted(word) + ", expected a number", "write a number such as 1.5 or 2e-3");
    return value;
}

double YamlValue::angle() const {
    constexpr std::string_view suffix = " rad";
    if (node_.IsScalar() && node_.Scalar().ends_with(suffix)) {
        YAML::Node value(node_.Scalar().substr(0, node_.Scalar().size() - suffix.size()));
        double angle_rad = 0.0;
        if (parse(value.Scalar(), angle_rad) == std::errc{} && std::isfinite(angle_rad)) return angle_rad;
    }
    if (node_.IsScalar() && !looks_like_number()) {
        fail("found " + quoted(node_.Scalar()) + ", expected an angle", "write degrees such as 45, or '0.5 rad'");
    }
    return radians(number());
}

int YamlValue::whole() const {
    const double value = number();
    int result = 0;
    if (parse(node_.Scalar(), result) == std::errc{}) return result;
    if (std::abs(value) > std::numeric_limits<int>::max()) {
        fail(quoted(node_.Scalar()) + " is too large", "at most " + std::to_string(std::numeric_limits<int>::max()));
    }
    fail("found " + quoted(node_.Scalar()) + ", expected a whole number", "write a number without a decimal point");
}

std::uint64_t YamlValue::natural64() const {
    static_cast<void>(number());
    std::uint64_t result = 0;
    if (parse(node_.Scalar(), result) == std::errc{}) return result;
    fail("found " + quoted(node_.Scalar()) + ", expected a whole number from 0 to 18446744073709551615",
         "write a number without sign and decimal point");
}

std::vector<double> YamlValue::numbers() const {
    std::vector<double> result;
    for (const YamlValue& item : list()) result.push_back(item.number());
    return result;
}

std::vector<double> YamlValue::numbers(std::size_t count) const {
    const std::string expected = "a list of " + std::to_string(count) + " numbers";
    const std::string hint = count == 2 ? "write [x, y]" : "write [x, y, z]";
    if (!node_.IsSequence()) fail("found " + kind() + ", expected " + expected, hint);
    if (node_.size() != count) {
        fail("found a list of " + std::to_string(node_.size()) + ", expected " + expected, hint);
    }
    return numbers();
}

DVec2 YamlValue::vec2() const {
    const std::vector<double> v = numbers(2);
    return {v[0], v[1]};
}

DVec3 YamlValue::vec3() const {
    const std::vector<double> v = numbers(3);
    return {v[0], v[1], v[2]};
}

YamlValue YamlMap::at(const std::string& key) const {
    const auto found = values_.find(key);
    if (found != values_.end()) return found->second;
    complain(self_.message_place(), child_path(self_.path(), key), "the key '" + key + "' is missing",
             "add '" + key + ": ...' here");
}

std::optional<YamlValue> YamlMap::find(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return std::nullopt;
    return found->second;
}

namespace {

/// Notes where the content of a document begins and ignores the rest.
class ContentMark : public YAML::EventHandler {
public:
    std::optional<YAML::Mark> mark;
    void OnDocumentStart(const YAML::Mark& /*at*/) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& at, YAML::anchor_t /*anchor*/) override { note(at); }
    void OnAlias(const YAML::Mark& at, YAML::anchor_t /*anchor*/) override { note(at); }
    void OnScalar(const YAML::Mark& at, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  const std::string& /*value*/) override {
        note(at);
    }
    void OnSequenceStart(const YAML::Mark& at, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                         YAML::EmitterStyle::value /*style*/) override {
        note(at);
    }
    void OnSequenceEnd() override {}
    void OnMapStart(const YAML::Mark& at, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                    YAML::EmitterStyle::value /*style*/) override {
        note(at);
    }
    void OnMapEnd() override {}

private:
    void note(const YAML::Mark& at) {
        if (!mark) mark = at;
    }
};

/// Line `number`, from 1, of `text`; empty beyond its end.
std::string_view line_of(std::string_view text, int number) {
    for (; number > 1; --number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

/// Where a second document begins in `text`, if there is one. YAML::LoadAll would do, but never ends where a document
/// begins with a character that begins nothing (a comma): such a document is found again and again.
std::optional<YAML::Mark> second_document(const std::string& text) {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    ContentMark first;
    ContentMark second;
    if (!parser.HandleNextDocument(first) || !parser.HandleNextDocument(second)) return std::nullopt;
    return second.mark;
}

}  // namespace

Error yaml_text_problem(const YAML::Exception& problem, std::string_view text, const std::string& file_name) {
    Error error{ErrorKind::input,
                "not valid YAML: " + problem.msg,
                place_of(problem.mark, {file_name}),
                {},
                "look at brackets, quotes and indentation in this line and the one before"};
    // Two causes that cannot be seen in an editor.
    const int line = error.place.line;
    const std::string_view content = line_of(text, line);
    const std::size_t tab = content.find('\t');
    if (tab < content.find_first_not_of(" \t-")) {
        error.place.column = static_cast<int>(tab) + 1;
        error.what = "not valid YAML: this line is indented with a tab; YAML allows only spaces";
        error.hint = "replace the tab by spaces";
        return error;
    }
    for (const auto& [bytes, name] : unseen) {
        for (int number = std::max(line - 1, 1); number <= line; ++number) {
            if (line_of(text, number).find(bytes) != std::string_view::npos)
                error.hint = "line " + std::to_string(number) + " holds the character " + std::string(name) +
                             ", which looks like a space but is none";
        }
    }
    return error;
}

namespace {

/// Tabs in lines without content, or before a comment, are legal; yaml-cpp takes them for indentation. As spaces they
/// leave every place where it is.
std::string without_idle_tabs(std::string text) {
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t content = std::min(text.find_first_not_of(" \t", start), text.size());
        if (content == text.size() || text[content] == '\r' || text[content] == '\n' || text[content] == '#')
            std::fill(text.begin() + static_cast<std::ptrdiff_t>(start),
                      text.begin() + static_cast<std::ptrdiff_t>(content), ' ');
        start = std::min(text.find('\n', content), text.size() - 1) + 1;
    }
    return text;
}

}  // namespace

YamlValue yaml_document(const std::string& given, const YamlFile& file) {
    const std::string text = without_idle_tabs(given);
    YAML::Node document;
    std::optional<YAML::Mark> second;
    try {
        document = YAML::Load(text);
        second = second_document(text);
    } catch (const YAML::Exception& error) {
        throw YamlComplaint{yaml_text_problem(error, text, file.name)};
    }
    if (document.IsNull()) {
        complain({file.name, 1, 1}, "", "the file is empty", "assets/scenes/README.md shows what belongs in it");
    }
    if (second) {
        complain(place_of(*second, file), "", "a second YAML document begins here",
                 "remove the '---' line or the comma; one file holds one document");
    }
    return {document, file, ""};
}

std::string one_of(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
    if (known.empty()) return "nothing can stand here";
    if (const auto nearest = nearest_word(word, known)) return "did you mean '" + std::string(*nearest) + "'?";
    return "known: " + one_of(known);
}

}  // namespace pol
