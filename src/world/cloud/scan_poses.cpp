// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/cloud/scan_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/history/motion_path.h"

namespace link_bounds {
namespace {

/// Max time between the points of a scan; typical scans take 0.1 s.
constexpr std::int64_t kMaxSpan = 5000000000;  // ns

/// Max number of moments. At one moment, the poses of 50 links take about 20 us.
constexpr std::size_t kMaxMoments = 1000;

/// Min step between moments [ns]. Rounding up to whole nanoseconds makes a step longer by max 1/20.
/// The 10 % that partsFor() reserves cover that.
constexpr double kMinStep = 20;

/// Max rounding error of a box, relative to its largest coordinate, and its min value [m].
constexpr double kPlaceRounding = 1e-12;
constexpr double kFloor = 1e-9;

constexpr double kTooMany = std::numeric_limits<double>::infinity();

/// The box of the link in the sensor's frame at one pose, padded by the max rounding error.
Aabb boxAt(const Aabb& link_box, const Eigen::Affine3d& link_from_sensor) {
  const Eigen::Affine3d sensor_from_link = link_from_sensor.inverse(Eigen::Isometry);
  const Eigen::Vector3d center = sensor_from_link * link_box.center();
  const Eigen::Vector3d half = sensor_from_link.linear().cwiseAbs() * (link_box.sizes() / 2);
  const double size =
      link_from_sensor.translation().norm() + link_box.sizes().norm() + link_box.center().norm();
  return padded(Aabb(center - half, center + half), kFloor + kPlaceRounding * size);
}

double largestNorm(const Aabb& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

/// How far a link, and a point of it in the link's frame, leave the straight line between two
/// times.
struct Errors {
  Bulge of_point;
  Bulge of_link;   ///< in the sensor's frame
  double stretch;  ///< of the link at any time, as quaternions are not of length 1 [m]
};

/// A link that may move relative to the sensor.
class Mover {
 public:
  Mover(TransformBuffer::Frame frame, MotionPath path, const Aabb& box)
      : frame_(frame), path_(std::move(path)), box_(box) {
    for (const Eigen::Vector3d& corner : corners(box))
      radius_ = std::max(radius_, corner.norm());
  }

  /// Its current samples are those around the time of the last seek().
  MotionPath& path() { return path_; }
  const MotionPath& path() const { return path_; }

  Eigen::Affine3d linkFromSensor(std::int64_t time) const {
    return MatrixPose(path_.targetFromSource(time)).affine;
  }

  /// The errors between `begin`, which must be the last time of seek(), and `end`, which is not
  /// after the next sample. They also hold for points within `range` of the sensor. `steps` is
  /// scratch memory.
  Errors errors(std::int64_t begin, std::int64_t end, double range, PathSteps& steps) const {
    const Eigen::Affine3d from = linkFromSensor(begin), to = linkFromSensor(end);
    const double distance = std::max(from.translation().norm(), to.translation().norm());
    double scale = 1, lengths = radius_;
    fillSteps(path_.from_target, end - begin, steps.from_link);
    fillSteps(path_.from_source, end - begin, steps.from_target);
    for (const auto* edges : {&steps.from_link, &steps.from_target}) {
      for (const EdgeStep& step : *edges) {
        scale *= std::max(step.length2, 1 / step.min_length2);
        lengths += step.distance;
      }
    }
    const Bulge of_link = bulge(steps, radius_, distance);
    const double stretch = 2 * std::max(scale - 1, 0.0) * scale * lengths;
    // Bounds the distance of the link from the sensor: its boxes at both ends and the motion
    // between.
    const double far_end = largestNorm(boxAt(box_, from).merged(boxAt(box_, to))) + of_link.smooth +
                           of_link.jump + stretch;
    std::swap(steps.from_link, steps.from_target);
    return {bulge(steps, std::max(far_end, range), distance), of_link, stretch};
  }

  const Aabb& box() const { return box_; }
  TransformBuffer::Frame frame() const { return frame_; }

 private:
  TransformBuffer::Frame frame_;
  MotionPath path_;
  Aabb box_;
  double radius_ = 0;  ///< of a ball around the link's origin that contains the box
};

class Scan {
 public:
  Scan(const TransformBuffer& tf, TransformBuffer::Frame sensor, TimeSpan span, double range,
       double timeout)
      : tf_(tf), sensor_(sensor), span_(span), range_(range), timeout_(timeout) {}

  ScanPoses poses(const std::vector<ScannedLink>& links) {
    if (span_.end - span_.begin > kMaxSpan) {
      result_.problem = "its points are from more than 5 s; correct the field of times";
      return result_;
    }
    if (!findPaths(links)) return result_;
    const std::vector<std::int64_t> samples = timesOfSamples();
    errors_.resize(movers_.size());
    link_errors_.resize(movers_.size());
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      if (!follow(samples[k], samples[k + 1], samples.size() - k)) return result_;
    }
    finish(samples.size() == 1);
    return std::move(result_);
  }

 private:
  bool findPaths(const std::vector<ScannedLink>& links) {
    result_.links.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links[i].box.isEmpty()) continue;
      MotionPath path =
          pathBetween(tf_, links[i].frame, sensor_, {span_.begin, span_.end}, timeout_);
      if (!path.problem.empty()) {
        result_.problem = path.problem;
        result_.may_come = true;
        return false;
      }
      movers_.emplace_back(links[i].frame, std::move(path), links[i].box);
      motions_.push_back(&result_.links[i]);
    }
    return true;
  }

