// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Which boxes may overlap without anybody being told: those of links that are joined, and pairs
/// that the user names. Nothing here throws.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Links that cannot move against each other, because fixed joints connect them, are one body.
struct RigidBodies {
  std::vector<std::size_t> of_links;  ///< the body of each link, with or without geometry
  std::vector<std::size_t> parents;   ///< of each body; the first body is its own parent
};

RigidBodies rigidBodies(const Robot& robot);

/// Whether two links are of one body, or of two bodies that a movable joint connects.
bool areJoined(const RigidBodies& bodies, std::size_t link, std::size_t other);

using NamePair = std::pair<std::string, std::string>;

/// The two names in `text`, with spaces between them. A text of more than two words can be split
/// in several ways, because names may have spaces in them, too: all splits count that give two
/// strings for which `is_name` holds. None if there is no such split or less than two words.
std::vector<NamePair> namePairs(const std::string& text,
                                const std::function<bool(const std::string&)>& is_name);

/// Pairs of names, whichever stands first.
class NamePairs {
 public:
  NamePairs() = default;
  explicit NamePairs(std::vector<NamePair> pairs);

  bool contains(const std::string& name, const std::string& other) const;

 private:
  std::vector<NamePair> pairs_;  // sorted, in themselves too
};

}  // namespace link_bounds
