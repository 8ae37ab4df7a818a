// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Halves the time until each part stays within the limits, or its middle does not.
#include "tools/urdf_bounds/path/path_limits.h"

#include <cmath>
#include <optional>

#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/request/joint_table.h"

namespace link_bounds {
namespace {

constexpr double kShortest = 1e-4;  // share of a segment

class LimitSearch {
 public:
  LimitSearch(const JointMotion& motion, const Lead& lead, const Limits& limits)
      : motion_(motion), lead_(lead), limits_(limits) {}

  /// A value beyond the limits, if both ends keep them.
  std::optional<double> overshoot() const {
    if (isBeyond(limits_, valueAt(0)) || isBeyond(limits_, valueAt(1))) return std::nullopt;
    return search(0.5, 0.5);
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
  const Limits& limits_;
};

}  // namespace

std::vector<std::string> overshoots(const std::string& file, const Robot& simple,
                                    const std::vector<JointMotion>& motions) {
  std::vector<std::string> result;
  const std::vector<Lead> leads = leadsOf(simple);
  for (std::size_t i = 0; i < simple.joints.size(); ++i) {
    const Joint& joint = simple.joints[i];
    if (!hasValue(joint.motion) || !joint.limits) continue;
    for (std::size_t row = 0; row < motions.size(); ++row) {
      const auto value = LimitSearch(motions[row], leads[i], *joint.limits).overshoot();
      if (!value) continue;
      result.push_back(file + ": between row " + std::to_string(row + 1) + " and row " +
                       std::to_string(row + 2) + ", joint \"" + joint.name +
                       "\" leaves the limits " + shortestNumber(joint.limits->lower) + " to " +
                       shortestNumber(joint.limits->upper) + ": " + shortestNumber(*value));
      break;
    }
  }
  return result;
}

}  // namespace link_bounds
