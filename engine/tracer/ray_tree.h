// SPDX-License-Identifier: Apache-2.0
// A backward tree written down: every branch with what it met, what it weighs and the light that came along it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/index_range.h"
#include "polarization/coherence_matrix.h"
#include "tracer/crossing.h"
#include "tracer/node.h"
#include "tracer/observers.h"

namespace pol {

/// One branch. `ray` and `k` are those of the backward ray; the light travels the other way. Field vectors and matrices
/// are in the frame of the light (in_frame_of_light), and light is given at the one wavelength that the tree was
/// recorded for.
struct RayTreeNode {
    int parent = -1;
    Interaction interaction = Interaction::camera;
    Node start;           ///< as it left its origin
    Node end;             ///< as it arrived: origin is the point, absorption along the way is in the throughput
    Crossing crossing{};  ///< what it met; body -1: nothing
    bool arrived = false;
    bool estimated = false;            ///< on the random tail: rescaled to stand for all that was open
    double angle = 0.0;                ///< of incidence of the ray where it arrived, radians
    std::optional<LeafReason> reason;  ///< why it ended; none: it branched
    Stokes<double> light{};            ///< its share of the pixel; zero unless brings_light()
    /// Coherence matrix of the light that arrives at the start of this branch, in the frame of the light; basic
    /// radiance times n_camera^2. That of a single mode has xx only: linear along field[0]. None on the random tail.
    std::optional<CoherenceMatrix<double>> arriving;
    Stokes<double> share{};  ///< what this branch and all that grew from it bring to the pixel
    IndexRange children;     ///< indices into RayTree::nodes: siblings are born in a row

    /// True for a leaf that ended on a source of light.
    [[nodiscard]] bool brings_light() const {
        return reason == LeafReason::emitter || reason == LeafReason::background;
    }
};

struct RayTree {
    std::vector<RayTreeNode> nodes;  ///< in order of creation: parents before children
    std::vector<int> leaves;         ///< in the order in which they ended: their light adds up to the sample
};

/// The branch with other signs, so that x = field[0], y = field[1] and k = -ray are right-handed about its light
/// (CONVENTIONS.md 2, 7): s, p and k of the light at the interface that it comes to at the start of the branch; the
/// camera's axes before the first interface. The kernel's s and p are right-handed about the backward ray. A single
/// mode gets a y axis as well; it has no field along it.
Node in_frame_of_light(Node node);

/// Observer that writes the tree down (tracer/observers.h), with the light of one wavelength of the group.
class TreeRecorder {
public:
    /// `place` of the wavelength in its group.
    TreeRecorder(std::size_t place, const KeepGoing& keep_going) : place_(place), keep_going_(keep_going) {}

    RayTree tree;

    [[nodiscard]] bool cancelled() const { return !keep_going_(tree.nodes.size()); }
    void opened(const Node& node, int parent, Interaction interaction);
    void reached(const Node& node, const Crossing& crossing);
    void ended(const Node& node, LeafReason reason, std::span<const Stokes<double>> light);
    void tail_begins(const Node& node);

private:
    [[nodiscard]] RayTreeNode& at(int id) { return tree.nodes[static_cast<std::size_t>(id)]; }
    std::size_t place_;
    const KeepGoing& keep_going_;
    bool in_tail_ = false;
};

}  // namespace pol
