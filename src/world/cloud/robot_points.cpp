// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Most points are outside the box around all links; of the others, neighbours are mostly of one
// link.
#include "world/cloud/robot_points.h"

#include <algorithm>
#include <future>

namespace link_bounds {
namespace {

/// A run of points on one thread.
class Labels {
 public:
  explicit Labels(const PointQuery& query)
      : query_(query),
        box_(query.poses.box),
        min_squared_(query.min_distance * query.min_distance) {
    for (std::size_t i = 0; i < query.grids.size(); ++i) {
      if (!query.poses.links[i].box.isEmpty()) order_.push_back(i);
    }
  }

  std::vector<RobotPoint> of(std::size_t begin, std::size_t end) {
    const CloudPoints& points = query_.points;
    for (std::size_t i = begin; i < end;) {
      const std::size_t row_end =
          points.height == 1 ? end : std::min(end, (i / points.width + 1) * points.width);
      const std::uint8_t* bytes = points.point(i);
      if (points.is_double) {
        scan<double>(bytes, i, row_end);
      } else {
        scan<float>(bytes, i, row_end);
      }
      i = row_end;
    }
    return std::move(found_);
  }

 private:
  template <class Number>
  void scan(const std::uint8_t* bytes, std::size_t begin, std::size_t end) {
    const CloudPoints& points = query_.points;
    const Eigen::Vector3d low = box_.isEmpty() ? Eigen::Vector3d::Constant(1) : box_.min();
    const Eigen::Vector3d high = box_.isEmpty() ? Eigen::Vector3d::Constant(-1) : box_.max();
    for (std::size_t i = begin; i < end; ++i, bytes += points.point_step) {
      const double x = CloudPoints::read<Number>(bytes + points.x);
      const double y = CloudPoints::read<Number>(bytes + points.y);
      const double z = CloudPoints::read<Number>(bytes + points.z);
      // Not short-circuited: one branch a point.
      const int is_candidate = int{x >= low.x()} & int{x <= high.x()} & int{y >= low.y()} &
                               int{y <= high.y()} & int{z >= low.z()} & int{z <= high.z()};
      if (is_candidate != 0) {
        look(i, {x, y, z}, bytes);
      } else if (min_squared_ > 0 && x * x + y * y + z * z < min_squared_) {
        found_.push_back({i, kTooNear});
      }
    }
  }

  void look(std::size_t index, const Eigen::Vector3d& point, const std::uint8_t* bytes) {
    if (query_.poses.moments.size() > 1) seek(query_.points.timeOf(bytes));
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (!isOf(order_[i], point)) continue;
      found_.push_back({index, order_[i]});
      std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(i),
                  order_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return;
    }
    if (point.squaredNorm() < min_squared_) found_.push_back({index, kTooNear});
  }

  bool isOf(std::size_t link, const Eigen::Vector3d& point) const {
    const LinkMotion& motion = query_.poses.links[link];
    if (!motion.box.contains(point)) return false;
    const auto& pose = motion.link_from_sensor[moment_];
    Eigen::Vector3d in_link = pose.leftCols<3>() * point + pose.col(3);
    if (part_ > 0) {
      const auto& next = motion.link_from_sensor[moment_ + 1];
      in_link += part_ * (next.leftCols<3>() * point + next.col(3) - in_link);
    }
    return query_.grids[link]->isBody(in_link, motion.error);
  }

  /// The two moments around that time; most points follow the last one in time.
  void seek(std::int64_t time) {
    const std::vector<std::int64_t>& moments = query_.poses.moments;
    const auto isHere = [&] {
      return moments[moment_] <= time &&
             (moment_ + 1 == moments.size() || time < moments[moment_ + 1]);
    };
    if (!isHere()) {
      const auto after = std::upper_bound(moments.begin(), moments.end(), time);
      moment_ =
          after == moments.begin() ? 0 : static_cast<std::size_t>(after - moments.begin() - 1);
    }
    part_ = 0;
    if (moment_ + 1 < moments.size() && time > moments[moment_]) {
      part_ = static_cast<double>(time - moments[moment_]) /
              static_cast<double>(moments[moment_ + 1] - moments[moment_]);
    }
  }

  const PointQuery& query_;
  const Aabb& box_;
  double min_squared_;
  std::vector<std::size_t> order_;  ///< links, the last one that was met first
  std::size_t moment_ = 0;
  double part_ = 0;  ///< of the way to the next moment
  std::vector<RobotPoint> found_;
};

}  // namespace

std::vector<RobotPoint> robotPoints(const PointQuery& query, std::size_t threads) {
  const std::size_t size = query.points.size();
  const std::size_t parts = std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(size, 1));
  std::vector<std::future<std::vector<RobotPoint>>> others;
  for (std::size_t i = 1; i < parts; ++i) {
    others.push_back(std::async(std::launch::async, [&query, size, parts, i] {
      return Labels(query).of(size * i / parts, size * (i + 1) / parts);
    }));
  }
  std::vector<RobotPoint> result = Labels(query).of(0, size / parts);
  for (auto& other : others) {
    const std::vector<RobotPoint> found = other.get();
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

}  // namespace link_bounds
