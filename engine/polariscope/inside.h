// SPDX-License-Identifier: Apache-2.0
// What the public headers hide. Not installed; for the sources of this room only.
#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "film/stokes_image.h"
#include "plan/plan.h"
#include "polariscope/explain.h"
#include "polariscope/picture.h"
#include "polariscope/plan.h"
#include "polariscope/result.h"
#include "polariscope/scene.h"
#include "scene/scene.h"
#include "tracer/explain.h"

namespace polariscope::detail {

struct SceneData {
    pol::Scene scene;
    std::filesystem::path file;
    RenderSettings settings;
    std::vector<std::string> objects;
    std::vector<std::string> media;
};

struct PlanData {
    Scene scene;
    std::shared_ptr<const pol::Plan> plan;
};

struct PictureData {
    pol::StokesImage image;
};

struct ExplanationData {
    Plan plan;
    pol::Explanation explanation;
    std::vector<Branch> branches;
};

/// Packs and unpacks the public objects.
struct Inside {
    static Scene pack(SceneData data) { return Scene(std::make_shared<const SceneData>(std::move(data))); }
    static Plan pack(PlanData data) { return Plan(std::make_shared<const PlanData>(std::move(data))); }
    static Picture pack(PictureData data) { return Picture(std::make_shared<const PictureData>(std::move(data))); }
    static Explanation pack(ExplanationData data) {
        return Explanation(std::make_shared<const ExplanationData>(std::move(data)));
    }
    static const SceneData& of(const Scene& scene) { return *scene.data_; }
    static const PlanData& of(const Plan& plan) { return *plan.data_; }
    static const PictureData& of(const Picture& picture) { return *picture.data_; }
};

inline const pol::Plan& inner(const Plan& plan) {
    return *Inside::of(plan).plan;
}
inline const pol::StokesImage& inner(const Picture& picture) {
    return Inside::of(picture).image;
}

inline Stokes outer(const pol::Stokes<double>& light) {
    return {light.s0, light.s1, light.s2, light.s3};
}
inline Vector outer(const pol::DVec3& v) {
    return {v.x, v.y, v.z};
}

Error outer(const pol::Error& error);
Error usage(std::string field, std::string message, std::string hint);
Error stopped();

/// What `work` gives; an exception becomes an Error.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::memory, "there is not enough memory", {}, 0, 0, {}, {}};
    } catch (const std::exception& exception) {
        return Error{ErrorKind::internal, exception.what(), {}, 0, 0, {}, {}};
    } catch (...) {
        return Error{ErrorKind::internal, "an exception of no known kind", {}, 0, 0, {}, {}};
    }
}

}  // namespace polariscope::detail
