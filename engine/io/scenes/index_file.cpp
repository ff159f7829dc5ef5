// SPDX-License-Identifier: Apache-2.0
#include "io/scenes/index_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/nearest_word.h"
#include "core/result.h"
#include "io/files/assets.h"
#include "io/files/input_file.h"
#include "io/files/yaml_value.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_index_file_bytes = 16u << 20u;

/// A word of a scalar, with its place in the file (lines and columns from 1).
struct Word {
    std::string_view text;
    int line = 0;
    int column = 0;
};

class RecordReader {
public:
    RecordReader(std::string file, std::string_view text, std::string name) : file_(std::move(file)), text_(text) {
        index_.name = std::move(name);
    }

    DispersiveIndex read() {
        const YAML::Node root = YAML::Load(std::string(text_));
        if (!root.IsMap()) fail(root.Mark(), "", "this is not an index record", "a record is a map with a DATA list");
        check_keys(root, "");
        const YAML::Node data = root["DATA"];
        if (!data) fail(root.Mark(), "DATA", "missing", "a record needs a DATA list with a formula or a table");
        if (!data.IsSequence() || data.size() == 0) {
            fail(data.Mark(), "DATA", "not a list",
                 "write '- type: formula 2' or '- type: tabulated nk' with its values below");
        }
        for (std::size_t i = 0; i < data.size(); ++i) read_entry(data[i], "DATA[" + std::to_string(i) + "]");
        if (!has_n_) {
            fail(data.Mark(), "DATA",
                 std::string("has no refractive index n: it gives only ") + (index_.k.value.empty() ? "n2" : "k"),
                 "n comes from a formula, 'tabulated n' or 'tabulated nk'");
        }
        return std::move(index_);
    }

private:
    [[noreturn]] void fail_at(int line, int column, std::string field, std::string what, std::string hint) const {
        throw YamlComplaint{
            {ErrorKind::input, std::move(what), {file_, line, column}, std::move(field), std::move(hint)}};
    }
    [[noreturn]] void fail(const YAML::Mark& mark, std::string field, std::string what, std::string hint) const {
        fail_at(mark.line + 1, mark.column + 1, std::move(field), std::move(what), std::move(hint));
    }
    [[noreturn]] void fail(const Word& word, std::string field, std::string what, std::string hint) const {
        fail_at(word.line, word.column, std::move(field), std::move(what), std::move(hint));
    }

    /// Each key once: yaml-cpp takes the first of two without a word.
    void check_keys(const YAML::Node& map, const std::string& prefix) const {
        std::set<std::string> taken;
        for (const auto& pair : map) {
            if (pair.first.IsScalar() && !taken.insert(pair.first.Scalar()).second)
                fail(pair.first.Mark(), prefix + pair.first.Scalar(), "this key occurs twice", "keep one of them");
        }
    }

    void read_entry(const YAML::Node& entry, const std::string& field) {
        if (!entry.IsMap()) fail(entry.Mark(), field, "not a map", "an entry has a type and its values");
        check_keys(entry, field + ".");
        const YAML::Node type = scalar(entry, field, "type");
        const std::string& kind = type.Scalar();
        constexpr std::string_view formula = "formula ";
        if (kind.size() == formula.size() + 1 && kind.starts_with(formula) && kind.back() >= '1' &&
            kind.back() <= '0' + last_formula) {
            add_n(read_formula(entry, field, kind.back() - '0'));
        } else if (kind == "tabulated n") {
            add_n(read_columns(entry, field, 1)[0]);
        } else if (kind == "tabulated k") {
            add_k(read_columns(entry, field, 1)[0]);
        } else if (kind == "tabulated nk") {
            std::vector<IndexTable> columns = read_columns(entry, field, 2);
            add_n(std::move(columns[0]));
            add_k(std::move(columns[1]));
        } else if (kind != "tabulated n2") {  // the nonlinear index is no part of n
            fail(type.Mark(), field + ".type", "unknown type '" + kind.substr(0, 40) + "'",
                 "known are 'formula 1' to 'formula " + std::to_string(last_formula) +
                     "', 'tabulated n', 'tabulated k' and 'tabulated nk'");
        }
    }

