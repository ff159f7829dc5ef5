// SPDX-License-Identifier: Apache-2.0
#include "scene/check.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "core/overloaded.h"
#include "core/units.h"
#include "scene/check_rules.h"
#include "scene/setting_table.h"
#include "spectrum/illuminant.h"

namespace pol {
namespace {

void check_camera(SceneCheck& check) {
    const Camera& camera = check.scene().camera;
    check.about(camera.place);
    check.require_position(camera.position, "camera.position");
    check.require_position(camera.target, "camera.target");
    check.require_axis(camera.up, "camera.up");
    if (check.failed()) return;
    const DVec3 view = camera.target - camera.position;
    check.require(length2(view) > 0.0, "camera.target", "is the camera's position: there is no direction to look in",
                  "move the target or the camera");
    if (check.failed()) return;
    // 1e-9 leaves seven digits of the cross product that the camera frame is made of.
    check.require(std::sqrt(length2(cross(unit(view), unit(camera.up)))) > 1e-9, "camera.up",
                  "is parallel to the line of sight", "choose another up, for example [0, 1, 0]");
    if (camera.projection == Projection::perspective) {
        check.require(camera.horizontal_fov > 0.0 && camera.horizontal_fov < pi, "camera.fov",
                      "must lie between 0 and 180 degrees", "30 is a good start");
    } else {
        check.require_size(camera.width, "camera.width");
    }
}

void check_render(SceneCheck& check) {
    check.about({});
    for (const RenderSetting& setting : render_settings()) {
        const auto problem = setting_problem(setting, check.scene().render);
        if (problem) check.require(false, "render." + std::string(setting.key), problem->what, problem->hint);
    }
}

void check_surroundings(SceneCheck& check) {
    const Scene& scene = check.scene();
    check.about({});
    check.require(std::isfinite(scene.unit_nm) && scene.unit_nm >= 1e-6 && scene.unit_nm <= 1e18, "unit",
                  "must lie between 1e-6 and 1e18 nm", "write nm, um, mm, cm or m");
    if (!scene.ambient.empty()) {
        require_medium(check, scene.ambient, "ambient");
        const Medium* ambient = find_medium(scene, scene.ambient);
        check.require(ambient == nullptr || is_isotropic(ambient->matter), "ambient",
                      "the camera must stand in an isotropic medium", "use a medium with a single real index");
    }
    check.about(scene.background.place);
    check_spectrum(check, scene.background.radiance, scene.render.wavelengths_nm, "background");
}

}  // namespace

void check_spectrum(SceneCheck& check, const Spectrum& spectrum, const std::vector<double>& wavelengths_nm,
                    const std::string& field) {
    const auto require_value = [&](double value) {
        check.require(std::isfinite(value) && value >= 0.0, field, "must not be negative", "write 0 or more");
        check.require(!(value > 1e100), field, "is absurdly large", "write less than 1e100");
    };
    const auto require_table = [&](const TabulatedSpectrum& table) {
        const std::vector<double>& nodes = table.wavelength_nm;
        check.require(!nodes.empty() && nodes.size() == table.value.size(), field, "the table is empty",
                      "write [[400, 0.2], [700, 0.9]]");
        for (const double nm : nodes) {
            check.require(std::isfinite(nm) && nm > 0.0, field, "a wavelength is not positive",
                          "wavelengths are in nm");
        }
        check.require(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()), field, "wavelengths must ascend",
                      "sort the rows and leave out repeated ones");
        for (const double value : table.value) require_value(value);
    };
    std::visit(Overloaded{[&](const ConstantSpectrum& constant) { require_value(constant.value); },
                          [&](const D65Spectrum& d65) { require_value(d65.scale); }, require_table},
               spectrum);
    if (check.failed()) return;
    for (const double nm : wavelengths_nm) {
        const Result<double> value = evaluate(spectrum, nm);
        if (!value) check.require(false, field, value.error().what, value.error().hint);
    }
}

std::optional<Error> first_problem(const Scene& scene) {
    SceneCheck check(scene);
    check_render(check);
    // Spectra and indices are asked at the picture's wavelengths, which must make sense first.
    if (!check.failed()) {
        check_camera(check);
        check_surroundings(check);
        check_media(check);
        check_objects(check);
    }
    return check.problem();
}

}  // namespace pol
