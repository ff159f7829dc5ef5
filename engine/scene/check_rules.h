// SPDX-License-Identifier: Apache-2.0
// What the parts of first_problem() share: not for use outside scene/.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "scene/check.h"
#include "scene/place.h"
#include "scene/scene.h"

namespace pol {

/// Remembers the first broken rule. Every rule is stated positively.
class SceneCheck {
public:
    explicit SceneCheck(const Scene& scene) : scene_(scene) {}

    /// Scene part that the next rules are about.
    void about(const SourcePlace& place) { place_ = place_in(scene_, place); }

    void require(bool holds, std::string field, std::string what, std::string hint) {
        if (holds || problem_) return;
        problem_ = Error{ErrorKind::input, std::move(what), place_, std::move(field), std::move(hint)};
    }

    /// A length of something that exists: positive and believable.
    void require_size(double length, const std::string& field) {
        require(std::isfinite(length) && length > 0.0, field, "must be greater than 0", "write a positive length");
        require(length >= min_length && length <= max_length, field, "is absurdly small or large",
                "lengths from 1e-15 to 1e15 scene units make sense; see 'unit'");
    }

    void require_position(const DVec3& point, const std::string& field) {
        for (int i = 0; i < 3; ++i) {
            require(std::isfinite(point[i]), field, "must be finite", "write three finite numbers");
            require(std::abs(point[i]) <= max_length, field, "is absurdly far away", "stay within 1e15 scene units");
        }
    }

    void require_axis(const DVec3& axis, const std::string& field) {
        require_position(axis, field);
        require(std::sqrt(length2(axis)) >= min_length, field, "has no direction: its length is zero",
                "write a vector such as [0, 0, 1]");
    }

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] bool failed() const { return problem_.has_value(); }
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

private:
    const Scene& scene_;
    Place place_{};
    std::optional<Error> problem_;
};

/// Values are finite and not negative, and `wavelengths_nm` lie inside.
void check_spectrum(SceneCheck& check, const Spectrum& spectrum, const std::vector<double>& wavelengths_nm,
                    const std::string& field);

/// All media: names, constants, axes; those in use also at the wavelengths of the picture.
void check_media(SceneCheck& check);

/// All objects: names, shapes, transforms, roles and what they refer to.
void check_objects(SceneCheck& check);

/// The medium called `name`, or null.
const Medium* find_medium(const Scene& scene, const std::string& name);

/// Requires a medium of that name; the hint suggests the nearest one.
void require_medium(SceneCheck& check, const std::string& name, const std::string& field);

}  // namespace pol