    void add_n(IndexBlock n) {
        if (has_n_)
            index_.more_n.push_back(std::move(n));
        else
            index_.n = std::move(n);
        has_n_ = true;
    }
    void add_k(IndexTable k) {
        if (index_.k.value.empty())
            index_.k = std::move(k);
        else
            index_.more_k.push_back(std::move(k));
    }

    YAML::Node scalar(const YAML::Node& entry, const std::string& field, const std::string& key) const {
        const YAML::Node value = entry[key];
        if (!value) fail(entry.Mark(), field + "." + key, "missing", "every entry of this type needs it");
        if (!value.IsScalar())
            fail(value.Mark(), field + "." + key, "not plain text", "write its words on one line or after '|'");
        return value;
    }

    DispersionFormula read_formula(const YAML::Node& entry, const std::string& field, int number) const {
        // Older records call the range `range`.
        const std::string range_key = !entry["wavelength_range"] && entry["range"] ? "range" : "wavelength_range";
        const YAML::Node range_node = scalar(entry, field, range_key);
        const std::string range_field = field + "." + range_key;
        const std::vector<Word> range = words(range_node);
        if (range.size() != 2)
            fail(range_node.Mark(), range_field, "not two numbers", "write shortest and longest wavelength in um");
        const double min_nm = wavelength_nm(range[0], range_field);
        const double max_nm = wavelength_nm(range[1], range_field);
        if (min_nm >= max_nm) fail(range[1], range_field, "the range is empty", "write the shorter wavelength first");

        const YAML::Node list = scalar(entry, field, "coefficients");
        const std::string list_field = field + ".coefficients";
        DispersionFormula formula{number, {}, min_nm, max_nm};
        for (const Word& word : words(list)) formula.coefficients.push_back(number_of(word, list_field));
        const std::size_t count = formula.coefficients.size();
        if (const std::string form = coefficient_problem(number, count); !form.empty()) {
            fail(list.Mark(), list_field, std::to_string(count) + " coefficients",
                 "formula " + std::to_string(number) + " has " + form);
        }
        return formula;
    }

    /// `count` tables that share the first column of the data, wavelength in um.
    std::vector<IndexTable> read_columns(const YAML::Node& entry, const std::string& field, std::size_t count) const {
        const YAML::Node data = scalar(entry, field, "data");
        const std::string data_field = field + ".data";
        std::vector<std::vector<std::pair<double, double>>> columns(count);
        const std::vector<Word> all = words(data);
        for (std::size_t i = 0; i < all.size();) {
            const Word& first = all[i];
            std::size_t end = i;
            while (end < all.size() && all[end].line == first.line) ++end;
            if (end - i != count + 1) {
                fail(first, data_field, "this row has " + std::to_string(end - i) + " numbers",
                     "a row has a wavelength in um and " + std::string(count == 1 ? "one value" : "n and k"));
            }
            const double nm = wavelength_nm(first, data_field);
            for (std::size_t c = 0; c < count; ++c) columns[c].emplace_back(nm, number_of(all[i + 1 + c], data_field));
            i = end;
        }
        if (columns[0].empty()) fail(data.Mark(), data_field, "no rows", "a row has a wavelength in um and its values");
        std::vector<IndexTable> tables;
        for (auto& rows : columns) tables.push_back(index_table(std::move(rows)));
        return tables;
    }

