// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A distance that was proven once, carried along while its two bodies move a little.
#pragma once

#include <optional>

#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {

/// A ball that holds a body, in the frame of the body [m].
struct Ball {
  Ball(const Eigen::Vector3d& its_center, double its_radius)
      : center(its_center), radius(its_radius), farthest(center.norm() + radius) {}

  Eigen::Vector3d center;
  double radius;
  double farthest;  ///< no point of the body is farther from the origin of its frame
};

/// Nothing if the body has no shape or no finite box.
std::optional<Ball> ballOf(const Body& body);

/// A body at a rigid pose.
struct RigidBody {
  Ball ball;
  Eigen::Matrix3d axes;
  Eigen::Vector3d origin;
  double from_origin;  ///< how far `origin` is from the origin of the world [m]
  double defect;       ///< bounds |axes' axes - 1|, with the rounding of products
};

/// Nothing if the pose scales or mirrors, or if lengths are beyond 1e9 m.
std::optional<RigidBody> rigidBody(const Ball& ball, const Eigen::Affine3d& world_from_body);

/// The one of two bodies that counts as resting: that with the larger ball. Motion of the other
/// body is seen from it.
inline const RigidBody& resting(const RigidBody& first, const RigidBody& second) {
  return second.ball.radius <= first.ball.radius ? first : second;
}

/// The motion of the moving body in the frame of the resting one: a point q of the moving body's
/// frame moves by turned q + shifted, up to `slack` [m].
struct RelativeMotion {
  Eigen::Matrix3d turned;
  Eigen::Vector3d shifted;
  double slack;     ///< also the max error of a point that a body has carried to its other pose [m]
  double approach;  ///< how much nearer to each other two points of the bodies may be now [m]
};

/// The relative pose of two bodies at one time.
struct PosePair {
  PosePair(const RigidBody& first, const RigidBody& second);

  Eigen::Matrix3d axes;  ///< of the body that moves, in the frame of the one that rests
  Eigen::Vector3d origin;
  double defect;
  double size;
  double rounding;
};

/// The motion of the same two bodies from `then` to `now`. `mover` is the body that does not rest.
RelativeMotion motionBetween(const PosePair& then, const PosePair& now, const RigidBody& mover);

class Lease {
 public:
  /// `found` is the distance of the bodies at the poses `now`.
  Lease(const BodyDistance& found, const PosePair& now, const RigidBody& first,
        const RigidBody& second);

  /// How the same two bodies have moved since the poses of the lease.
  RelativeMotion motion(const PosePair& now, const RigidBody& first,
                        const RigidBody& second) const {
    return motionBetween(then_, now, &resting(first, second) == &first ? second : first);
  }

  /// The distance after `motion`: the lower bound less the relative motion of the bodies, and the
  /// points carried along with the bodies. Both bounds are proven.
  BodyDistance carried(const RelativeMotion& motion, const RigidBody& first,
                       const RigidBody& second) const;

 private:
  PosePair then_;
  double lower_;
  DistanceLevel level_;
  Eigen::Vector3d on_first_;  ///< in the frame of the first body
  Eigen::Vector3d on_second_;
  Eigen::Vector3d normal_;  ///< in the frame of the resting body
};

}  // namespace link_bounds
