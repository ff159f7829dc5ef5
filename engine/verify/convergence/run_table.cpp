// SPDX-License-Identifier: Apache-2.0
#include "verify/convergence/run_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

#include "core/number_text.h"

namespace pol::verify {

namespace {

struct Column {
    std::string name;
    std::function<std::string(const RunRow&)> write;
    std::function<bool(RunRow&, std::string_view)> read;
};

std::string field_of(double value) {
    return std::isnan(value) ? "" : number_text(value);
}

bool parse_field(std::string_view text, double& value) {
    value = not_measured;
    if (text.empty()) return true;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc() && end == text.data() + text.size();
}

Column text_column(std::string name, std::string RunRow::*member) {
    return {std::move(name),
            [member](const RunRow& row) {
                // Quoted, quotes doubled (RFC 4180); line breaks have no place in a name.
                std::string out = "\"";
                for (const char c : row.*member) {
                    if (c == '"') out += '"';
                    out += c == '\n' || c == '\r' ? ' ' : c;
                }
                return out + "\"";
            },
            [member](RunRow& row, std::string_view text) {
                row.*member = std::string(text);
                return true;
            }};
}

Column number_column(std::string name, double RunRow::*member) {
    return {std::move(name), [member](const RunRow& row) { return field_of(row.*member); },
            [member](RunRow& row, std::string_view text) { return parse_field(text, row.*member); }};
}

Column metric_column(std::string name, std::size_t index, double Metric::*member) {
    return {std::move(name), [=](const RunRow& row) { return field_of(row.errors[index].*member); },
            [=](RunRow& row, std::string_view text) { return parse_field(text, row.errors[index].*member); }};
}

const std::vector<Column>& columns() {
    static const std::vector<Column> table = [] {
        std::vector<Column> made{
            text_column("series", &RunRow::series),
            text_column("scene", &RunRow::scene),
            text_column("scene_hash", &RunRow::scene_hash),
            text_column("mode", &RunRow::mode),
            text_column("kernel_features", &RunRow::kernel),
            text_column("tool_version", &RunRow::tool_version),
            text_column("cpu", &RunRow::cpu),
            text_column("lambda_nm", &RunRow::wavelengths_nm),
            text_column("ref_id", &RunRow::reference),
            text_column("timestamp", &RunRow::timestamp),
            number_column("cores", &RunRow::cores),
            number_column("threads", &RunRow::threads),
            number_column("width", &RunRow::width),
            number_column("height", &RunRow::height),
            number_column("residual_target", &RunRow::residual_target),
            number_column("depth_limit", &RunRow::depth_limit),
            number_column("node_budget", &RunRow::node_budget),
            number_column("spp", &RunRow::samples_per_pixel),
            number_column("n_lambda", &RunRow::wavelengths),
            number_column("seed", &RunRow::seed),
            number_column("repeat", &RunRow::repeats),
            number_column("t_load_s", &RunRow::load_s),
            number_column("t_compile_s", &RunRow::compile_s),
            number_column("t_render_wall_s", &RunRow::render_wall_s),
            number_column("t_render_cpu_s", &RunRow::render_cpu_s),
            number_column("rays", &RunRow::rays),
            number_column("nodes_mean", &RunRow::nodes_mean),
            number_column("nodes_max", &RunRow::nodes_max),
            number_column("ref_error", &RunRow::reference_error),
        };
        for (std::size_t i = 0; i < named_metrics.size(); ++i) {
            const std::string name(named_metrics[i].name);
            made.push_back(metric_column(name, i, &Metric::whole));
            made.push_back(metric_column(name + "_p99", i, &Metric::p99));
            made.push_back(metric_column(name + "_max", i, &Metric::largest));
        }
        for (Column& column : std::vector<Column>{
                 number_column("truncation", &RunRow::truncation),
                 number_column("e_aa_est", &RunRow::sampling),
                 number_column("bound_fro", &RunRow::bound_fro),
                 number_column("bound_mean", &RunRow::bound_mean),
                 number_column("bound_max", &RunRow::bound_max),
                 number_column("bound_cover", &RunRow::bound_cover),
                 number_column("bound_ratio", &RunRow::bound_ratio),
                 number_column("e_sp_est", &RunRow::spectral),
                 number_column("e_fp_est", &RunRow::floating_point),
                 number_column("topology_changes", &RunRow::topology_changes),
                 number_column("energy_defect_max", &RunRow::energy_defect),
                 number_column("psd_violations", &RunRow::psd_violations),
                 number_column("s0_over_lmax", &RunRow::s0_over_max),
                 number_column("nan_count", &RunRow::nan_count),
                 number_column("failures", &RunRow::failures),
                 number_column("host_load", &RunRow::host_load),
             })
            made.push_back(std::move(column));
        return made;
    }();
    return table;
}

std::string header() {
    std::string out;
    for (const Column& column : columns()) out += (out.empty() ? "" : ",") + column.name;
    return out + "\n";
}

/// Fields of one line; text fields lose their quotes.
std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += '"';
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

}  // namespace

std::string run_table_csv(const std::vector<RunRow>& rows) {
    std::string out = header();
    for (const RunRow& row : rows) {
        bool first = true;
        for (const Column& column : columns()) {
            if (!first) out += ',';
            first = false;
            out += column.write(row);
        }
        out += '\n';
    }
    return out;
}

Result<std::vector<RunRow>> parse_run_table(const std::string& text, const std::string& file_name) {
    const auto complaint = [&](int line, std::string field, std::string what) {
        return Error{ErrorKind::input,
                     std::move(what),
                     {file_name, line, 0},
                     std::move(field),
                     "the file is not of this version: choose another folder, or remove it"};
    };
    std::vector<RunRow> rows;
    std::size_t begin = text.starts_with("\ufeff") ? 3 : 0;  // a byte order mark, as spreadsheets write it
    for (int line = 1; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view content(text.data() + begin, end - begin);
        begin = end + 1;
        if (line == 1) {
            if (std::string(content) + "\n" != header())
                return complaint(1, {}, "the columns are not those of runs.csv");
            continue;
        }
        const std::vector<std::string> fields = split(content);
        if (fields.size() != columns().size())
            return complaint(line, {},
                             std::to_string(fields.size()) + " fields instead of " + std::to_string(columns().size()));
        RunRow row;
        for (std::size_t i = 0; i < fields.size(); ++i)
            if (!columns()[i].read(row, fields[i]))
                return complaint(line, columns()[i].name, "'" + fields[i] + "' is no number");
        rows.push_back(std::move(row));
    }
    if (text.empty()) return complaint(1, {}, "the file is empty");
    return rows;
}

}  // namespace pol::verify
