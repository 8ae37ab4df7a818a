// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The layout of a cloud: where the coordinates and times of points are in its bytes. Also converts
// a laser scan to such points.
//
// Drivers write the time of a point into one of four fields:
//
//   t, offset_time        uint32   nanoseconds after the header's stamp: Ouster, Livox
//   time                  float32  seconds after the header's stamp, or before it: Velodyne
//   timestamp             float64  seconds of ROS time: Hesai, RoboSense; nanoseconds: Livox
//
// So integers are nanoseconds after the header's stamp. A float32 is seconds after it, because it
// is too coarse for ROS time. A float64 is seconds after it, or seconds or nanoseconds of ROS time:
// whichever is nearest to the stamp.
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace link_bounds {

/// kFloat64 is a time that may be relative to the stamp or ROS time. kRelativeSeconds is also
/// stored as a float64, but always in seconds after the stamp.
enum class NumberType { kFloat32, kFloat64, kInt32, kUint32, kRelativeSeconds };

struct NumberField {
  std::size_t offset;  ///< bytes from the begin of the point
  NumberType type;
};

/// Points in memory that another object owns. Every offset lies within that memory.
struct CloudPoints {
  const std::uint8_t* data = nullptr;
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t point_step = 0;  ///< bytes
  std::size_t row_step = 0;
  std::size_t x = 0, y = 0, z = 0;  ///< offsets in a point [bytes]
  bool is_double = false;           ///< else coordinates are float32
  std::optional<NumberField> time;
  std::int64_t stamp = 0;  ///< of the header [ns]

  std::size_t size() const { return width * height; }

  const std::uint8_t* point(std::size_t index) const {
    return height == 1 ? data + index * point_step
                       : data + index / width * row_step + index % width * point_step;
  }

  /// Calls visit(index, bytes) for each point in order; faster than point() for each.
  template <class Visit>
  void forEach(const Visit& visit) const {
    std::size_t index = 0;
    for (std::size_t row = 0; row < height; ++row) {
      const std::uint8_t* bytes = data + row * row_step;
      for (std::size_t i = 0; i < width; ++i, bytes += point_step)
        visit(index++, bytes);
    }
  }

  template <class Number>
  static Number read(const std::uint8_t* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
  }

  Eigen::Vector3d position(const std::uint8_t* bytes) const {
    if (is_double)
      return {read<double>(bytes + x), read<double>(bytes + y), read<double>(bytes + z)};
    return {read<float>(bytes + x), read<float>(bytes + y), read<float>(bytes + z)};
  }

  /// The time of a point [ns]; the header's stamp if the point has no usable time.
  std::int64_t timeOf(const std::uint8_t* bytes) const;
};

struct CloudLayout {
  CloudPoints points;
  std::string problem;  ///< why the cloud cannot be read, and the remedy; "" if it can
};

/// The message must outlive the result.
CloudLayout layoutOf(const sensor_msgs::PointCloud2& cloud);

/// The first and the last time of all points with finite coordinates; nothing if there are none.
struct TimeSpan {
  std::int64_t begin, end;  // ns
};
std::optional<TimeSpan> timeSpan(const CloudPoints& points);

/// Why the scan cannot be read, and the remedy; "" if it can.
std::string problemOf(const sensor_msgs::LaserScan& scan);

/// The points of a laser scan without a problem: one per range, with the place and the time of its
/// measurement. Ranges outside range_min to range_max give points that are not finite.
class LaserPoints {
 public:
  explicit LaserPoints(const sensor_msgs::LaserScan& scan);
  LaserPoints(const LaserPoints&) = delete;
  LaserPoints& operator=(const LaserPoints&) = delete;

  const CloudPoints& points() const { return points_; }

 private:
  struct Point {
    double x, y, z;
    double seconds;  ///< after the stamp
  };

  std::vector<Point> memory_;
  CloudPoints points_;
};

}  // namespace link_bounds
