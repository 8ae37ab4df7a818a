// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Most points are outside the box around all links and are sorted out first. For the others, the
// link of the previous point is tried first, and a coarse grid then gives the links that can be
// there.
#include "world/cloud/robot_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

/// The links that can be at a place in the sensor's frame: a coarse grid over the box around all
/// links. Made for each scan. A point in the box of a link always finds that link.
class LinkCells {
 public:
  struct Links {
    const std::uint32_t* first;
    const std::uint32_t* last;  ///< one past the end
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };

  explicit LinkCells(const ScanPoses& poses);

  /// The links for a point in poses.box, which must not be empty.
  Links at(const Eigen::Vector3d& point) const {
    const std::size_t cell =
        indexOf(placeOf(0, point[0]), placeOf(1, point[1]), placeOf(2, point[2]));
    return {links_.data() + starts_[cell], links_.data() + starts_[cell + 1]};
  }

 private:
  /// Cells along each axis: a cell then has few of the 50 links of a PR2.
  static constexpr std::size_t kCells = 16;

  /// Monotonic even with rounding: a larger coordinate never gets a smaller place.
  std::size_t placeOf(int axis, double coordinate) const {
    const double place = (coordinate - origin_[axis]) * per_cell_[axis];
    return place >= kCells - 1 ? kCells - 1 : place > 0 ? static_cast<std::size_t>(place) : 0;
  }
  static std::size_t indexOf(std::size_t x, std::size_t y, std::size_t z) {
    return (z * kCells + y) * kCells + x;
  }
  template <class Visit>
  void forEachCell(const Aabb& box, const Visit& visit) const;

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d per_cell_ = Eigen::Vector3d::Zero();
  std::array<std::uint32_t, kCells * kCells * kCells + 1> starts_{};  ///< into links_, by cell
  std::vector<std::uint32_t> links_;
};

LinkCells::LinkCells(const ScanPoses& poses) {
  if (poses.box.isEmpty()) return;
  origin_ = poses.box.min();
  for (int k = 0; k < 3; ++k) {
    const double size = poses.box.sizes()[k];
    per_cell_[k] = size > 0 ? kCells / size : 0;
  }
  for (const LinkMotion& link : poses.links)
    forEachCell(link.box, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i)
    starts_[i] += starts_[i - 1];
  links_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < poses.links.size(); ++i)
    forEachCell(poses.links[i].box, [&](std::size_t cell) { links_[next[cell]++] = i; });
}

template <class Visit>
void LinkCells::forEachCell(const Aabb& box, const Visit& visit) const {
  if (box.isEmpty()) return;
  for (std::size_t z = placeOf(2, box.min()[2]); z <= placeOf(2, box.max()[2]); ++z) {
    for (std::size_t y = placeOf(1, box.min()[1]); y <= placeOf(1, box.max()[1]); ++y) {
      for (std::size_t x = placeOf(0, box.min()[0]); x <= placeOf(0, box.max()[0]); ++x)
        visit(indexOf(x, y, z));
    }
  }
}

/// Whether the straight line from `from` to `to` meets the box, which must not be empty.
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

/// The links that cast a shadow: those with a box in whose shape the sensor's origin never lies.
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

/// Data that all threads share.
struct Plan {
  explicit Plan(const PointQuery& asked)
      : query(asked), cells(asked.poses), shadow_links(shadowLinks(asked)) {}

  const PointQuery& query;
  LinkCells cells;
  std::vector<std::size_t> shadow_links;
};

/// Labels a range of points on one thread.
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
    // Rounding is monotonic, so it excludes no point of the box.
    const Eigen::Matrix<Number, 3, 1> low = low_.cast<Number>(), high = high_.cast<Number>();
    for (std::size_t i = begin; i < end; ++i, bytes += points.point_step) {
      const auto x = CloudPoints::read<Number>(bytes + points.x);
      const auto y = CloudPoints::read<Number>(bytes + points.y);
      const auto z = CloudPoints::read<Number>(bytes + points.z);
      // `&` instead of `&&`: one branch per point.
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

  /// Checks a point that is on no link for min_distance and for shadows.
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
  Eigen::Vector3d low_, high_;  ///< corners of the box around all links
  double min_squared_;
  ScanCursor cursor_;
  std::size_t last_ = kTooNear;  ///< the link of the last point that had one
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
