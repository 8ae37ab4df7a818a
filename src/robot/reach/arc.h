// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The angles of a revolute joint, cut into pieces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/reach/support_table.h"

namespace link_bounds {

/// The angles of a range, or a full turn if the range is one or cannot be told from one.
class Arc {
 public:
  /// Cuts the angles into pieces of at most `max_piece` < pi [rad].
  Arc(const Limits& range, double max_piece);

  /// An upper bound of the max over all angles q of h(Q(-q) direction), where Q(q) turns by q about
  /// `axis` and `support` is the table of h.
  double support(const SupportTable& support, const Eigen::Vector3d& axis,
                 const Eigen::Vector3d& direction) const;

  /// The end of a piece for which h(Q(-q) direction) is the largest [rad].
  double bestAngle(const SupportTable& support, const Eigen::Vector3d& axis,
                   const Eigen::Vector3d& direction) const;

 private:
  /// A piece from one angle to the next one.
  struct Piece {
    double angle;    ///< the first one [rad]
    double cosine;   ///< of the angle
    double sine;     ///< of the angle
    double cosine2;  ///< squared cosine of half the piece
    double sine2;    ///< squared sine of half the piece
  };

  std::vector<Piece> pieces_;  ///< the last one is the end of the range
};

}  // namespace link_bounds
