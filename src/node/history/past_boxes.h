// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a copied scene at the time of a request.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/box_groups.h"
#include "node/history/past_scene.h"

namespace link_bounds {

struct PastBoxes {
  /// In the order of ~boxes. The names are those of the scene's bodies.
  struct Entry {
    const std::string* name;
    BoxState state;
  };

  std::vector<Entry> entries;
  std::string problem;  ///< why the first incomplete body is that, and how many more there are
};

/// Asks now and then whether to give up; the result is then not complete.
PastBoxes pastBoxes(PastScene& scene, const BoxRequest& request,
                    const std::function<bool()>& is_cancelled);

/// Why nothing can be computed for the scene, in words; "" if it can.
std::string whyRefused(const PastScene& scene);

}  // namespace link_bounds
