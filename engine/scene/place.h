// SPDX-License-Identifier: Apache-2.0
// Where things of the scene stand: in the user's files, and in the world.
#pragma once

#include <cstddef>

#include "core/result.h"
#include "core/source_place.h"
#include "core/vec.h"
#include "scene/scene.h"

namespace pol {

/// Where in the user's files `place` is, for messages; all unknown if the thing was made by a program.
inline Place place_in(const Scene& scene, const SourcePlace& place) {
    const auto index = static_cast<std::size_t>(place.file);
    if (place.line <= 0 || place.file < 0 || index >= scene.files.size()) return {};
    return {scene.files[index], place.line, place.column};
}

/// A direction of object space (an axis of a sheet, crystal or lamp) in world space: it turns and is mirrored with the
/// object but is not stretched. Under a transform that does stretch, it keeps its angles to the object's x edge and xy
/// plane.
DVec3 direction_to_world(const DMat4& to_world, const DVec3& direction);

/// Names `place` in the scene's files.
Error at_place(Error error, const Scene& scene, const SourcePlace& place);

/// The same for a key of an object, error.field, or for the whole object.
Error at_object(Error error, const Scene& scene, int object);

}  // namespace pol
