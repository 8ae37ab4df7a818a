// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/cloud/scan_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/history/motion_path.h"

namespace link_bounds {
namespace {

/// Of a scan; typical ones take 0.1 s.
constexpr std::int64_t kMaxSpan = 5000000000;  // ns

/// A pose of 50 links takes some 20 us.
constexpr std::size_t kMaxMoments = 1000;

/// What rounding adds to a box, relative to its largest coordinate, and a floor [m].
constexpr double kRounding = 1e-12;
constexpr double kFloor = 1e-9;

/// A link that moves, or does not.
class Mover {
 public:
  Mover(MotionPath path, const Aabb& box) : path_(std::move(path)), box_(box) {
    for (const Eigen::Vector3d& corner : corners(box))
      radius_ = std::max(radius_, corner.norm());
  }

  void addMoments(TimeSpan span, std::vector<std::int64_t>& moments) const {
    forEachEdge(*this, [&](const EdgeMotion& edge) {
      if (!edge.isMoving()) return;
      for (const EdgeSample* sample : edge.samples()) {
        if (sample->stamp > span.begin && sample->stamp < span.end)
          moments.push_back(sample->stamp);
      }
    });
  }

  void seek(std::int64_t time) {
    forEachEdge(*this, [&](EdgeMotion& edge) { edge.seek(time); });
  }

  /// Between the samples that were sought.
  Tf2Pose linkFromSensor(std::int64_t time) const {
    Tf2Pose top_from_sensor, top_from_link;
    for (const EdgeMotion& edge : path_.from_source)
      top_from_sensor = edge.at(time) * top_from_sensor;
    for (const EdgeMotion& edge : path_.from_target)
      top_from_link = edge.at(time) * top_from_link;
    return path_.from_target.empty() ? top_from_sensor : inverse(top_from_link) * top_from_sensor;
  }

  /// How far the link, and a point that the sensor sees within `range`, leave the straight way in
  /// `duration` after the samples that were sought.
  struct Errors {
    double smooth = 0;   ///< of the point; in n equal parts n^2 times smaller
    double jump = 0;     ///< the same in any part
    double link = 0;     ///< of the link in the sensor's frame
    double stretch = 0;  ///< of the link, because quaternions are not of length 1
  };
  Errors errors(std::int64_t duration, double distance, double range) const {
    PathSteps steps, back;
    double scale = 1, lengths = radius_;
    const auto fill = [&](const std::vector<EdgeMotion>& edges, std::vector<EdgeStep>& out) {
      for (const EdgeMotion& edge : edges) {
        out.push_back(edge.stepIn(duration));
        scale *= std::max(out.back().length2, 1 / out.back().min_length2);
        lengths += out.back().distance;
      }
    };
    fill(path_.from_source, steps.from_link);
    fill(path_.from_target, steps.from_target);
    back.from_link = steps.from_target;
    back.from_target = steps.from_link;
    const Bulge of_point = bulge(steps, range, distance);
    const Bulge of_link = bulge(back, radius_, distance);
    return {of_point.smooth, of_point.jump, of_link.smooth + of_link.jump,
            2 * std::max(scale - 1, 0.0) * scale * lengths};
  }

  bool isMoving() const {
    bool result = false;
    forEachEdge(*this, [&](const EdgeMotion& edge) { result |= edge.isMoving(); });
    return result;
  }

  /// True if tf2 may move it in two ways: see step 6 of deviation_bound.h.
  bool isAmbiguous() const {
    bool result = false;
    forEachEdge(*this, [&](const EdgeMotion& edge) { result |= edge.isAmbiguous(); });
    return result;
  }

  const Aabb& box() const { return box_; }
  double radius() const { return radius_; }

 private:
  template <class Self, class Visit>
  static void forEachEdge(Self& self, Visit visit) {
    for (auto* edges : {&self.path_.from_source, &self.path_.from_target}) {
      for (auto& edge : *edges)
        visit(edge);
    }
  }

  MotionPath path_;
  Aabb box_;
  double radius_ = 0;  ///< of the box, around the origin of the link
};

/// The box of the link in the sensor's frame in one pose, with what rounding may add.
Aabb boxAt(const Aabb& link_box, const Eigen::Affine3d& link_from_sensor) {
  const Eigen::Affine3d sensor_from_link = link_from_sensor.inverse(Eigen::Isometry);
  Aabb box;
  for (const Eigen::Vector3d& corner : corners(link_box))
    box.extend(sensor_from_link * corner);
  const double size =
      link_from_sensor.translation().norm() + link_box.sizes().norm() + link_box.center().norm();
  return padded(box, kFloor + kRounding * size);
}

double largestNorm(const Aabb& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

class Scan {
 public:
  Scan(const TransformBuffer& tf, TransformBuffer::Frame sensor, TimeSpan span, double range)
      : tf_(tf), sensor_(sensor), span_(span), range_(range) {}

  ScanPoses poses(const std::vector<ScannedLink>& links) {
    if (span_.end - span_.begin > kMaxSpan) {
      result_.problem = "its points are from more than 5 s; correct the field of times";
      return result_;
    }
    if (!findPaths(links)) return result_;
    moments_ = {span_.begin, span_.end};
    for (const Mover& mover : movers_)
      mover.addMoments(span_, moments_);
    sortMoments();
    if (!divide()) return result_;
    for (std::size_t i = 0; i < movers_.size(); ++i)
      follow(i);
    result_.moments = std::move(moments_);
    for (const LinkMotion& link : result_.links) {
      if (!link.box.isEmpty()) result_.box.extend(link.box);
    }
    return result_;
  }

 private:
  bool findPaths(const std::vector<ScannedLink>& links) {
    result_.links.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links[i].box.isEmpty()) continue;
      MotionPath path = pathBetween(tf_, links[i].frame, sensor_, {span_.begin, span_.end}, 0);
      if (!path.problem.empty()) {
        result_.problem = path.problem;
        result_.may_come = true;
        return false;
      }
      movers_.emplace_back(std::move(path), links[i].box);
      places_.push_back(i);
    }
    return true;
  }

