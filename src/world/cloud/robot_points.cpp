// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Most points are outside the box around all links; of the others, neighbours are mostly of one
// link, and a coarse grid says which others can be there.
#include "world/cloud/robot_points.h"

#include <algorithm>
#include <cmath>

#include "robot/threads/row_threads.h"
#include "world/cloud/link_cells.h"

namespace link_bounds {
namespace {

/// Whether the straight way from `from` to `to` meets the box, which must not be empty.
bool meets(const Aabb& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  double begin = 0, end = 1;
  for (int k = 0; k < 3; ++k) {
    const double step = to[k] - from[k];
    if (step == 0) {
      if (from[k] < box.min()[k] || from[k] > box.max()[k]) return false;
      continue;
    }
    const auto [near, far] =
        std::minmax({(box.min()[k] - from[k]) / step, (box.max()[k] - from[k]) / step});
    begin = std::max(begin, near);
    end = std::min(end, far);
  }
  return begin <= end;
}

/// The links that throw a shadow.
std::vector<std::size_t> shadowLinks(const PointQuery& query) {
  std::vector<std::size_t> result;
  if (!query.with_shadow) return result;
  for (std::size_t i = 0; i < query.grids.size(); ++i) {
    const LinkMotion& motion = query.poses.links[i];
    const BodyGrid& grid = *query.grids[i];
    const auto holdsSensor = [&](const auto& pose) {
      return grid.isBody(pose.col(3), motion.error);
    };
    if (!motion.box.isEmpty() &&
        std::none_of(motion.link_from_sensor.begin(), motion.link_from_sensor.end(), holdsSensor))
      result.push_back(i);
  }
  return result;
}

/// What all threads share.
struct Plan {
  explicit Plan(const PointQuery& asked)
      : query(asked), cells(asked.poses), shadow_links(shadowLinks(asked)) {}

  const PointQuery& query;
  LinkCells cells;
  std::vector<std::size_t> shadow_links;
};

/// A run of points on one thread.
class Labels {
 public:
  explicit Labels(const Plan& plan)
      : query_(plan.query),
        cells_(plan.cells),
        shadow_links_(plan.shadow_links),
        low_(query_.poses.box.min()),
        high_(query_.poses.box.max()),
        min_squared_(query_.min_distance * query_.min_distance),
        cursor_(query_.poses) {}

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
    const bool looks_at_all = min_squared_ > 0 || !shadow_links_.empty();
    // Rounding keeps the order of numbers, so no point of the box is left out.
    const Eigen::Matrix<Number, 3, 1> low = low_.cast<Number>(), high = high_.cast<Number>();
    for (std::size_t i = begin; i < end; ++i, bytes += points.point_step) {
      const auto x = CloudPoints::read<Number>(bytes + points.x);
      const auto y = CloudPoints::read<Number>(bytes + points.y);
      const auto z = CloudPoints::read<Number>(bytes + points.z);
      // Not short-circuited: one branch a point.
      const int is_candidate = int{x >= low.x()} & int{x <= high.x()} & int{y >= low.y()} &
                               int{y <= high.y()} & int{z >= low.z()} & int{z <= high.z()};
      if (is_candidate != 0) {
        look(i, {x, y, z}, bytes);
      } else if (looks_at_all) {
        lookFurther(i, {x, y, z}, bytes);
      }
    }
  }

  void look(std::size_t index, const Eigen::Vector3d& point, const std::uint8_t* bytes) {
    if (query_.poses.moments.size() > 1) cursor_.seek(query_.points.timeOf(bytes));
    if (last_ != kTooNear && isOf(last_, point)) {
      found_.push_back({index, last_});
      return;
    }
    for (const std::uint32_t link : cells_.at(point)) {
      if (!isOf(link, point)) continue;
      found_.push_back({index, link});
      last_ = link;
      return;
    }
    lookFurther(index, point, bytes);
  }

  /// At a point of no link.
  void lookFurther(std::size_t index, const Eigen::Vector3d& point, const std::uint8_t* bytes) {
    if (point.squaredNorm() < min_squared_) {
      found_.push_back({index, kTooNear});
    } else if (!shadow_links_.empty()) {
      lookForShadow(index, point, bytes);
    }
  }

  bool isOf(std::size_t link, const Eigen::Vector3d& point) const {
    const LinkMotion& motion = query_.poses.links[link];
    return motion.box.contains(point) &&
           query_.grids[link]->isBody(cursor_.inLink(motion, point), motion.error);
  }

  void lookForShadow(std::size_t index, const Eigen::Vector3d& point, const std::uint8_t* bytes) {
    const double range = point.norm();
    if (!(range > query_.min_distance && std::isfinite(range))) return;
    cursor_.seek(query_.points.timeOf(bytes));
    const Eigen::Vector3d begin = query_.min_distance / range * point;
    for (const std::size_t link : shadow_links_) {
      const LinkMotion& motion = query_.poses.links[link];
      if (!meets(motion.box, begin, point)) continue;
      if (!query_.grids[link]->surface().crosses(cursor_.inLink(motion, begin),
                                                 cursor_.inLink(motion, point)))
        continue;
      found_.push_back({index, link});
      return;
    }
  }

  const PointQuery& query_;
  const LinkCells& cells_;
  const std::vector<std::size_t>& shadow_links_;
  Eigen::Vector3d low_, high_;  ///< of the box around all links
  double min_squared_;
  ScanCursor cursor_;
  std::size_t last_ = kTooNear;  ///< the link that was met last
  std::vector<RobotPoint> found_;
};

}  // namespace

std::vector<RobotPoint> robotPoints(const PointQuery& query, std::size_t threads) {
  const std::size_t size = query.points.size();
  const std::size_t parts = std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(size, 1));
  const Plan plan(query);
  std::vector<std::vector<RobotPoint>> found(parts);
  forRows(0, parts, static_cast<unsigned>(parts), 1, [&](unsigned, std::size_t i, std::size_t) {
    found[i] = Labels(plan).of(size * i / parts, size * (i + 1) / parts);
  });
  std::vector<RobotPoint> result = std::move(found.front());
  for (std::size_t i = 1; i < parts; ++i)
    result.insert(result.end(), found[i].begin(), found[i].end());
  return result;
}

}  // namespace link_bounds
