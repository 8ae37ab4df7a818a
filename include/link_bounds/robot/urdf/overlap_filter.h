// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Which overlaps are not reported: those of links that are joined, and of pairs that the user
/// names, with wildcards or without. Nothing here throws.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Links that fixed joints connect are one body.
struct RigidBodies {
  std::vector<std::size_t> of_links;  ///< by link, with or without geometry: its body
  std::vector<std::size_t> parents;   ///< by body: its parent, whose number is smaller; the first
                                      ///< body is its own
};

RigidBodies rigidBodies(const Robot& robot);

/// Whether at most `joints` movable joints are on the way from one link to the other; between links
/// of one body there is none.
bool areJoined(const RigidBodies& bodies, std::size_t link, std::size_t other, int joints = 1);

/// The same for two bodies, numbered as in RigidBodies::of_links.
bool areBodiesJoined(const RigidBodies& bodies, std::size_t body, std::size_t other, int joints);

using NamePair = std::pair<std::string, std::string>;

/// Splits `text` into two names with spaces between them. Names may contain spaces, so a text of
/// more than two words can be split in several ways: returns all splits into two strings for which
/// `is_name` holds. Returns the only split of two words without calling it.
std::vector<NamePair> namePairs(const std::string& text,
                                const std::function<bool(const std::string&)>& is_name);

/// Whether a name has a wildcard `*` in it.
bool isPattern(const std::string& name);

/// Whether `name` is `pattern`, in which each `*` stands for any text without a slash, or for none.
bool fitsPattern(const std::string& name, const std::string& pattern);

/// A set of pairs of names, in either order. A name may be a pattern.
class NamePairs {
 public:
  NamePairs() = default;
  explicit NamePairs(std::vector<NamePair> pairs);

  bool contains(const std::string& name, const std::string& other) const;

  /// The other name, or pattern, of each pair that `name` fits.
  std::vector<std::string> partnersOf(const std::string& name) const;

 private:
  std::vector<NamePair> pairs_;     // without patterns; sorted, and so is each pair
  std::vector<NamePair> patterns_;  // pairs with at least one pattern
};

}  // namespace link_bounds
