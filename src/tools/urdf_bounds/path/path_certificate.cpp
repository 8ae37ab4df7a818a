// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/path/path_certificate.h"

#include <fstream>
#include <map>
#include <sstream>

#include "robot/pairs/pair_certificate.h"
#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/request/certificate_head.h"

namespace link_bounds {
namespace {

/// The values of `joints` from the share `middle` - `half` of the motion to `middle` + `half`.
JointBox boxAround(const JointMotion& motion, const std::vector<std::size_t>& joints, double middle,
                   double half) {
  const std::vector<double> values = motion.at(middle);
  JointBox box;
  for (const std::size_t joint : joints) {
    box.center.push_back(values[joint]);
    box.half_widths.push_back(motion.spread(joint, middle, half));
  }
  return box;
}

}  // namespace

std::size_t writePathCertificate(const UrdfBoundsOptions& options, const Robot& simple,
                                 const PathBodies& bodies, const std::vector<JointMotion>& motions,
                                 const std::vector<SegmentProof>& proofs,
                                 const std::function<bool()>& is_over, std::ofstream& out) {
  const double goal = options.clearance.value_or(0);
  std::vector<PairBody> shapes;
  for (const PathBody& body : bodies.bodies)
    shapes.push_back(pairBody(body.body));
  /// Returns false and writes nothing if a pair has no tree.
  const auto write_segment = [&](std::size_t row, const JointMotion& motion, double clearance) {
    const double distance = goal + kClaimed * (clearance - goal);
    const std::vector<JointRange> ranges = rangesOf(simple, motion.ranges());
    std::ostringstream pairs;
    for (const auto& [first, second] : bodies.pairs) {
      if (shapes[first].body->shapes.empty() || shapes[second].body->shapes.empty()) continue;
      PairCertificate pair(
          jointPath(simple, ranges, bodies.bodies[first].link, bodies.bodies[second].link),
          shapes[first], shapes[second], {false, distance});
      const auto box_of = [&](double middle, double half) {
        return boxAround(motion, pair.path().variables, middle, half);
      };
      pairs << (pairs.tellp() > 0 ? ", " : "") << "{\"first\": " << jsonString(bodies.names[first])
            << ", \"second\": " << jsonString(bodies.names[second]) << ", \"tree\": ";
      if (!pair.writeTree(box_of, is_over, pairs)) return false;
      pairs << "}";
    }
    out << "{\"from\": " << row << ", \"to\": " << row + 1
        << ", \"distance\": " << exactNumber(distance) << ", \"pairs\": [" << pairs.str() << "]}\n";
    return true;
  };
  std::map<PathVerdict, std::size_t> left_out;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    const PathVerdict verdict = proofs[i].verdict;
    const bool is_covered =
        verdict == PathVerdict::kSafe && write_segment(i + 1, motions[i], proofs[i].clearance);
    ++(is_covered ? covered : left_out[verdict]);
  }
  endCertificate(options, "segments", covered, jsonCounts(left_out), out);
  return left_out[PathVerdict::kSafe];
}

}  // namespace link_bounds