  /// The times of all samples within the span, and both ends of the span; ascending.
  std::vector<std::int64_t> timesOfSamples() const {
    std::vector<std::int64_t> times{span_.begin, span_.end};
    for (const Mover& mover : movers_)
      mover.path().addSampleTimes({span_.begin, span_.end}, times);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  /// Covers the time from one sample to the next one. An edge that jumps between them does so in
  /// the last nanosecond.
  bool follow(std::int64_t begin, std::int64_t end, std::size_t left) {
    if (end - begin < 2 || !jumpsAfter(begin)) return followStep(begin, end, left);
    return followStep(begin, end - 1, left + 1) && followStep(end - 1, end, left);
  }

  /// Whether an edge jumps, instead of moving along a line, between this sample and the next one.
  bool jumpsAfter(std::int64_t begin) {
    return std::any_of(movers_.begin(), movers_.end(), [&](Mover& mover) {
      if (!mover.path().isMoving()) return false;
      mover.path().seek(begin);
      return mover.path().isSudden();
    });
  }

  /// Adds as many moments as keep the errors small. False if there would be too many, counting the
  /// `left` further moments that are needed at least.
  bool followStep(std::int64_t begin, std::int64_t end, std::size_t left) {
    const std::int64_t duration = end - begin;
    double parts = partsBetween(begin, end);
    // Times are whole nanoseconds. Parts of a few nanoseconds would differ too much in length.
    const auto nanoseconds = static_cast<double>(duration);
    if (duration == 1 || (std::isfinite(parts) && kMinStep * parts > nanoseconds && parts > 1))
      parts = nanoseconds;
    if (!(parts + static_cast<double>(result_.moments.size() + left) <= kMaxMoments)) {
      result_.problem =
          "the robot or the sensor moves so fast that a thousand poses are too few; look at tf";
      return false;
    }
    const auto count = static_cast<std::int64_t>(parts);
    for (std::int64_t i = 0; i < count; ++i) {
      if (!addMoment(begin + duration * i / count)) return false;
    }
    keepErrors((duration + count - 1) / count, duration);
    return true;
  }

  /// The number of parts into which this time has to be divided; infinite if no number suffices.
  double partsBetween(std::int64_t begin, std::int64_t end) {
    double parts = 1;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      Mover& mover = movers_[i];
      if (!mover.path().isMoving() && !result_.moments.empty()) continue;
      mover.path().seek(begin);
      errors_[i] = mover.errors(begin, end, range_, steps_);
      if (mover.path().isMoving())
        parts =
            std::max(parts, mover.path().isAmbiguous() ? kTooMany : partsFor(errors_[i].of_point));
    }
    return parts;
  }

  static double partsFor(const Bulge& error) {
    const double allowed = 0.9 * kMaxMotionError - error.jump;
    if (!(allowed > 0) || !std::isfinite(error.smooth)) return kTooMany;
    return std::max(std::ceil(std::sqrt(error.smooth / allowed)), 1.0);
  }

  /// Keeps the max errors between two moments, which are max `step` [ns] apart. If `step` is 1,
  /// there is no time between them.
  void keepErrors(std::int64_t step, std::int64_t duration) {
    const bool has_time = step > 1;
    const double part = has_time ? static_cast<double>(step) / static_cast<double>(duration) : 0;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      const Errors& errors = errors_[i];
      link_errors_[i] = std::max(link_errors_[i], errors.of_link.in(part) + errors.stretch);
      if (has_time && movers_[i].path().isMoving())
        motions_[i]->error = std::max(motions_[i]->error, errors.of_point.in(part));
    }
  }

  /// `time` must be in the step that began at the last seek(). False for a pose that is not finite:
  /// the points of the link are then unknown.
  bool addMoment(std::int64_t time) {
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      LinkMotion& motion = *motions_[i];
      if (!movers_[i].path().isMoving() && !result_.moments.empty()) continue;
      const Eigen::Affine3d pose = movers_[i].linkFromSensor(time);
      if (!pose.matrix().allFinite()) {
        result_.problem = "the pose of frame \"" + tf_.name(movers_[i].frame()) +
                          "\" is not finite; correct the publishers of its transforms";
        return false;
      }
      motion.link_from_sensor.push_back(pose.matrix().topRows<3>());
      motion.box.extend(boxAt(movers_[i].box(), pose));
    }
    result_.moments.push_back(time);
    return true;
  }

  /// Adds the last moment, which may be the only one.
  void finish(bool is_only) {
    if (is_only) {
      partsBetween(span_.end, span_.end);
      keepErrors(0, 1);
    }
    for (Mover& mover : movers_)
      mover.path().seek(span_.end);
    if (!addMoment(span_.end)) return;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      LinkMotion& motion = *motions_[i];
      motion.link_from_sensor.resize(result_.moments.size(), motion.link_from_sensor.back());
      motion.box = padded(motion.box, link_errors_[i]);
      result_.box.extend(motion.box);
    }
  }

  const TransformBuffer& tf_;
  TransformBuffer::Frame sensor_;
  TimeSpan span_;
  double range_;
  double timeout_;
  std::vector<Mover> movers_;
  std::vector<LinkMotion*> motions_;  ///< the result of each mover
  std::vector<Errors> errors_;        ///< of each mover between the current two samples
  std::vector<double> link_errors_;   ///< the max error of each mover's box [m]
  PathSteps steps_;
  ScanPoses result_;
};

}  // namespace

ScanPoses scanPoses(const TransformBuffer& tf, TransformBuffer::Frame sensor,
                    const std::vector<ScannedLink>& links, TimeSpan span, double range,
                    double timeout) {
  return Scan(tf, sensor, span, range, timeout).poses(links);
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
