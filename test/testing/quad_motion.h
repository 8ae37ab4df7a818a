// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// tf2's interpolation and composition in quadruple precision. Written from their definition, not
// from the code that is tested.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "testing/quad.h"
#include "world/tf/tf2_pose.h"

namespace link_bounds {

using QuadVector = std::array<Quad, 3>;

struct QuadQuaternion {
  Quad w, x, y, z;
};

inline Quad dot(const QuadQuaternion& a, const QuadQuaternion& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

inline QuadQuaternion operator*(const QuadQuaternion& a, const QuadQuaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

inline QuadQuaternion conjugate(const QuadQuaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Not divided by the length, as in tf2.
inline QuadVector turned(const QuadQuaternion& q, const QuadVector& v) {
  const QuadQuaternion r = q * QuadQuaternion{0, v[0], v[1], v[2]} * conjugate(q);
  return {r.x, r.y, r.z};
}

/// The angle whose sine and cosine these are, between 0 and pi/2.
inline Quad quadAngle(Quad sine, Quad cosine) {
  Quad angle = std::atan2(static_cast<double>(sine), static_cast<double>(cosine));
  const Quad s = quadSine(angle);
  const Quad c = quadRoot(1 - s * s);
  angle += sine * c - cosine * s;
  return angle;
}

/// An edge between two samples; what depends on these alone is computed once.
class QuadStep {
 public:
  QuadStep(const Tf2Pose& older, const Tf2Pose& newer)
      : q0_(rotation(older)),
        q1_(rotation(newer)),
        p0_(translation(older)),
        p1_(translation(newer)) {
    // After half a turn the sign that tf2 finds decides about the way.
    if (older.rotation().dot(newer.rotation()) < 0) q1_ = {-q1_.w, -q1_.x, -q1_.y, -q1_.z};
    // Where its double is 0, tf2 keeps the older rotation.
    is_turning_ = tf2::angleShortestPath(older.rotation(), newer.rotation()) > 0;
    const Quad lengths = quadRoot(dot(q0_, q0_) * dot(q1_, q1_));
    const Quad cosine = dot(q0_, q1_) / lengths;
    QuadQuaternion across = conjugate(q0_) * q1_;
    across.w = 0;
    sine_ = quadRoot(dot(across, across)) / lengths;
    angle_ = quadAngle(sine_, cosine);
  }

  /// `part` from 0 to 1.
  QuadQuaternion rotationAt(Quad part) const {
    if (!is_turning_) return part < 1 ? q0_ : q1_;
    const bool is_turned = sine_ > 1e-20;
    const Quad a = is_turned ? quadSine((1 - part) * angle_) / sine_ : 1 - part;
    const Quad b = is_turned ? quadSine(part * angle_) / sine_ : part;
    return {a * q0_.w + b * q1_.w, a * q0_.x + b * q1_.x, a * q0_.y + b * q1_.y,
            a * q0_.z + b * q1_.z};
  }

  QuadVector translationAt(Quad part) const {
    QuadVector result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = (1 - part) * p0_[k] + part * p1_[k];
    return result;
  }

 private:
  static QuadQuaternion rotation(const Tf2Pose& pose) {
    const tf2::Quaternion q = pose.rotation();
    return {q.w(), q.x(), q.y(), q.z()};
  }

  static QuadVector translation(const Tf2Pose& pose) {
    const tf2::Vector3 t = pose.translation();
    return {t.x(), t.y(), t.z()};
  }

  QuadQuaternion q0_, q1_;
  QuadVector p0_, p1_;
  bool is_turning_;
  Quad sine_, angle_;
};

/// The samples of an edge in the order of their stamps; one holds at all times.
struct QuadEdge {
  struct Sample {
    std::int64_t stamp;
    Tf2Pose pose;
  };

  explicit QuadEdge(std::vector<Sample> from)
      : samples(std::move(from)), steps(std::max<std::size_t>(1, samples.size() - 1)) {}

  struct Place {
    const QuadStep* step;
    Quad part;
  };

  Place at(std::int64_t time) const {
    if (samples.size() == 1) return {&step(0, 0), 0};
    std::size_t i = 0;
    while (i + 2 < samples.size() && samples[i + 1].stamp <= time)
      ++i;
    const Quad part = static_cast<Quad>(time - samples[i].stamp) /
                      static_cast<Quad>(samples[i + 1].stamp - samples[i].stamp);
    return {&step(i, i + 1), part};
  }

  const QuadStep& step(std::size_t older, std::size_t newer) const {
    if (!steps[older]) steps[older].emplace(samples[older].pose, samples[newer].pose);
    return *steps[older];
  }

  std::vector<Sample> samples;
  mutable std::vector<std::optional<QuadStep>> steps;  ///< computed when they are needed
};

struct QuadPose {
  QuadQuaternion rotation{1, 0, 0, 0};
  QuadVector translation{0, 0, 0};

  /// Becomes the edge's transform after this one.
  void lift(const QuadEdge& edge, std::int64_t time) {
    const auto [step, part] = edge.at(time);
    const QuadQuaternion q = step->rotationAt(part);
    const QuadVector p = step->translationAt(part);
    translation = turned(q, translation);
    for (std::size_t k = 0; k < 3; ++k)
      translation[k] += p[k];
    rotation = q * rotation;
  }
};

/// The link in the target, whose points are turned by the quaternion at length 1.
inline QuadPose quadPose(const std::vector<QuadEdge>& from_source,
                         const std::vector<QuadEdge>& from_target, std::int64_t time) {
  QuadPose source, target;
  for (const QuadEdge& edge : from_source)
    source.lift(edge, time);
  for (const QuadEdge& edge : from_target)
    target.lift(edge, time);
  QuadVector apart;
  for (std::size_t k = 0; k < 3; ++k)
    apart[k] = source.translation[k] - target.translation[k];
  QuadPose result;
  result.rotation = conjugate(target.rotation) * source.rotation;
  result.translation = turned(conjugate(target.rotation), apart);
  const Quad length = quadRoot(dot(result.rotation, result.rotation));
  QuadQuaternion& q = result.rotation;
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  return result;
}

/// The box of balls of one radius around points.
template <class Point>
QuadBox quadBox(const std::vector<Point>& points, double radius, const QuadPose& pose) {
  QuadBox result{};
  bool is_first = true;
  for (const Point& point : points) {
    const QuadVector place = turned(
        pose.rotation,
        {static_cast<Quad>(point[0]), static_cast<Quad>(point[1]), static_cast<Quad>(point[2])});
    for (std::size_t k = 0; k < 3; ++k) {
      const Quad x = place[k] + pose.translation[k];
      result.min[k] = is_first ? x - radius : std::min<Quad>(result.min[k], x - radius);
      result.max[k] = is_first ? x + radius : std::max<Quad>(result.max[k], x + radius);
    }
    is_first = false;
  }
  return result;
}

}  // namespace link_bounds