    /// Words of a scalar, found again in the file from where the scalar begins: yaml-cpp keeps no places inside it.
    [[nodiscard]] std::vector<Word> words(const YAML::Node& node) const {
        const std::string& value = node.Scalar();
        std::vector<Word> result;
        std::size_t at = static_cast<std::size_t>(std::max(node.Mark().pos, 0));
        std::size_t line_start = at - static_cast<std::size_t>(std::max(node.Mark().column, 0));
        int line = node.Mark().line + 1;
        // What stands behind the | of a block is a comment.
        if (at < text_.size() && (text_[at] == '|' || text_[at] == '>'))
            at = std::min(text_.find('\n', at), text_.size());
        constexpr std::string_view blank = " \t\r\n";
        for (std::size_t begin = value.find_first_not_of(blank); begin != std::string::npos;) {
            const std::size_t end = std::min(value.find_first_of(blank, begin), value.size());
            const std::string_view word = std::string_view(value).substr(begin, end - begin);
            const std::size_t found = text_.find(word, at);
            if (found != std::string_view::npos) {
                for (; at < found; ++at) {
                    if (text_[at] != '\n') continue;
                    ++line;
                    line_start = at + 1;
                }
                result.push_back({text_.substr(found, word.size()), line, static_cast<int>(found - line_start) + 1});
                at = found + word.size();
            } else {
                fail(node.Mark(), "", "a quoted number with escapes", "write numbers plainly");
            }
            begin = value.find_first_not_of(blank, end);
        }
        return result;
    }

    double number_of(const Word& word, const std::string& field) const {
        const std::optional<double> value = parse(word.text);
        if (!value || !std::isfinite(*value)) {
            fail(word, field, "not a finite number: " + std::string(word.text.substr(0, 40)),
                 "write a decimal number such as 1.52");
        }
        return *value;
    }

    /// Micrometres in the file, nanometres here; the exponent is raised by 3 so that nothing is rounded twice.
    double wavelength_nm(const Word& word, const std::string& field) const {
        number_of(word, field);
        const std::size_t e = word.text.find_first_of("eE");
        int exponent = 0;
        if (e != std::string_view::npos) {
            const std::size_t digits = word.text[e + 1] == '+' ? e + 2 : e + 1;
            std::from_chars(word.text.data() + digits, word.text.data() + word.text.size(), exponent);
        }
        const std::optional<double> nm =
            parse(std::string(word.text.substr(0, e)) + "e" + std::to_string(exponent + 3));
        if (!nm || !std::isfinite(*nm) || *nm <= 0.0) {
            fail(word, field, "not a wavelength: " + std::string(word.text.substr(0, 40)),
                 "wavelengths are positive, in um");
        }
        return *nm;
    }

    static std::optional<double> parse(std::string_view text) {
        if (text.starts_with('+')) text.remove_prefix(1);
        double value = 0.0;
        const std::from_chars_result parsed = std::from_chars(text.data(), text.data() + text.size(), value);
        if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) return std::nullopt;
        return value;
    }

    std::string file_;
    std::string_view text_;
    DispersiveIndex index_;
    bool has_n_ = false;
};

constexpr std::array<const char*, 2> uniaxial{"-o", "-e"};
constexpr std::array<const char*, 3> biaxial{"-alpha", "-beta", "-gamma"};

bool is_path(const std::string& name) {
    return name.find('/') != std::string::npos || is_one_record(name);
}

/// The suffixes for which NAME + suffix + ".yml" is there: "ktp-alpha, ktp-beta, ktp-gamma". Empty: none is.
std::string records_of(const std::string& name, const fs::path& folder, std::span<const char* const> suffixes) {
    std::string found;
    for (const char* suffix : suffixes) {
        std::error_code failed;
        const fs::path path = (is_path(name) ? fs::path(name) : folder / name).string() + suffix + ".yml";
        if (fs::exists(path, failed))
            found += (found.empty() ? "" : ", ") + fs::path(name).filename().string() + suffix;
    }
    return found;
}

Error input_error(std::string what, std::string hint) {
    return {ErrorKind::input, std::move(what), {}, {}, std::move(hint)};
}

