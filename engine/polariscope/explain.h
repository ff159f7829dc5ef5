// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "polariscope/light.h"
#include "polariscope/plan.h"
#include "polariscope/result.h"

namespace polariscope {

namespace detail {
struct ExplanationData;
}

/// A piece of the tree: a ray against the light from one interface to the next.
struct Branch {
    int parent = -1;             ///< index of the branch it came from; -1: the camera ray
    std::string interaction;     ///< how it came to be: "camera", "reflected", "totally reflected", "transmitted",
                                 ///< "through sheet"
    std::string mode;            ///< "s/p", or "o" or "e" in a crystal
    std::string medium;          ///< that it goes through
    Vector from{};               ///< scene units
    Vector to{};                 ///< where it arrived; meaningless if `body` is empty
    Vector direction{};          ///< unit, of the ray; the light travels the other way
    Vector k{};                  ///< wave vector of the ray over omega/c: |k| is the refractive index it sees
    std::string body;            ///< that it met; empty: none
    double weight = 0.0;         ///< share of the pixel's light path where it begins
    double weight_at_end = 0.0;  ///< less by what was absorbed along it
    std::string end;  ///< why it ended ("emitter", "background", "absorbed", "residual" ...); empty: it branched
    Stokes light{};   ///< what it brings to the pixel by itself, in the frame of the pixel
    Stokes share{};   ///< what it and all that grew from it bring
};

/// How a sample of a pixel came to be. Immutable; thread-safe.
class Explanation {
public:
    Explanation(const Explanation&) = default;
    Explanation& operator=(const Explanation&) = default;
    ~Explanation() = default;

    /// Of the sample, in the frame of the pixel (Stokes).
    [[nodiscard]] Stokes stokes() const;
    [[nodiscard]] Coherence coherence() const;
    /// True if the leaves of the tree add up to the light of the sample to the last bit.
    [[nodiscard]] bool exact() const;
    /// Parents before children.
    [[nodiscard]] const std::vector<Branch>& branches() const;
    /// For a person, with the branches of at least that weight; for a program, with all (what `polariscope explain`
    /// prints).
    [[nodiscard]] Result<std::string> as_text(double least_weight = 0.01) const;
    [[nodiscard]] Result<std::string> as_json() const;

private:
    friend struct detail::Inside;
    explicit Explanation(std::shared_ptr<const detail::ExplanationData> data) : data_(std::move(data)) {}
    std::shared_ptr<const detail::ExplanationData> data_;
};

/// The tree of one sample of pixel (x, y), row 0 at the top, at the wavelength with that index in the plan's settings.
/// Sample 0 is the ray through the middle of the pixel; mode point has no other, a picture in mode area is made of the
/// samples from 1 on. Error (usage): there is no such pixel or wavelength; (stopped): `stop` was requested.
Result<Explanation> explain(const Plan& plan, int x, int y, int wavelength = 0, std::uint32_t sample = 0,
                            const std::stop_token& stop = {});

}  // namespace polariscope
