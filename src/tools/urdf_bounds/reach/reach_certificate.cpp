// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/reach/reach_certificate.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "robot/reach/reach_bound.h"
#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/request/certificate_head.h"

namespace link_bounds {
namespace {

/// Min and max number of cells of a table; more would make a file of hundreds of megabytes.
constexpr int kFirstCells = 8;
constexpr int kLastCells = 64;

/// A link behind more moving joints is left out.
constexpr std::size_t kMaxJoints = 100;

/// Supports are rounded to multiples of this step [m], or of a larger one for a link that reaches
/// farther than 1 m.
constexpr double kStep = 1e-7;

/// The box that the tables prove, and by how much it exceeds the box of the reach [m].
struct ProvenBox {
  Aabb box;
  double slack;
};

/// Grows `box` by `step` on each side, and compares it with the reach.
ProvenBox exceeding(const Aabb& box, const Reach& reach, double step) {
  ProvenBox result{box, 0};
  result.box.max().array() += step;
  result.box.min().array() -= step;
  for (std::size_t face = 0; face < kFaces; ++face) {
    const double excess = beyond(face, faceOf(result.box, face), reach.faces[face].at);
    result.slack = std::max(result.slack, excess);
  }
  return result;
}

void writeLink(const std::string& name, int cells, double step, const ProvenBox& proven,
               const ReachBound& bound, std::ostream& out) {
  out << "{\"link\": " << jsonString(name) << ", \"min\": " << jsonNumbers(proven.box.min())
      << ", \"max\": " << jsonNumbers(proven.box.max())
      << ", \"slack\": " << exactNumber(proven.slack) << ", \"cells\": " << cells
      << ", \"step\": " << exactNumber(step) << ", \"tables\": [";
  for (std::size_t joint = 1; joint <= bound.joints(); ++joint) {
    out << (joint > 1 ? "], [" : "[");
    const char* separator = "";
    for (const double support : bound.supportsAfter(joint))
      out << std::exchange(separator, ",") << std::llround(support / step);
  }
  out << (bound.joints() > 0 ? "]]}\n" : "]}\n");
}

}  // namespace

std::size_t writeReachCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                                  const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges,
                                  const std::vector<std::optional<Reach>>& reaches,
                                  const std::function<bool()>& is_over, std::ofstream& out) {
  const double accuracy = options.accuracy.value_or(kDefaultAccuracy);
  const std::vector<double> radii = linkRadii(robot, bounded, ranges);
  /// Returns false and writes nothing if the link cannot be proven.
  const auto certify = [&](std::size_t index) {
    if (!reaches[index] || !bounded.links[index].isWhole()) return false;
    BoundedLink link = bounded.links[index];
    link.padding = 0;
    const JointPath chain = jointPath(robot, ranges, robot.root, bounded.indices[index]);
    if (chain.joints.size() > kMaxJoints) return false;
    const double step = kStep * std::max(1.0, radii[index]);
    for (int cells = kFirstCells;; cells *= 2) {
      ReachBound bound(chain, link, radii[index], cells, is_over);
      bound.roundSupports(step);
      const std::optional<Aabb> box = bound.box();
      if (!box) return false;
      const ProvenBox proven = exceeding(*box, *reaches[index], step);
      if (proven.slack > accuracy && cells < kLastCells) continue;
      writeLink(link.name, cells, step, proven, bound, out);
      return true;
    }
  };
  std::size_t covered = 0;
  for (std::size_t i = 0; i < reaches.size(); ++i)
    covered += certify(i) ? 1u : 0u;
  const std::size_t left_out = reaches.size() - covered;
  endCertificate(options, "links", covered, std::to_string(left_out), out);
  return left_out;
}

}  // namespace link_bounds
