// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The angles of a revolute joint, cut into pieces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/reach/support_table.h"

namespace link_bounds {

/// A full turn if the range is one or cannot be told from one.
class Arc {
 public:
  /// Pieces of at most `max_piece` < pi [rad].
  Arc(const Limits& range, double max_piece);

  /// What is no less than the max over all angles q of h(Q(-q) direction), where Q(q) turns by q
  /// about `axis` and `support` is of h.
  double support(const SupportTable& support, const Eigen::Vector3d& axis,
                 const Eigen::Vector3d& direction) const;

  /// The angle between two pieces for which h(Q(-q) direction) is the largest.
  double bestAngle(const SupportTable& support, const Eigen::Vector3d& axis,
                   const Eigen::Vector3d& direction) const;

 private:
  /// From one angle to the next one.
  struct Piece {
    double angle;    ///< the first one [rad]
    double cosine;   ///< of the angle
    double sine;     ///< of the angle
    double cosine2;  ///< of half the angle of the piece, squared
    double sine2;    ///< of half the angle of the piece, squared
  };

  std::vector<Piece> pieces_;  ///< the last one is the end of the range
};

}  // namespace link_bounds