  void sortMoments() {
    std::sort(moments_.begin(), moments_.end());
    moments_.erase(std::unique(moments_.begin(), moments_.end()), moments_.end());
  }

  /// Adds moments until the errors are small. False if there would be too many.
  bool divide() {
    std::vector<std::int64_t> more;
    for (std::size_t k = 0; k + 1 < moments_.size(); ++k) {
      double parts = 1;
      for (Mover& mover : movers_)
        parts = std::max(parts, partsOf(mover, moments_[k], moments_[k + 1]));
      const std::int64_t duration = moments_[k + 1] - moments_[k];
      // No point has a time between two nanoseconds.
      if (std::isfinite(parts) || duration == 1)
        parts = std::min(parts, static_cast<double>(duration));
      if (!(parts + static_cast<double>(moments_.size() + more.size()) <= kMaxMoments)) {
        result_.problem =
            "the robot or the sensor moves so fast that a thousand poses are too few; look at tf";
        return false;
      }
      const auto count = static_cast<std::int64_t>(parts);
      for (std::int64_t i = 1; i < count; ++i)
        more.push_back(moments_[k] + duration * i / count);
    }
    moments_.insert(moments_.end(), more.begin(), more.end());
    sortMoments();
    return true;
  }

  /// Of the time between two moments; infinite if no number helps.
  double partsOf(Mover& mover, std::int64_t begin, std::int64_t end) const {
    if (!mover.isMoving()) return 1;
    mover.seek(begin);
    if (mover.isAmbiguous()) return std::numeric_limits<double>::infinity();
    const Mover::Errors errors = errorsBetween(mover, begin, end);
    const double allowed = 0.9 * kMaxMotionError - errors.jump;
    if (!(allowed > 0) || !std::isfinite(errors.smooth))
      return std::numeric_limits<double>::infinity();
    return std::max(std::ceil(std::sqrt(errors.smooth / allowed)), 1.0);
  }

  /// Between two samples. The range is that of the link's box at both ends, with its way between.
  Mover::Errors errorsBetween(Mover& mover, std::int64_t begin, std::int64_t end) const {
    const Eigen::Affine3d from = MatrixPose(mover.linkFromSensor(begin)).affine;
    const Eigen::Affine3d to = MatrixPose(mover.linkFromSensor(end)).affine;
    const double distance = std::max(from.translation().norm(), to.translation().norm());
    const Mover::Errors of_link = mover.errors(end - begin, distance, 0);
    Aabb box = boxAt(mover.box(), from).merged(boxAt(mover.box(), to));
    const double range = largestNorm(box) + of_link.link + of_link.stretch;
    return mover.errors(end - begin, distance, std::max(range, range_));
  }

  /// The poses and the box of one link.
  void follow(std::size_t index) {
    Mover& mover = movers_[index];
    LinkMotion& motion = result_.links[places_[index]];
    const std::size_t count = mover.isMoving() ? moments_.size() : 1;
    double link_error = 0;
    for (std::size_t k = 0; k < count; ++k) {
      mover.seek(moments_[k]);
      const Eigen::Affine3d pose = MatrixPose(mover.linkFromSensor(moments_[k])).affine;
      motion.link_from_sensor.push_back(pose.matrix().topRows<3>());
      motion.box.extend(boxAt(mover.box(), pose));
      // A step of a nanosecond has no time between its ends.
      const bool has_time = k + 1 < count && moments_[k + 1] - moments_[k] > 1;
      const Mover::Errors errors =
          errorsBetween(mover, moments_[k], moments_[has_time ? k + 1 : k]);
      if (has_time) motion.error = std::max(motion.error, errors.smooth + errors.jump);
      link_error = std::max(link_error, errors.link + errors.stretch);
    }
    motion.link_from_sensor.resize(moments_.size(), motion.link_from_sensor.back());
    motion.box = padded(motion.box, link_error);
  }

  const TransformBuffer& tf_;
  TransformBuffer::Frame sensor_;
  TimeSpan span_;
  double range_;
  std::vector<Mover> movers_;
  std::vector<std::size_t> places_;  ///< of each mover its index among the links
  std::vector<std::int64_t> moments_;
  ScanPoses result_;
};

}  // namespace

ScanPoses scanPoses(const TransformBuffer& tf, TransformBuffer::Frame sensor,
                    const std::vector<ScannedLink>& links, TimeSpan span, double range) {
  return Scan(tf, sensor, span, range).poses(links);
}

void ScanCursor::seek(std::int64_t time) {
  const std::vector<std::int64_t>& moments = poses_.moments;
  if (moments.size() < 2) return;
  const bool is_here =
      moments[moment_] <= time && (moment_ + 1 == moments.size() || time < moments[moment_ + 1]);
  if (!is_here) {
    const auto after = std::upper_bound(moments.begin(), moments.end(), time);
    moment_ = after == moments.begin() ? 0 : static_cast<std::size_t>(after - moments.begin() - 1);
  }
  part_ = 0;
  if (moment_ + 1 < moments.size() && time > moments[moment_]) {
    part_ = static_cast<double>(time - moments[moment_]) /
            static_cast<double>(moments[moment_ + 1] - moments[moment_]);
  }
}

}  // namespace link_bounds
