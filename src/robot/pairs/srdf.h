// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The pairs that a SRDF exempts from collision checks, and how to write other ones into a SRDF.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The text cannot be used as a SRDF of the robot; what() is the reason with the remedy.
class SrdfError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Two links that need no check, by a <disable_collisions> element or by default.
struct DisabledPair {
  std::string first;
  std::string second;
  std::string reason;  ///< as written, or kByDefault; may be empty
};

/// The reason of links that always collide.
constexpr char kAlwaysReason[] = "Always";

/// The reason of the pairs of a link with <disable_default_collisions>: those with all other links,
/// but for the pairs of <enable_collisions>.
constexpr char kByDefault[] = "Default";

/// The disabled pairs in the order of the text, then those by default. All other elements are
/// ignored. `file` is named in errors. Throws SrdfError for a text that is no SRDF, such as a URDF,
/// for a second root, for other elements that name two links, and for names that are no link of the
/// robot.
std::vector<DisabledPair> parseSrdf(const std::string& text, const Robot& robot,
                                    const std::string& file);

/// A warning if the SRDF, which parseSrdf() has accepted, names another robot; "" if it does not.
std::string otherRobotWarning(const std::string& text, const Robot& robot, const std::string& file);

/// Finds exempt pairs by the names of links, in either order.
class Exemptions {
 public:
  explicit Exemptions(const std::vector<DisabledPair>& pairs);

  /// The reason of the exemption, "Always" rather than another one; null if there is none.
  const std::string* reasonOf(const std::string& first, const std::string& second) const;

  /// All exempt pairs, each once.
  std::vector<DisabledPair> pairs() const;

 private:
  std::map<std::pair<std::string, std::string>, std::string> reasons_;
};

/// What a SRDF says of a pair.
struct SrdfLine {
  std::optional<DisabledPair> pair = std::nullopt;  ///< none: there is only the comment
  std::string comment = {};                         ///< before the element; "" = none
};

/// The line as XML.
std::string toSrdf(const SrdfLine& line);

/// The SRDF `text`, which parseSrdf() has accepted, with these lines in place of its elements of
/// disabled pairs and defaults. All others stay, and so do comments.
std::string mergedSrdf(const std::string& text, const std::vector<SrdfLine>& lines);

}  // namespace link_bounds
