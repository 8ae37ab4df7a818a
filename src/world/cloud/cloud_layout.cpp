// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All sizes and offsets in the message are checked before they are used.
#include "world/cloud/cloud_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr double kMaxNanoseconds = 9e18;  // must fit into 64 bits
constexpr double kMinNanoseconds = 1e3;   // smaller numbers: seconds of a clock that just began
constexpr double kMaxRelative = 1e9;      // s; tf covers no such time, and larger values overflow

/// If a cloud has several of these fields, the first one in this order counts.
constexpr std::array<const char*, 4> kTimeFields{"t", "offset_time", "time", "timestamp"};

const PointField* find(const PointCloud2& cloud, const std::string& name) {
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&](const PointField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

std::optional<NumberType> typeOf(const PointField& field) {
  switch (field.datatype) {
    case PointField::FLOAT32:
      return NumberType::kFloat32;
    case PointField::FLOAT64:
      return NumberType::kFloat64;
    case PointField::INT32:
      return NumberType::kInt32;
    case PointField::UINT32:
      return NumberType::kUint32;
    default:
      return std::nullopt;
  }
}

std::string numbers(std::uint64_t a, const std::string& words, std::uint64_t b) {
  return std::to_string(a) + words + std::to_string(b);
}

/// Why the sizes in the message contradict each other or its data; "" if they do not.
std::string problemOfSizes(const PointCloud2& cloud) {
  const std::uint64_t width = cloud.width, height = cloud.height;
  if (cloud.is_bigendian)
    return "its numbers are big-endian; publish little-endian ones, as drivers on PCs do";
  if (cloud.point_step == 0) return "point_step is 0; set it to the bytes of a point";
  if (cloud.row_step < width * cloud.point_step)
    return numbers(cloud.row_step, " bytes of row_step are less than width times point_step, ",
                   width * cloud.point_step) +
           "; correct row_step, point_step or width";
  if (cloud.data.size() < height * cloud.row_step)
    return numbers(cloud.data.size(), " bytes of data are less than height times row_step, ",
                   height * cloud.row_step) +
           "; correct row_step or height, or send all data";
  if (cloud.data.size() > height * cloud.row_step)
    return numbers(cloud.data.size(), " bytes of data are more than height times row_step, ",
                   height * cloud.row_step) +
           "; correct row_step or height";
  return "";
}

/// Sets `number`, or returns why the field cannot be read.
std::string readField(const PointCloud2& cloud, const PointField& field, NumberField& number) {
  const std::string what = "field " + field.name;
  const auto type = typeOf(field);
  if (!type)
    return what + " has datatype " + std::to_string(field.datatype) +
           "; send FLOAT32 or FLOAT64, or for a time also INT32 or UINT32";
  const std::uint64_t size = *type == NumberType::kFloat64 ? 8 : 4;
  if (field.offset + size > cloud.point_step)
    return what + " ends at byte " +
           numbers(field.offset + size, " of a point, but point_step is ", cloud.point_step) +
           "; correct its offset or point_step";
  number = {field.offset, *type};
  return "";
}

std::string readCoordinates(const PointCloud2& cloud, CloudPoints& points) {
  std::array<NumberField, 3> fields;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name(1, "xyz"[k]);
    const PointField* field = find(cloud, name);
    if (!field) return "it has no field " + name + "; send x, y and z";
    const std::string problem = readField(cloud, *field, fields[k]);
    if (!problem.empty()) return problem;
    const NumberType type = fields[k].type;
    if (type != fields[0].type || type == NumberType::kInt32 || type == NumberType::kUint32)
      return "fields x, y and z are not all FLOAT32 or all FLOAT64; send one of these types";
  }
  points.x = fields[0].offset;
  points.y = fields[1].offset;
  points.z = fields[2].offset;
  points.is_double = fields[0].type == NumberType::kFloat64;
  return "";
}

std::string readTime(const PointCloud2& cloud, CloudPoints& points) {
  for (const char* name : kTimeFields) {
    const PointField* field = find(cloud, name);
    if (!field) continue;
    NumberField number{};
    std::string problem = readField(cloud, *field, number);
    if (problem.empty()) points.time = number;
    return problem;
  }
  return "";
}

/// `stamp` if `seconds` is not finite.
std::int64_t fromRelative(double seconds, std::int64_t stamp) {
  if (!std::isfinite(seconds)) return stamp;
  return stamp + std::llround(std::clamp(seconds, -kMaxRelative, kMaxRelative) * 1e9);
}

/// Reads `value` as seconds after the stamp, seconds of ROS time or nanoseconds of ROS time:
/// whichever is nearest to the stamp, however far off, so that tf refuses nonsense. Not finite:
/// `stamp`.
std::int64_t fromNumber(double value, std::int64_t stamp) {
  if (!std::isfinite(value)) return stamp;
  const double stamp_seconds = static_cast<double>(stamp) * 1e-9;
  const double as_relative = std::abs(value);
  const double as_seconds = std::abs(value - stamp_seconds);
  const double as_nanoseconds = std::abs(value) < kMinNanoseconds
                                    ? std::numeric_limits<double>::infinity()
                                    : std::abs(value * 1e-9 - stamp_seconds);
  if (as_relative <= std::min(as_seconds, as_nanoseconds)) return stamp + std::llround(value * 1e9);
  if (as_seconds <= as_nanoseconds) {
    // Converts whole seconds and fraction apart: as a double, nanoseconds would lose digits.
    const double seconds = std::floor(value);
    return static_cast<std::int64_t>(seconds) * 1000000000 + std::llround((value - seconds) * 1e9);
  }
  return static_cast<std::int64_t>(std::clamp(value, 0.0, kMaxNanoseconds));
}