/// `suffix` is what the names that can be meant end in; it is left out of the hint.
Error unknown_record(const std::string& name, const fs::path& folder, const std::string& suffix) {
    std::vector<std::string> names;
    std::error_code failed;
    if (!fs::is_directory(folder, failed)) return missing_assets();
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        const std::string stem = it->path().stem().string();
        if (it->path().extension() == ".yml" && stem.ends_with(suffix))
            names.push_back(stem.substr(0, stem.size() - suffix.size()));
    }
    std::sort(names.begin(), names.end());
    std::string hint = suffix.empty() ? "give the path of a refractiveindex.info file, or one of: "
                                      : "give the path of a pair of refractiveindex.info files (./" +
                                            name.substr(0, 80) + "), or one of: ";
    if (const auto nearest = nearest_word(name, std::vector<std::string_view>(names.begin(), names.end()))) {
        hint = "did you mean '";
        hint += *nearest;
        hint += "'?";
    } else {
        for (std::size_t i = 0; i < names.size(); ++i) hint += (i == 0 ? "" : ", ") + names[i];
    }
    return input_error(
        "there is no " + std::string(suffix.empty() ? "index record" : "crystal") + " '" + name.substr(0, 80) + "'",
        std::move(hint));
}

}  // namespace

bool is_one_record(const std::string& name) {
    return name.ends_with(".yml") || name.ends_with(".yaml");
}

bool is_crystal(const std::string& name, const fs::path& assets_dir) {
    const fs::path folder = assets_dir / "refractive_index";
    return !records_of(name, folder, uniaxial).empty() || !records_of(name, folder, biaxial).empty();
}

Result<CrystalIndices> load_crystal(const std::string& name, const fs::path& assets_dir) {
    const fs::path folder = assets_dir / "refractive_index";
    if (is_one_record(name)) {
        return input_error("'" + name + "' is one file, and a crystal has two indices",
                           "NAME stands for the files NAME-o.yml and NAME-e.yml: write the path without its end, or "
                           "'ordinary:' and 'extraordinary:'");
    }
    if (records_of(name, folder, uniaxial).empty()) {
        if (const std::string found = records_of(name, folder, biaxial); !found.empty()) {
            return input_error("'" + name + "' is biaxial (it has " + found + "); biaxial crystals are not supported",
                               "uniaxial crystals have two records, NAME-o and NAME-e");
        }
        if (!is_path(name)) return unknown_record(name, folder, uniaxial[0]);
    }
    const std::string suffix = is_path(name) ? ".yml" : "";
    POL_TRY(auto ordinary, load_index(name + uniaxial[0] + suffix, assets_dir));
    POL_TRY(auto extraordinary, load_index(name + uniaxial[1] + suffix, assets_dir));
    return CrystalIndices{std::move(ordinary), std::move(extraordinary)};
}

Result<RefractiveIndex> load_index(const std::string& name_or_path, const fs::path& assets_dir) {
    const fs::path folder = assets_dir / "refractive_index";
    const fs::path path = is_path(name_or_path) ? fs::path(name_or_path) : folder / (name_or_path + ".yml");
    std::error_code failed;
    if (!fs::exists(path, failed)) {
        const std::string pair = records_of(name_or_path, folder, uniaxial);
        const std::string three = records_of(name_or_path, folder, biaxial);
        if (!pair.empty() || !three.empty()) {
            return input_error("'" + name_or_path + "' is a crystal, not one index (it has " + pair + three + ")",
                               pair.empty() ? "biaxial crystals are not supported; each of these is an index"
                                            : "write {crystal: " + name_or_path + "}");
        }
        if (!is_path(name_or_path)) return unknown_record(name_or_path, folder, "");
    }

    POL_TRY(const auto text, read_input_file(path, max_index_file_bytes));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
        return Error{ErrorKind::input,
                     "is empty",
                     {path.string(), 0, 0},
                     {},
                     "a record has a DATA list with a formula or a table"};
    }
    try {
        return RefractiveIndex{RecordReader(path.string(), text, name_or_path).read()};
    } catch (const YamlComplaint& complaint) {
        return complaint.error;
    } catch (const YAML::Exception& e) {
        return yaml_text_problem(e, text, path.string());
    }
}

}  // namespace pol
