// SPDX-License-Identifier: Apache-2.0
// One opened file: a scene with the picture that is being made of it, or a picture from an EXR file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "film/film.h"
#include "film/stokes_image.h"
#include "plan/plan.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace pol {

/// Thread safety: main thread only. `wake`, given at opening, is called from workers.
class Document {
public:
    /// Opens a scene (*.yaml, *.yml, *.json) and starts its render, or a Stokes picture (*.exr). Error: as the reader
    /// or the compiler has it.
    static Result<std::unique_ptr<Document>> open(const std::filesystem::path& path, std::function<void()> wake);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] bool has_scene() const { return plan_ != nullptr; }
    /// Requires: has_scene().
    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// What is being rendered. Requires: has_scene().
    [[nodiscard]] const std::shared_ptr<const Plan>& plan() const { return plan_; }

    /// The picture as far as it is known here: brought up to date by update() only, so that one frame sees one picture.
    [[nodiscard]] const StokesImage& picture() const { return picture_; }
    /// Grows whenever the picture changes; a new size or set of wavelengths is a new `picture_layout`.
    [[nodiscard]] std::uint64_t picture_version() const { return version_; }
    [[nodiscard]] std::uint64_t picture_layout() const { return layout_; }
    /// Parts that changed since the last call, for whoever keeps a copy (the textures).
    std::vector<TileRect> take_changes();

    /// Fetches what the workers have finished, for at most `seconds`.
    void update(double seconds);

    [[nodiscard]] RenderProgress progress() const;
    [[nodiscard]] bool paused() const { return paused_; }
    void set_paused(bool paused);

    /// Renders an edited scene instead. Error: the scene cannot be rendered; the old render goes on.
    Result<Done> apply(Scene scene);

private:
    Document() = default;

    std::filesystem::path path_;
    Scene scene_;
    std::shared_ptr<const Plan> plan_;
    std::unique_ptr<Renderer> renderer_;
    StokesImage picture_;
    std::vector<TileRect> changes_;
    std::uint64_t version_ = 0;
    std::uint64_t layout_ = 0;
    std::uint64_t samples_seen_ = 0;
    bool paused_ = false;
};

}  // namespace pol
