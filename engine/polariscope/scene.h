// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polariscope/result.h"

namespace polariscope {

namespace detail {
struct SceneData;
struct Inside;
}  // namespace detail

enum class SampleMode {
    point,  ///< one ray through the middle of a pixel
    area,   ///< the mean over the pixel, from quasi-random samples
};

/// How a picture of a scene is made; a scene file's `render:`.
struct RenderSettings {
    int width = 512;  ///< pixels
    int height = 512;
    std::vector<double> wavelengths_nm{580.0};  ///< of vacuum, ascending
    SampleMode mode = SampleMode::point;
    int samples_per_pixel = 1;
    /// Largest share of a pixel's light path that may stay untraced, 0 to 1; none: 1e-3, and in mode point as much less
    /// as it takes until the maps are determined.
    std::optional<double> residual;
    std::optional<int> depth;  ///< interfaces after which a branch ends; none: trees are cut by energy alone
    /// Branches of a tree that are followed before one random path stands for the rest; none: 1000, or 12 in mode area
    /// where trees branch (crystals, several solids).
    std::optional<int> node_budget;
    std::uint64_t seed = 0;
    bool unpolarized = false;  ///< forget polarization at every surface, as renderers without it do
};

/// What a scene file says: camera, media, objects, lamps. Immutable; thread-safe.
class Scene {
public:
    Scene(const Scene&) = default;  // and no move: what was moved from would be no scene
    Scene& operator=(const Scene&) = default;
    ~Scene() = default;

    [[nodiscard]] const std::string& title() const;
    /// Names, in the order of the file.
    [[nodiscard]] const std::vector<std::string>& objects() const;
    [[nodiscard]] const std::vector<std::string>& media() const;
    [[nodiscard]] const RenderSettings& settings() const;

    /// The same scene with these settings; compile() says whether they make sense.
    [[nodiscard]] Result<Scene> with(const RenderSettings& settings) const;

    /// YAML that parse_scene() reads back to the same numbers, bit for bit.
    [[nodiscard]] Result<std::string> as_yaml() const;

private:
    friend struct detail::Inside;
    explicit Scene(std::shared_ptr<const detail::SceneData> data) : data_(std::move(data)) {}
    std::shared_ptr<const detail::SceneData> data_;
};

/// A scene file with all that it includes and names. Error (input): there is none, or what is wrong with it, with the
/// place in it.
Result<Scene> load_scene(const std::filesystem::path& file);

/// The same for text in memory. Errors call it `name`; files that it names are looked for in `folder`, then among the
/// assets (assets.h).
Result<Scene> parse_scene(const std::string& yaml, const std::string& name = "scene",
                          const std::filesystem::path& folder = ".");

}  // namespace polariscope
