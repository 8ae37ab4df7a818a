// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest distance of each pair of bodies, proven.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/Distance.h"
#include "link_bounds/robot/robot_loader.h"
#include "tools/bag_bounds/scene/record_time.h"
#include "tools/bag_bounds/watch/pair_motions.h"
#include "world/moment/scene_distances.h"

namespace link_bounds {

struct NearestPair {
  Distance distance;  ///< the smallest lower bound of all poses that were examined
  RecordTime when;
  double clearance = 0;  ///< proven: they never came nearer, also between messages [m]
};

/// Pairs, limit and accuracy are those of the model. Triangles are loaded when they are first
/// needed, before the distance is computed.
class NearestPairs {
 public:
  static constexpr std::size_t kMaxPairs = 10'000;  ///< further ones are only counted

  using LoadTree = std::function<LoadedTree(const std::string& uri)>;

  explicit NearestPairs(LoadTree load_tree);
  NearestPairs(const NearestPairs&) = delete;
  NearestPairs& operator=(const NearestPairs&) = delete;

  /// See PairMotions.
  void remember(const Scene& scene, std::int64_t now) { motions_.remember(scene, now); }

  /// The scene must have a model. Also examines the motions since the last call. Adds only a part,
  /// or nothing, if it is interrupted.
  void add(const Scene& scene, const TransformBuffer& tf, std::int64_t now);

  /// Call it at the end of the report and before tf forgets: takes the bodies to stay where they
  /// are.
  void endMotions(const TransformBuffer& tf);

  /// The distances of the last add().
  const std::vector<Distance>& latest() const { return latest_; }

  /// In alphabetical order.
  std::vector<NearestPair> pairs() const;

  std::uint64_t pairsLeftOut() const { return left_out_; }

  /// Whether a distance was below the limit of the model, or a contact.
  bool wasUndercut() const { return was_undercut_; }

  /// Whether any two bodies were compared, whatever their distance.
  bool hasCompared() const { return has_compared_; }

  /// Number of motions between messages for which it is not known how near two bodies came.
  std::uint64_t undecided() const { return undecided_; }
  /// A message about the first of them.
  const std::string& firstUndecided() const { return first_undecided_; }

  /// Whether the last step was examined only in part or not at all.
  bool wasInterrupted() const { return was_interrupted_; }

  /// Names of bodies that have boxes, but for which some distances are missing.
  const std::set<std::string>& incomplete() const { return incomplete_; }

  /// Meshes that count as their convex hull, with the reason.
  const std::set<std::string>& problems() const { return problems_; }

 private:
  using Pairs = std::map<std::pair<std::string, std::string>, NearestPair>;

  TreeRequests requests();
  std::optional<ComputedDistances> compute(const MomentPtr& moment);
  void addNow(const ComputedDistances& computed, double limit, std::int64_t now);
  PairMotions::Handlers motionHandlers();
  void take(const Moment& moment, const PairMotion& motion);
  void takeUndecided(const std::string& first, const std::string& second, const std::string& why);
  void keep(const Distance& distance, const RecordTime& when);
  Pairs::iterator find(const std::string& first, const std::string& second);

  LoadTree load_tree_;
  MomentPairs moment_pairs_;
  SceneDistances distances_;
  PairMotions motions_;
  Pairs pairs_;
  std::vector<Distance> latest_;
  std::int64_t now_ = 0;  ///< of the last add()
  std::set<std::string> problems_;
  std::set<std::string> incomplete_;
  std::uint64_t undecided_ = 0;
  std::string first_undecided_;
  std::uint64_t left_out_ = 0;  ///< distances of pairs beyond kMaxPairs
  bool was_undercut_ = false;
  bool has_compared_ = false;
  bool was_interrupted_ = false;
};

}  // namespace link_bounds
