// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A vertex is left out if GJK finds a point near enough to it in the hull of the listed vertices.
// That point is a combination of vertices, whatever GJK does, so the vertex is within that distance
// of the hull. Otherwise the vertex that is farthest in the direction where GJK ended is listed. A
// node lists only vertices that a child of it lists, so the distances of all levels add up:
// kHullPad is twice the max of their sum, which covers rounding.
#include "geometry/distance/hull_vertices.h"

#include <algorithm>

#include "geometry/distance/gjk.h"

namespace link_bounds {
namespace {

constexpr double kAllowed = kHullPad / 2;

constexpr int kHullSteps = 30;

/// Cost of comparing a vertex with one listed vertex, see WorkMeter.
constexpr std::size_t kLooksPerPair = 4;

/// `at` gives the point of an index below `count`.
template <class At>
std::size_t farthestIndex(std::size_t count, const Eigen::Vector3d& direction, const At& at) {
  std::size_t best = 0;
  double best_dot = at(0).dot(direction);
  for (std::size_t i = 1; i < count; ++i) {
    const double dot = at(i).dot(direction);
    if (!(dot > best_dot)) continue;
    best_dot = dot;
    best = i;
  }
  return best;
}

struct Point {
  const Eigen::Vector3d& point;

  const Eigen::Vector3d& farthest(const Eigen::Vector3d&) const { return point; }
};

struct PointHull {
  const std::vector<Eigen::Vector3d>& points;

  const Eigen::Vector3d& farthest(const Eigen::Vector3d& direction) const {
    return points[farthestIndex(
        points.size(), direction,
        [&](std::size_t i) -> const Eigen::Vector3d& { return points[i]; })];
  }
};

class HullLists {
 public:
  HullLists(TriangleTree& tree, WorkMeter& meter)
      : tree_(tree), meter_(meter), allowed_(tree.nodes.size(), kAllowed * tree.magnitude) {
    tree.hull_lists = {0};
    const std::size_t most = kListedBytes / sizeof(Offset) * tree.triangles.size();
    // Children come after their parent.
    for (std::size_t i = tree.nodes.size(); i-- > 0 && tree.hull_lists.size() < most;) {
      TreeNode& node = tree.nodes[i];
      if (node.isLeaf() || node.count > kSmallNode) continue;
      begin(node);
      allowed_[i] = std::min(allowed_[node.child], allowed_[node.child + 1]);
      if (node.count > kProvenNode) allowed_[i] -= choose(allowed_[i]);
      store(node);
    }
    tree.hull_lists.shrink_to_fit();
  }

 private:
  using Offset = TriangleTree::Offset;

  void begin(const TreeNode& node) {
    vertices_ = &tree_.vertices[node.first_vertex];
    offsets_.clear();
    for (const std::uint32_t child : {node.child, node.child + 1})
      tree_.forEachHullVertex(tree_.nodes[child],
                              [&](Offset offset) { offsets_.push_back(offset); });
    std::sort(offsets_.begin(), offsets_.end());
    offsets_.erase(std::unique(offsets_.begin(), offsets_.end()), offsets_.end());
    listed_.clear();
  }

  /// Lists the vertices that the hull needs and removes the other offsets. Returns the max distance
  /// of a removed vertex from the hull [m].
  double choose(double allowed) {
    double farthest_out = 0;
    for (int i = 0; i < 27; ++i) {
      const std::size_t found = farthest({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
      if (found >= listed_.size()) list(found);
    }
    while (listed_.size() < offsets_.size()) {
      const std::size_t next = listed_.size();
      meter_.add(kLooksPerPair * listed_.size());
      const GjkResult result = toHull(vertices_[offsets_[next]], allowed);
      if (result.upper <= allowed) {
        farthest_out = std::max(farthest_out, result.upper);
        offsets_[next] = offsets_.back();
        offsets_.pop_back();
      } else {
        // If only rounding separates them, farthest() may find a listed vertex; then `next` is
        // listed.
        list(result.lower > 0 ? std::max(next, farthest(-result.normal)) : next);
      }
    }
    return farthest_out;
  }

  GjkResult toHull(const Eigen::Vector3d& point, double allowed) const {
    static const Placement kHere{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
    const Placement from_point{Eigen::Matrix3d::Identity(), -point};
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const GjkGoal goal{2 * allowed, allowed, 0, kHullSteps};
    Simplex simplex;
    return gjk(Point{zero}, kHere, PointHull{listed_}, from_point,
               (listed_[0] - point).stableNormalized(), goal, simplex);
  }

  std::size_t farthest(const Eigen::Vector3d& direction) const {
    return farthestIndex(offsets_.size(), direction, [&](std::size_t i) -> const Eigen::Vector3d& {
      return vertices_[offsets_[i]];
    });
  }

  void list(std::size_t index) {
    std::swap(offsets_[index], offsets_[listed_.size()]);
    listed_.push_back(vertices_[offsets_[listed_.size()]]);
  }

  void store(TreeNode& node) {
    node.hull_list = static_cast<std::uint32_t>(tree_.hull_lists.size());
    tree_.hull_lists.push_back(static_cast<Offset>(offsets_.size()));
    tree_.hull_lists.insert(tree_.hull_lists.end(), offsets_.begin(), offsets_.end());
  }

  TriangleTree& tree_;
  WorkMeter& meter_;
  std::vector<double> allowed_;  ///< by node: how far outside the hull a vertex that is left out
                                 ///< may be [m]
  const Eigen::Vector3d* vertices_ = nullptr;
  std::vector<Offset> offsets_;          ///< the listed ones first
  std::vector<Eigen::Vector3d> listed_;  ///< positions of the listed vertices
};

}  // namespace

void listHullVertices(TriangleTree& tree, WorkMeter& meter) {
  HullLists(tree, meter);
}

}  // namespace link_bounds
