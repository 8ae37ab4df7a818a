// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Halves the time interval until each part stays within the limits, or its middle is beyond them.
#include "tools/urdf_bounds/path/path_limits.h"

#include <cmath>
#include <optional>

#include "robot/urdf/limit_warnings.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr double kShortest = 1e-4;  // half-width of the shortest part, as a share of a segment

class LimitSearch {
 public:
  LimitSearch(const JointMotion& motion, const Lead& lead, const Joint& joint)
      : motion_(motion), lead_(lead), joint_(joint), limits_(*joint.limits) {}

  /// The value at this share of the motion (0 to 1), if it is beyond the limits.
  std::optional<double> beyondAt(double share) const {
    const double value = valueAt(share);
    return isBeyond(limits_, value) ? std::make_optional(value) : std::nullopt;
  }

  /// A value beyond the limits; std::nullopt if none is found, or if an end is already beyond them.
  std::optional<double> overshoot() const {
    if (beyondAt(0) || beyondAt(1)) return std::nullopt;
    return search(0.5, 0.5);
  }

  /// The message about a value beyond the limits.
  std::string leaves(double value) const {
    return "joint \"" + joint_.name + "\" leaves the limits " + shortestNumber(limits_.lower) +
           " to " + shortestNumber(limits_.upper) + ": " + shortestNumber(value);
  }

 private:
  double valueAt(double share) const {
    return lead_.factor * motion_.at(share)[lead_.leader] + lead_.offset;
  }

  std::optional<double> search(double share, double half) const {
    const double value = valueAt(share);
    if (isBeyond(limits_, value)) return value;
    const double spread = std::abs(lead_.factor) * motion_.spread(lead_.leader, share, half);
    const bool stays = !isBeyond(limits_, value - spread) && !isBeyond(limits_, value + spread);
    if (stays || half < kShortest) return std::nullopt;
    const std::optional<double> found = search(share - half / 2, half / 2);
    return found ? found : search(share + half / 2, half / 2);
  }

  const JointMotion& motion_;
  const Lead& lead_;
  const Joint& joint_;
  const Limits& limits_;
};

/// For each joint with limits, the first text of say(search, row) that is not empty.
template <class Say>
std::vector<std::string> ofEachJoint(const Robot& simple, const std::vector<JointMotion>& motions,
                                     const Say& say) {
  std::vector<std::string> result;
  const std::vector<Lead> leads = leadsOf(simple);
  for (std::size_t i = 0; i < simple.joints.size(); ++i) {
    const Joint& joint = simple.joints[i];
    if (!hasValue(joint.motion) || !joint.limits) continue;
    std::string text;
    for (std::size_t row = 0; row < motions.size() && text.empty(); ++row)
      text = say(LimitSearch(motions[row], leads[i], joint), row);
    if (!text.empty()) result.push_back(text);
  }
  return result;
}

}  // namespace

std::vector<std::string> overshoots(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name) {
  return ofEachJoint(simple, motions, [&](const LimitSearch& search, std::size_t row) {
    const std::optional<double> value = search.overshoot();
    return value ? "between " + row_name(row) + " and " + row_name(row + 1) + ", " +
                       search.leaves(*value)
                 : "";
  });
}

std::vector<std::string> rowsBeyond(const Robot& simple, const std::vector<JointMotion>& motions,
                                    const RowName& row_name) {
  return ofEachJoint(simple, motions, [&](const LimitSearch& search, std::size_t row) {
    if (const auto value = search.beyondAt(0))
      return "in " + row_name(row) + ", " + search.leaves(*value);
    if (const auto value = search.beyondAt(1))
      return "in " + row_name(row + 1) + ", " + search.leaves(*value);
    return std::string();
  });
}

}  // namespace link_bounds
