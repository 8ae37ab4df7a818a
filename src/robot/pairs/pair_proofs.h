// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot can collide while its joints move in their ranges.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "robot/pairs/pair_search.h"

namespace link_bounds {

enum class Verdict {
  kNever,           ///< proven: no pose collides
  kAlways,          ///< proven: every pose collides
  kTouching,        ///< proven: in every pose the links are within PairGoal::touching
  kContactSampled,  ///< many poses were tried, and all collide; nothing is proven
  kSometimes,       ///< a pose collides; whether every pose does is not proven
  kUndecided,
  kAdjacent  ///< a joint is between the links; not examined
};

constexpr std::size_t kVerdictCount = 7;

/// The word for a verdict in all output formats: NEVER, ALWAYS and so on.
const char* toText(Verdict verdict);

/// Which pairs are listed and examined. By default: all pairs that are not rigidly joined are
/// listed, and all of these but adjacent links are examined.
struct PairChoice {
  bool examines_adjacent = false;  ///< adjacent links, too, if not rigidly joined
  bool lists_rigid = false;        ///< lists rigidly joined links, too
};

struct PairProof {
  std::size_t first = 0;   ///< index in BoundedRobot::links
  std::size_t second = 0;  ///< stands after `first`
  bool is_rigid = false;   ///< only fixed joints are between the two
  Verdict verdict = Verdict::kUndecided;
  double clearance = 0;  ///< proven: the links are never nearer [m]
  /// Upper bound of the distance of the links in `pose` [m]; infinite if no pose was tried.
  double nearest = std::numeric_limits<double>::infinity();
  /// A pose that collides, or the nearest one that was found: values of the joints between the
  /// links that move, or that rest at a value other than 0 [rad, m].
  std::map<std::string, double> pose;
  bool can_move = false;       ///< a joint between the links can move
  bool has_free_pose = false;  ///< a pose was found that does not collide
  std::string reason;          ///< why nothing is known about the pair; mostly empty
  std::size_t poses = 0;       ///< number of poses tried
};

struct ProofControl {
  std::function<bool()> is_over = [] { return false; };  ///< true: ends all; any thread calls it
  /// Called with the number of pairs that are decided and of all pairs, by one thread at a time;
  /// may be null.
  std::function<void(std::size_t, std::size_t)> progress = {};
  unsigned threads = 0;  ///< 0: one per core
  /// Max memory of all searches that wait for their next turn: twenty full ones, or a thousand
  /// typical ones.
  std::size_t max_kept_bytes = 100'000'000;
};

/// Returns all chosen pairs of links with geometry, in the order of the links. `bounded` has
/// bodies, `ranges` has one per joint. A pair with an incomplete link is never kNever. Threads only
/// share the work: each pair is searched as it would be alone, until the control says that it is
/// over. Pairs whose turn has not come by then are undecided. A search takes some 20 MB at most in
/// its turn.
std::vector<PairProof> provePairs(const Robot& robot, const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges, const PairGoal& goal,
                                  const ProofControl& control, PairChoice choice = {});

}  // namespace link_bounds
