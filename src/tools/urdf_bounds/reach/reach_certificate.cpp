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

class ReachCertificate {
 public:
  ReachCertificate(const Robot& robot, const BoundedRobot& bounded,
                   const std::vector<JointRange>& ranges, double accuracy,
                   std::function<bool()> is_over)
      : robot_(robot),
        bounded_(bounded),
        ranges_(ranges),
        accuracy_(accuracy),
        is_over_(std::move(is_over)),
        radii_(linkRadii(robot, bounded, ranges)) {}

  /// Returns false and writes nothing if the link cannot be proven.
  bool write(std::size_t index, const Reach& reach, std::ostream& out) const {
    BoundedLink link = bounded_.links[index];
    link.padding = 0;
    const JointPath chain = jointPath(robot_, ranges_, robot_.root, bounded_.indices[index]);
    if (chain.joints.size() > kMaxJoints) return false;
    const double step = kStep * std::max(1.0, radii_[index]);
    for (int cells = kFirstCells;; cells *= 2) {
      ReachBound bound(chain, link, radii_[index], cells, is_over_);
      bound.roundSupports(step);
      const std::optional<Aabb> box = bound.box();
      if (!box) return false;
      const ProvenBox proven = exceeding(*box, reach, step);
      if (proven.slack > accuracy_ && cells < kLastCells) continue;
      writeLink(link.name, cells, step, proven, bound, out);
      return true;
    }
  }

 private:
  /// Grows `box` by `step` on each side, and compares it with the reach.
  static ProvenBox exceeding(const Aabb& box, const Reach& reach, double step) {
    ProvenBox result{box, 0};
    result.box.max().array() += step;
    result.box.min().array() -= step;
    for (std::size_t face = 0; face < kFaces; ++face) {
      const double excess = beyond(face, faceOf(result.box, face), reach.faces[face].at);
      result.slack = std::max(result.slack, excess);
    }
    return result;
  }

  static void writeLink(const std::string& name, int cells, double step, const ProvenBox& proven,
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

  const Robot& robot_;
  const BoundedRobot& bounded_;
  const std::vector<JointRange>& ranges_;
  double accuracy_;
  std::function<bool()> is_over_;
  std::vector<double> radii_;
};

}  // namespace

std::size_t writeReachCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                                  const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges,
                                  const std::vector<std::optional<Reach>>& reaches,
                                  const std::function<bool()>& is_over, std::ofstream& out) {
  const ReachCertificate certificate(robot, bounded, ranges,
                                     options.accuracy.value_or(kDefaultAccuracy), is_over);
  std::size_t covered = 0;
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const bool is_covered =
        reaches[i] && bounded.links[i].isWhole() && certificate.write(i, *reaches[i], out);
    ++(is_covered ? covered : left_out);
  }
  endCertificate(options, "links", covered, std::to_string(left_out), out);
  return left_out;
}

}  // namespace link_bounds
