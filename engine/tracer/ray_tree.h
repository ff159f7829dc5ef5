// SPDX-License-Identifier: Apache-2.0
// A backward tree written down: every branch with what it met, what it weighs and the light that came along it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "polarization/coherence_matrix.h"
#include "tracer/crossing.h"
#include "tracer/node.h"

namespace pol {

/// One branch. Directions are those of the backward ray; the light travels the other way.
struct RayTreeNode {
    int parent = -1;
    Interaction interaction = Interaction::camera;
    Node start;           ///< as it left its origin
    Node end;             ///< as it arrived: origin is the point, absorption along the way is in the throughput
    Crossing crossing{};  ///< what it met; body -1: nothing
    bool arrived = false;
    bool estimated = false;             ///< on the random tail: rescaled to stand for all that was open
    double angle = 0.0;                 ///< of incidence of the ray where it arrived, radians
    std::optional<LeafReason> reason;   ///< why it ended; none: it branched
    std::vector<Stokes<double>> light;  ///< its share of the pixel per wavelength of the group, leaves only
    /// Coherence matrix of the light that arrives at the start of this branch, in start.wave.field (a single mode uses
    /// xx only), basic radiance times n_camera^2, per wavelength of the group. Empty on the random tail.
    std::vector<CoherenceMatrix<double>> arriving;
    std::vector<Stokes<double>>
        share;  ///< what this branch and all that grew from it bring to the pixel, per wavelength
    std::vector<int> children;
};

struct RayTree {
    std::vector<RayTreeNode> nodes;  ///< in order of creation: parents before children
    std::vector<int> leaves;         ///< in the order in which they ended: their light adds up to the sample
};

/// Observer that writes the tree down (tracer/observers.h).
class TreeRecorder {
public:
    RayTree tree;

    [[nodiscard]] bool cancelled() const { return false; }
    void opened(const Node& node, int parent, Interaction interaction);
    void reached(const Node& node, const Crossing& crossing);
    void ended(const Node& node, LeafReason reason, std::span<const Stokes<double>> light);
    void tail_begins(const Node& node);

private:
    [[nodiscard]] RayTreeNode& at(int id) { return tree.nodes[static_cast<std::size_t>(id)]; }
    bool in_tail_ = false;
};

}  // namespace pol
