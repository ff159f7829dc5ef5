// SPDX-License-Identifier: Apache-2.0
#include "polariscope/scene.h"

#include "io/scenes/scene_file.h"
#include "polariscope/inside.h"

namespace polariscope {

using detail::guarded;
using detail::Inside;

namespace {

RenderSettings outer_settings(const pol::RenderSettings& s) {
    RenderSettings settings;
    settings.width = s.width;
    settings.height = s.height;
    settings.wavelengths_nm = s.wavelengths_nm;
    settings.mode = s.mode == pol::SampleMode::area ? SampleMode::area : SampleMode::point;
    settings.samples_per_pixel = s.samples_per_pixel;
    settings.residual = s.residual;
    settings.depth = s.depth;
    settings.node_budget = s.node_budget;
    settings.seed = s.seed;
    settings.unpolarized = s.unpolarized;
    return settings;
}

pol::RenderSettings inner_settings(const RenderSettings& s) {
    pol::RenderSettings settings;
    settings.width = s.width;
    settings.height = s.height;
    settings.wavelengths_nm = s.wavelengths_nm;
    settings.mode = s.mode == SampleMode::area ? pol::SampleMode::area : pol::SampleMode::point;
    settings.samples_per_pixel = s.samples_per_pixel;
    settings.residual = s.residual;
    settings.depth = s.depth;
    settings.node_budget = s.node_budget;
    settings.seed = s.seed;
    settings.unpolarized = s.unpolarized;
    return settings;
}

Scene packed(pol::Scene scene, const std::filesystem::path& file) {
    detail::SceneData data;
    data.settings = outer_settings(scene.render);
    for (const pol::Object& object : scene.objects) data.objects.push_back(object.name);
    for (const pol::Medium& medium : scene.media) data.media.push_back(medium.name);
    data.scene = std::move(scene);
    data.file = file;
    return Inside::pack(std::move(data));
}

}  // namespace

const std::string& Scene::title() const {
    return data_->scene.title;
}

const std::vector<std::string>& Scene::objects() const {
    return data_->objects;
}

const std::vector<std::string>& Scene::media() const {
    return data_->media;
}

const RenderSettings& Scene::settings() const {
    return data_->settings;
}

Result<Scene> Scene::with(const RenderSettings& settings) const {
    return guarded([&]() -> Result<Scene> {
        pol::Scene scene = data_->scene;
        scene.render = inner_settings(settings);
        return packed(std::move(scene), data_->file);
    });
}

Result<std::string> Scene::as_yaml() const {
    return guarded([&]() -> Result<std::string> { return pol::save_scene(data_->scene); });
}

Result<Scene> load_scene(const std::filesystem::path& file) {
    return guarded([&]() -> Result<Scene> {
        auto scene = pol::load_scene(file);
        if (!scene) return detail::outer(scene.error());
        return packed(std::move(scene).value(), file);
    });
}

Result<Scene> parse_scene(const std::string& yaml, const std::string& name, const std::filesystem::path& folder) {
    return guarded([&]() -> Result<Scene> {
        auto scene = pol::parse_scene(yaml, name, folder);
        if (!scene) return detail::outer(scene.error());
        return packed(std::move(scene).value(), name);
    });
}

}  // namespace polariscope
