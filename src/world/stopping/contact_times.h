// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The earliest times at which bodies can touch, whatever the controllers do.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "link_bounds/EarliestContactArray.h"
#include "world/moment/scene_distances.h"
#include "world/stopping/body_ways.h"

namespace link_bounds {

struct ComputedContacts {
  EarliestContactArray array;
  std::string problem;  ///< why the first incomplete body is incomplete; number of others
};

/// Not thread-safe; belongs to one thread.
class ContactTimes {
 public:
  explicit ContactTimes(TreeRequests requests)
      : requests_(std::move(requests)), distances_(requests_) {}

  /// `scene` is a copy for wayRequest(); `rules` are those of its model; `states` may be null.
  /// Returns nothing if `is_cancelled`, which is called now and then, returns true. After that, or
  /// after an exception such as std::bad_alloc, the next call starts with forget().
  std::optional<ComputedContacts> compute(PastScene& scene, const StopRules& rules,
                                          const JointStates* states, TriangleTrees::Time now,
                                          const std::function<bool()>& is_cancelled);

  TriangleTrees& trees() { return distances_.trees(); }

  /// Frees all that is kept between two calls, including trees.
  void forget();

 private:
  TreeRequests requests_;
  SceneDistances distances_;
  MomentPairs pairs_;
  bool is_whole_ = true;  ///< false: the last call did not end, so kept data may be partial
};

}  // namespace link_bounds