/// The min and max of the times that `read` returns, of points with finite coordinates. If there is
/// no such point, the first is larger. As a template it takes a third of the instructions of a loop
/// that checks the types of coordinates and times at each point.
template <class Coordinate, class Read>
auto timesOf(const CloudPoints& points, const Read& read) {
  using Time = decltype(read(points.data));
  std::pair<Time, Time> times{std::numeric_limits<Time>::max(),
                              std::numeric_limits<Time>::lowest()};
  points.forEach([&](std::size_t, const std::uint8_t* bytes) {
    const Coordinate sum = CloudPoints::read<Coordinate>(bytes + points.x) +
                           CloudPoints::read<Coordinate>(bytes + points.y) +
                           CloudPoints::read<Coordinate>(bytes + points.z);
    // A sum is finite only if all terms are; if it overflows, the point is nowhere real either.
    if (!std::isfinite(sum)) return;
    const Time time = read(bytes);
    times.first = std::min(times.first, time);
    times.second = std::max(times.second, time);
  });
  return times;
}

template <class Coordinate>
std::optional<TimeSpan> spanOf(const CloudPoints& points) {
  const auto spanBy = [&](std::int64_t base, const auto& read) -> std::optional<TimeSpan> {
    const auto [first, last] = timesOf<Coordinate>(points, read);
    if (first > last) return std::nullopt;
    return TimeSpan{base + first, base + last};
  };
  const std::size_t offset = points.time->offset;
  switch (points.time->type) {
    case NumberType::kUint32:
      return spanBy(points.stamp, [=](const std::uint8_t* bytes) {
        return CloudPoints::read<std::uint32_t>(bytes + offset);
      });
    case NumberType::kInt32:
      return spanBy(points.stamp, [=](const std::uint8_t* bytes) {
        return CloudPoints::read<std::int32_t>(bytes + offset);
      });
    default:
      return spanBy(0, [&](const std::uint8_t* bytes) { return points.timeOf(bytes); });
  }
}

}  // namespace

std::int64_t CloudPoints::timeOf(const std::uint8_t* bytes) const {
  if (!time) return stamp;
  const std::uint8_t* at = bytes + time->offset;
  switch (time->type) {
    case NumberType::kUint32:
      return stamp + read<std::uint32_t>(at);
    case NumberType::kInt32:
      return stamp + read<std::int32_t>(at);
    case NumberType::kFloat32:
      return fromRelative(read<float>(at), stamp);
    case NumberType::kFloat64:
      return fromNumber(read<double>(at), stamp);
    case NumberType::kRelativeSeconds:
      return fromRelative(read<double>(at), stamp);
  }
  return stamp;
}

CloudLayout layoutOf(const PointCloud2& cloud) {
  CloudLayout result;
  CloudPoints& points = result.points;
  points.stamp = nanosecondsOf(cloud.header.stamp);
  if (cloud.width == 0 || cloud.height == 0) {
    points.height = 1;
    if (!cloud.data.empty())
      result.problem =
          std::to_string(cloud.data.size()) +
          " bytes of data belong to no point, because width or height is 0; correct them";
    return result;
  }
  result.problem = problemOfSizes(cloud);
  if (result.problem.empty()) result.problem = readCoordinates(cloud, points);
  if (result.problem.empty()) result.problem = readTime(cloud, points);
  if (!result.problem.empty()) return result;
  points.data = cloud.data.data();
  points.width = cloud.width;
  points.height = cloud.height;
  points.point_step = cloud.point_step;
  points.row_step = cloud.row_step;
  return result;
}

std::optional<TimeSpan> timeSpan(const CloudPoints& points) {
  if (points.size() == 0) return std::nullopt;
  if (!points.time) return TimeSpan{points.stamp, points.stamp};
  return points.is_double ? spanOf<double>(points) : spanOf<float>(points);
}

std::string problemOf(const sensor_msgs::LaserScan& scan) {
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment) ||
      !std::isfinite(scan.time_increment))
    return "angle_min, angle_increment or time_increment is not finite; correct it";
  if (!(scan.range_min <= scan.range_max) || !(scan.range_max > 0))
    return "range_min or range_max is no number, or no range is between them; correct them";
  return "";
}

LaserPoints::LaserPoints(const sensor_msgs::LaserScan& scan) {
  points_.height = 1;
  points_.stamp = nanosecondsOf(scan.header.stamp);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  memory_.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto number = static_cast<double>(i);
    const double angle = scan.angle_min + number * scan.angle_increment;
    const double range = scan.ranges[i];
    const bool is_measured = range >= scan.range_min && range <= scan.range_max;
    const double length = is_measured ? range : nan;
    memory_.push_back({length * std::cos(angle), length * std::sin(angle), is_measured ? 0 : nan,
                       number * scan.time_increment});
  }
  points_.data = reinterpret_cast<const std::uint8_t*>(memory_.data());
  points_.width = memory_.size();
  points_.point_step = sizeof(Point);
  points_.row_step = memory_.size() * sizeof(Point);
  points_.x = offsetof(Point, x);
  points_.y = offsetof(Point, y);
  points_.z = offsetof(Point, z);
  points_.is_double = true;
  points_.time = NumberField{offsetof(Point, seconds), NumberType::kRelativeSeconds};
}

}  // namespace link_bounds
