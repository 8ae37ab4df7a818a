// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/pairs/pairs_certificate.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "robot/pairs/pair_certificate.h"
#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/pairs/pair_words.h"
#include "tools/urdf_bounds/request/certificate_head.h"

namespace link_bounds {
namespace {

class ProofCertificate {
 public:
  ProofCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges)
      : options_(options), robot_(robot), bounded_(bounded), ranges_(ranges) {
    for (const Body& body : bounded.bodies)
      bodies_.push_back(pairBody(body));
  }

  /// False, and nothing is written, if there is no tree.
  bool writePair(const PairProof& proof, const std::function<bool()>& is_over,
                 std::ostream& out) const {
    const PairClaim claim = claimOf(proof);
    PairCertificate pair(
        jointPath(robot_, ranges_, bounded_.indices[proof.first], bounded_.indices[proof.second]),
        bodies_[proof.first], bodies_[proof.second], claim);
    std::ostringstream tree;
    const auto name = [&](std::size_t joint) { return jsonString(robot_.joints[joint].name); };
    if (!pair.writeTree(is_over, tree)) return false;
    out << "{\"first\": " << jsonString(bounded_.links[proof.first].name)
        << ", \"second\": " << jsonString(bounded_.links[proof.second].name) << ", \"verdict\": \""
        << toText(proof.verdict) << "\", \"distance\": " << exactNumber(claim.distance)
        << ", \"variables\": [" << joined(pair.path().variables, ", ", name)
        << "], \"tree\": " << tree.str() << "}\n";
    return true;
  }

 private:
  /// Of one pose it is measured whether the bodies touch.
  PairClaim claimOf(const PairProof& proof) const {
    const double goal = options_.clearance.value_or(0);
    if (proof.verdict == Verdict::kNever)
      return {false, goal + kClaimed * (proof.clearance - goal)};
    if (proof.verdict == Verdict::kTouching)
      return {true, std::max(goal, options_.touching.value_or(kDefaultTouching))};
    return {true, proof.can_move ? goal : goal + PairGoal::kTouch};
  }

  const UrdfBoundsOptions& options_;
  const Robot& robot_;
  const BoundedRobot& bounded_;
  const std::vector<JointRange>& ranges_;
  std::vector<PairBody> bodies_;
};

bool isProven(Verdict verdict) {
  return verdict == Verdict::kNever || verdict == Verdict::kAlways || verdict == Verdict::kTouching;
}

}  // namespace

std::size_t writeCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                             const BoundedRobot& bounded, const std::vector<JointRange>& ranges,
                             const std::vector<PairProof>& proofs,
                             const std::function<bool()>& is_over, std::ofstream& out) {
  const ProofCertificate certificate(options, robot, bounded, ranges);
  std::map<Verdict, std::size_t> left_out;
  std::size_t covered = 0;
  for (const PairProof& proof : proofs) {
    if (isProven(proof.verdict) && certificate.writePair(proof, is_over, out)) {
      ++covered;
    } else {
      ++left_out[proof.verdict];
    }
  }
  endCertificate(options, "pairs", covered, jsonCounts(left_out), out);
  return left_out[Verdict::kNever] + left_out[Verdict::kAlways] + left_out[Verdict::kTouching];
}

}  // namespace link_bounds
