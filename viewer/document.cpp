// SPDX-License-Identifier: Apache-2.0
#include "viewer/document.h"

#include <algorithm>

#include "io/exr_file.h"
#include "io/scene_file.h"
#include "plan/compile.h"

namespace pol {

Result<std::unique_ptr<Document>> Document::open(const std::filesystem::path& path, std::function<void()> wake) {
    std::unique_ptr<Document> document(new Document);
    document->path_ = path;
    if (path.extension() == ".exr") {
        auto picture = read_exr(path);
        if (!picture) return picture.error();
        document->picture_ = std::move(picture).value();
        document->changes_ = {{0, 0, document->picture_.width, document->picture_.height}};
        document->version_ = document->layout_ = 1;
        return document;
    }
    auto scene = load_scene(path);
    if (!scene) return scene.error();
    document->renderer_ = std::make_unique<Renderer>(hardware_threads(), 32, std::move(wake));
    const auto applied = document->apply(std::move(scene).value());
    if (!applied) return applied.error();
    return document;
}

Document::~Document() = default;

std::vector<TileRect> Document::take_changes() {
    return std::exchange(changes_, {});
}

void Document::update(double /*seconds*/) {
    if (!renderer_) return;
    const std::uint64_t samples = renderer_->progress().statistics.samples;
    if (samples == samples_seen_) return;
    samples_seen_ = samples;
    picture_ = renderer_->snapshot();
    changes_ = {{0, 0, picture_.width, picture_.height}};
    ++version_;
}

RenderProgress Document::progress() const {
    return renderer_ ? renderer_->progress() : RenderProgress{1.0, true, {}};
}

void Document::set_paused(bool paused) {
    if (!renderer_) return;
    paused_ = paused;
    paused ? renderer_->pause() : renderer_->resume();
}

Result<Done> Document::apply(Scene scene) {
    auto plan = compile(scene);
    if (!plan) return plan.error();
    scene_ = std::move(scene);
    plan_ = std::move(plan).value();
    renderer_->start(plan_);
    picture_ = renderer_->snapshot();
    changes_ = {{0, 0, picture_.width, picture_.height}};
    samples_seen_ = 0;
    paused_ = false;
    ++version_;
    ++layout_;
    return Done{};
}

}  // namespace pol
