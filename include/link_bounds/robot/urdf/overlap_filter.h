// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Which overlaps are not reported: those of links that are joined, and of pairs that the user
/// names. Nothing here throws.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Links that fixed joints connect are one body.
struct RigidBodies {
  std::vector<std::size_t> of_links;  ///< of each link, with or without geometry, its body
  std::vector<std::size_t> parents;   ///< of each body its parent; the first body is its own
};

RigidBodies rigidBodies(const Robot& robot);

/// Whether two links are of one body, or of two bodies that a movable joint connects.
bool areJoined(const RigidBodies& bodies, std::size_t link, std::size_t other);

using NamePair = std::pair<std::string, std::string>;

/// Splits `text` into two names with spaces between them. Names may contain spaces, so a text of
/// more than two words can be split in several ways: returns all splits into two strings for which
/// `is_name` holds. Returns the only split of two words without calling it.
std::vector<NamePair> namePairs(const std::string& text,
                                const std::function<bool(const std::string&)>& is_name);

/// A set of pairs of names, in either order.
class NamePairs {
 public:
  NamePairs() = default;
  explicit NamePairs(std::vector<NamePair> pairs);

  bool contains(const std::string& name, const std::string& other) const;

 private:
  std::vector<NamePair> pairs_;  // sorted, and so is each pair
};

}  // namespace link_bounds
