// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random trees, looks and jumps of the clock, beside a list of all that was ever seen.
#include "tools/bag_bounds/scene/edge_begins.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "testing/live_boxes_testing.h"
#include "testing/random_tf.h"

namespace link_bounds {
namespace {

constexpr int kFrames = 12;

/// Frame 0 is the root, and every frame hangs on one of a lower number.
class RandomTree {
 public:
  explicit RandomTree(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < kFrames; ++i)
      tf_.frame(frameName(i));
    EXPECT_EQ(tf_.frame(frameName(3)), 3u) << "numbers go up";
  }

  void step() {
    now_ += 1 + pick(1'000'000'000);
    const int kind = pick(20);
    if (kind < 8)
      addEdge();
    else if (kind < 12)
      look();
    else if (kind == 12 && pick(4) == 0)
      jump();
    else
      compare();
  }

  int known() const { return known_; }

 private:
  using Frame = TransformBuffer::Frame;

  struct Seen {
    Frame edge;
    std::int64_t at;
  };

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  void addEdge() {
    const int child = 1 + pick(kFrames - 1);
    const bool is_static = child % 4 == 0;
    const int parent = pick(child);
    const double stamp = 1 + static_cast<double>(now_) / 1e9;
    const auto transform = edge(frameName(parent), frameName(child), stamp,
                                Eigen::Quaterniond::Identity(), random_.vector(1));
    tf_.add({TransformView(transform)}, is_static, ros::Time(stamp));
    parents_[static_cast<Frame>(child)] = static_cast<Frame>(parent);
  }

  std::vector<Frame> edgesAbove(Frame frame) const {
    std::vector<Frame> edges;
    for (auto at = parents_.find(frame); at != parents_.end(); at = parents_.find(at->second))
      edges.push_back(at->first);
    return edges;
  }

  static bool moves(Frame edge) { return edge % 4 != 0; }

  void look() {
    const auto frame = static_cast<Frame>(pick(kFrames));
    begins_.look(tf_, frame, now_);
    for (const Frame edge : edgesAbove(frame)) {
      if (moves(edge)) seen_.push_back({edge, now_});
    }
  }

  void jump() {
    tf_.clear();
    begins_.clear();
    seen_.clear();
    for (auto at = parents_.begin(); at != parents_.end();)
      at = moves(at->first) ? parents_.erase(at) : std::next(at);
  }

  std::optional<std::int64_t> expected(Frame target, Frame source) const {
    std::set<Frame> between;
    for (const Frame frame : {target, source}) {
      for (const Frame edge : edgesAbove(frame)) {
        if (!between.insert(edge).second) between.erase(edge);  // above both
      }
    }
    std::optional<std::int64_t> since;
    for (const Frame edge : between) {
      if (!moves(edge)) continue;
      std::int64_t begin = now_;
      for (const Seen& seen : seen_) {
        if (seen.edge == edge) begin = std::min(begin, seen.at);
      }
      since = std::max(since.value_or(0), begin);
    }
    return since;
  }

  /// Of frames without a common root nothing is asked.
  void compare() {
    const auto target = static_cast<Frame>(pick(kFrames)),
               source = static_cast<Frame>(pick(kFrames));
    if (!tf_.pose(target, source, 0)) return;
    const auto since = begins_.allSince(tf_, target, source, now_);
    ASSERT_EQ(since, expected(target, source)) << target << " " << source;
    known_ += since && *since < now_ ? 1 : 0;
  }

  brute_force::Random random_;
  TransformBuffer tf_;
  EdgeBegins begins_;
  std::map<Frame, Frame> parents_;
  std::vector<Seen> seen_;
  std::int64_t now_ = 1;
  int known_ = 0;  ///< comparisons that memory decided
};

TEST(EdgeBegins, AreThoseOfAListOfAllThatWasSeen) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomTree tree(seed);
    for (int i = 0; i < 2000; ++i) {
      tree.step();
      ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", step " << i;
    }
    EXPECT_GT(tree.known(), 100) << seed;
  }
}

}  // namespace
}  // namespace link_bounds
