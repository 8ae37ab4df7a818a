// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that follow each other form runs, each with a box. For each link, runs are searched in the
// order of their boxes' distance, until a box is farther than the best point.
#include "world/cloud/nearest_points.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "world/tf/tf2_pose.h"

namespace link_bounds {
namespace {

/// With this, a cloud of 640 x 480 has 4,800 runs, which are sorted for each link.
constexpr std::size_t kPointsPerRun = 64;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double boxDistance(const Aabb& box, const Eigen::Vector3d& point) {
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0).norm();
}

double boxDistance(const Aabb& a, const Aabb& b) {
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0.0).norm();
}

/// The points that are not removed, in runs.
class Runs {
 public:
  struct Run {
    std::size_t begin = 0, end = 0;  ///< indices for point()
    Aabb box;
  };
  struct Point {
    Eigen::Vector3d place;
    std::size_t index;
  };

  explicit Runs(const NearestQuery& query) {
    const CloudPoints& points = query.points;
    auto removed = query.removed.begin();
    points.forEach([&](std::size_t i, const std::uint8_t* bytes) {
      if (removed != query.removed.end() && removed->point == i) {
        ++removed;
        return;
      }
      const Eigen::Vector3d place = points.position(bytes);
      if (place.norm() <= kMaxPointRange) add({place, i});
    });
  }

  const std::vector<Run>& runs() const { return runs_; }
  const Point& point(std::size_t i) const { return points_[i]; }
  double range() const { return range_; }

  TimeSpan span(const CloudPoints& points) const {
    TimeSpan result{points.stamp, points.stamp};
    for (std::size_t i = 0; points.time && i < points_.size(); ++i) {
      const std::int64_t time = points.timeOf(points.point(points_[i].index));
      result = i == 0 ? TimeSpan{time, time}
                      : TimeSpan{std::min(result.begin, time), std::max(result.end, time)};
    }
    return result;
  }

 private:
  void add(const Point& point) {
    if (points_.size() % kPointsPerRun == 0) {
      runs_.emplace_back();
      runs_.back().begin = points_.size();
    }
    points_.push_back(point);
    runs_.back().end = points_.size();
    runs_.back().box.extend(point.place);
    range_ = std::max(range_, point.place.norm());
  }

  std::vector<Point> points_;
  std::vector<Run> runs_;
  double range_ = 0;
};

/// Finds the point that is nearest to one link.
class Search {
 public:
  Search(const NearestQuery& query, const Runs& runs, const ScanPoses& poses, std::size_t link)
      : query_(query),
        runs_(runs),
        motion_(poses.links[link]),
        surface_(query.grids[link]->surface()),
        frame_(query.links[link].frame),
        cursor_(poses) {}

  std::optional<NearestPoint> run() {
    if (motion_.box.isEmpty()) return std::nullopt;
    std::vector<std::pair<double, const Runs::Run*>> order;
    for (const Runs::Run& run : runs_.runs())
      order.emplace_back(boxDistance(motion_.box, run.box), &run);
    std::sort(order.begin(), order.end());
    for (const auto& [distance, run] : order) {
      if (distance >= best_.lower) break;
      for (std::size_t i = run->begin; i < run->end; ++i)
        look(runs_.point(i));
    }
    return result();
  }

 private:
  /// `best_.lower` bounds all points so far, because skipped points are farther away.
  void look(const Runs::Point& point) {
    const std::uint8_t* bytes = query_.points.point(point.index);
    if (query_.points.time) cursor_.seek(query_.points.timeOf(bytes));
    const Eigen::Vector3d place = cursor_.inLink(motion_, point.place);
    if (boxDistance(surface_.box(), place) >= best_.lower) return;
    const PointDistance found = surface_.distance(place, best_.lower, -1, &hint_);
    best_.lower = std::min(best_.lower, found.lower);
    if (!(found.upper < best_.upper)) return;
    best_.upper = found.upper;
    nearest_ = &point;
  }

  /// Measures the nearest point again, in the pose that tf2 gives for its own time.
  std::optional<NearestPoint> result() const {
    if (!nearest_) return std::nullopt;
    const std::int64_t stamp = query_.points.timeOf(query_.points.point(nearest_->index));
    const auto pose = query_.tf.pose(frame_, query_.sensor, stamp);
    if (!pose) return std::nullopt;
    const Eigen::Affine3d link_from_sensor = MatrixPose(*pose).affine;
    const SurfacePoint found = surface_.nearest(link_from_sensor * nearest_->place);
    const Eigen::Vector3d on_link = link_from_sensor.inverse() * found.on_body;
    const double lower = std::max(best_.lower - motion_.error - kRounding, 0.0);
    const double upper = std::max((nearest_->place - on_link).norm(), lower);
    return NearestPoint{nearest_->index, stamp,           lower,           upper,
                        on_link,         nearest_->place, found.is_of_mesh};
  }

  static constexpr double kRounding = 1e-11;  ///< of places up to kMaxPointRange [m]

  const NearestQuery& query_;
  const Runs& runs_;
  const LinkMotion& motion_;
  const BodySurface& surface_;
  TransformBuffer::Frame frame_;
  ScanCursor cursor_;
  BodySurface::Hint hint_;
  PointDistance best_{kInfinity, kInfinity};
  const Runs::Point* nearest_ = nullptr;
};

}  // namespace

NearestPoints nearestPoints(const NearestQuery& query) {
  NearestPoints result;
  result.links.resize(query.links.size());
  const Runs runs(query);
  if (runs.runs().empty()) return result;
  const ScanPoses poses =
      scanPoses(query.tf, query.sensor, query.links, runs.span(query.points), runs.range());
  result.problem = poses.problem;
  if (!poses.problem.empty()) return result;
  for (std::size_t i = 0; i < query.links.size(); ++i)
    result.links[i] = Search(query, runs, poses, i).run();
  return result;
}

}  // namespace link_bounds
