// SPDX-License-Identifier: Apache-2.0
// The backward tree as a list of rows: filtered, sorted, opened where the user opened it. No ImGui.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plan/plan.h"
#include "tracer/explain.h"

namespace pol {

/// Which leaves are listed: those that fulfil everything that is switched on.
struct PathFilter {
    bool only_e = false;            ///< every crystal it went through as e, and at least one
    bool total_reflection = false;  ///< at least one on the way
    bool bright = false;            ///< brings at least `least_share` of the pixel's S0
    bool not_followed = false;      ///< to its end: no light of it is known
    std::optional<int> body;        ///< went through or met this body of the plan
    double least_share = 0.01;
    [[nodiscard]] bool any() const { return only_e || total_reflection || bright || not_followed || body.has_value(); }
    friend bool operator==(const PathFilter&, const PathFilter&) = default;
};

enum class PathOrder : std::uint8_t {
    weight,  ///< heaviest first
    share,   ///< brightest first
    traced,  ///< as they were found
};

/// Leaves of the filter, and of the whole tree.
struct PathCount {
    std::size_t leaves = 0;
    double s0 = 0.0;      ///< that they bring to the pixel
    double weight = 0.0;  ///< of their ends, absorption included
};

class PathList {
public:
    struct Row {
        int branch = 0;
        int indent = 0;
    };

    /// Starts over with another tree; the plan is the one that it was made of. The root's first steps are open.
    void set_tree(std::shared_ptr<const Plan> plan, std::shared_ptr<const Explanation> explanation);
    [[nodiscard]] const std::shared_ptr<const Explanation>& explanation() const { return explanation_; }

    void set_filter(const PathFilter& filter);
    void set_order(PathOrder order);
    [[nodiscard]] const PathFilter& filter() const { return filter_; }
    [[nodiscard]] PathOrder order() const { return order_; }

    [[nodiscard]] bool is_open(int branch) const { return open_[static_cast<std::size_t>(branch)]; }
    void set_open(int branch, bool open);
    void open_all(bool open);
    /// Opens everything above `branch`, so that it has a row if the filter lets it.
    void reveal(int branch);

    /// Rows to show, from the top. Valid until the next change.
    [[nodiscard]] const std::vector<Row>& rows();
    /// Index of the row of `branch`, if it has one.
    [[nodiscard]] std::optional<std::size_t> row_of(int branch);
    /// True if a listed leaf is below, or it is one itself.
    [[nodiscard]] bool listed(int branch) const { return listed_[static_cast<std::size_t>(branch)]; }
    [[nodiscard]] bool is_total_reflection(int branch) const { return facts_[static_cast<std::size_t>(branch)].total; }

    [[nodiscard]] const PathCount& shown() const { return shown_; }
    [[nodiscard]] const PathCount& all() const { return all_; }

private:
    struct Facts {
        bool total = false;      ///< came from a total reflection
        bool had_e = false;      ///< on the way, itself included
        bool had_o = false;      ///< on the way, itself included
        bool had_total = false;  ///< on the way, itself included
        bool had_body = false;   ///< on the way, itself included: PathFilter::body
    };
    [[nodiscard]] const RayTreeNode& node(int branch) const {
        return explanation_->tree.nodes[static_cast<std::size_t>(branch)];
    }
    [[nodiscard]] bool passes(int leaf) const;
    [[nodiscard]] bool touches(int branch, int body) const;
    [[nodiscard]] std::vector<int> sorted_children(int branch) const;
    void find_facts();
    void apply_filter();

    std::shared_ptr<const Plan> plan_;
    std::shared_ptr<const Explanation> explanation_;
    PathFilter filter_;
    PathOrder order_ = PathOrder::weight;
    std::vector<Facts> facts_;
    std::vector<bool> open_;
    std::vector<bool> listed_;
    std::vector<Row> rows_;
    bool rows_stale_ = true;
    PathCount shown_;
    PathCount all_;
};

}  // namespace pol
