// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/pixel_export.h"

#include <cmath>
#include <memory>

#include "io/files/output_file.h"
#include "io/scenes/pixel_case_file.h"
#include "report/explain_report.h"
#include "report/ray_table.h"
#include "viewer/session/exports.h"

namespace pol {

namespace {

std::string text_in(RayFormat format, const Plan& plan, const Explanation& explanation) {
    switch (format) {
        case RayFormat::csv:
            return ray_table_as_csv(plan, explanation);
        case RayFormat::json:
            return explanation_as_json(plan, explanation);
        case RayFormat::obj:
            return paths_as_obj(plan, explanation);
    }
    return {};
}

/// "cube-256,200.csv" where all exports go.
std::filesystem::path path_for_pixel(const Session& session, const std::string& ending) {
    const PixelAddress pixel = session.selection().pinned().value_or(PixelAddress{});
    const std::string scene = std::filesystem::path(session.current()->name()).stem().string();
    return free_export_path(session, scene + "-" + std::to_string(pixel.x) + "," + std::to_string(pixel.y), ending);
}

}  // namespace

void export_rays(Session& session, RayFormat format) {
    const auto explanation = session.explanation();
    if (explanation == nullptr) return;
    constexpr const char* endings[] = {".csv", ".json", ".obj"};
    const auto path = path_for_pixel(session, endings[static_cast<std::size_t>(format)]);
    session.start_export("ray states", path,
                         [plan = session.current()->plan(), explanation, format, path](ExportProgress&) {
                             return write_file(path, text_in(format, *plan, *explanation));
                         });
}

void save_pixel_case(Session& session) {
    const auto explanation = session.explanation();
    if (explanation == nullptr) return;
    const Document& document = *session.current();
    PixelCase pixel_case;
    pixel_case.x = explanation->x;
    pixel_case.y = explanation->y;
    pixel_case.sample = explanation->sample;
    pixel_case.wavelength_nm = document.plan()->wavelengths_nm[static_cast<std::size_t>(explanation->wavelength)];
    pixel_case.expected = to_coherence(explanation->sample_light);
    pixel_case.scene = document.scene();
    const CoherenceMatrix<double>& j = pixel_case.expected;
    if (!std::isfinite(j.xx + j.yy + j.xy.re + j.xy.im)) {
        session.say(Severity::error, "this pixel is not a number: nothing that a test could expect");
        return;
    }
    const auto path = path_for_pixel(session, ".case.yaml");
    std::error_code unknown_folder;
    const auto folder = std::filesystem::absolute(path, unknown_folder).parent_path();
    session.start_export("pixel case", path, [pixel_case = std::move(pixel_case), path, folder](ExportProgress&) {
        return write_file(path, save_pixel_case(pixel_case, folder));
    });
}

}  // namespace pol
