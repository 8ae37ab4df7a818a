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

class SegmentCertificate {
 public:
  SegmentCertificate(double goal, const Robot& robot, const PathBodies& bodies)
      : goal_(goal), robot_(robot), bodies_(bodies) {
    for (const PathBody& body : bodies.bodies)
      shapes_.push_back(pairBody(body.body));
  }

  /// Returns false and writes nothing if a pair has no tree.
  bool writeSegment(std::size_t row, const JointMotion& motion, const SegmentProof& proof,
                    const std::function<bool()>& is_over, std::ostream& out) const {
    const double distance = goal_ + kClaimed * (proof.clearance - goal_);
    const std::vector<JointRange> ranges = rangesOf(robot_, motion.ranges());
    std::ostringstream pairs;
    for (const auto& [first, second] : bodies_.pairs) {
      if (shapes_[first].body->shapes.empty() || shapes_[second].body->shapes.empty()) continue;
      PairCertificate pair(
          jointPath(robot_, ranges, bodies_.bodies[first].link, bodies_.bodies[second].link),
          shapes_[first], shapes_[second], {false, distance});
      const auto box_of = [&](double middle, double half) {
        const std::vector<double> values = motion.at(middle);
        JointBox box;
        for (const std::size_t joint : pair.path().variables) {
          box.center.push_back(values[joint]);
          box.half_widths.push_back(motion.spread(joint, middle, half));
        }
        return box;
      };
      pairs << (pairs.tellp() > 0 ? ", " : "") << "{\"first\": " << jsonString(bodies_.names[first])
            << ", \"second\": " << jsonString(bodies_.names[second]) << ", \"tree\": ";
      if (!pair.writeTree(box_of, is_over, pairs)) return false;
      pairs << "}";
    }
    out << "{\"from\": " << row << ", \"to\": " << row + 1
        << ", \"distance\": " << exactNumber(distance) << ", \"pairs\": [" << pairs.str() << "]}\n";
    return true;
  }

 private:
  double goal_;
  const Robot& robot_;
  const PathBodies& bodies_;
  std::vector<PairBody> shapes_;
};

}  // namespace

std::size_t writePathCertificate(const UrdfBoundsOptions& options, const Robot& simple,
                                 const PathBodies& bodies, const std::vector<JointMotion>& motions,
                                 const std::vector<SegmentProof>& proofs,
                                 const std::function<bool()>& is_over, std::ofstream& out) {
  const SegmentCertificate certificate(options.clearance.value_or(0), simple, bodies);
  std::map<PathVerdict, std::size_t> left_out;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    if (proofs[i].verdict == PathVerdict::kSafe &&
        certificate.writeSegment(i + 1, motions[i], proofs[i], is_over, out)) {
      ++covered;
    } else {
      ++left_out[proofs[i].verdict];
    }
  }
  endCertificate(options, "segments", covered, jsonCounts(left_out), out);
  return left_out[PathVerdict::kSafe];
}

}  // namespace link_bounds
