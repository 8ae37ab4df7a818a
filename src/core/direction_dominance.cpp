// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Every candidate against the champions of each corner and of their sum.
#include "direction_dominance.h"

namespace link_bounds {
namespace {

/// The columns that are largest in one row or in the sum of all.
Eigen::MatrixXd championsOf(const Eigen::MatrixXd& reaches) {
  Eigen::MatrixXd champions(reaches.rows(), reaches.rows() + 1);
  Eigen::Index best = 0;
  for (Eigen::Index i = 0; i < reaches.rows(); ++i) {
    reaches.row(i).maxCoeff(&best);
    champions.col(i) = reaches.col(best);
  }
  reaches.colwise().sum().maxCoeff(&best);
  champions.col(reaches.rows()) = reaches.col(best);
  return champions;
}

/// One column per candidate, one row per corner.
Eigen::MatrixXd reachesOf(const std::vector<Eigen::Vector3d>& points, const Cone& corners,
                          double sign, const PointIndices& candidates) {
  Eigen::MatrixX3d directions(corners.size(), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    directions.row(static_cast<Eigen::Index>(i)) = sign * corners[i];
  Eigen::MatrixXd reaches(directions.rows(), candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    reaches.col(static_cast<Eigen::Index>(i)).noalias() = directions * points[candidates[i]];
  return reaches;
}

}  // namespace

void dropDominated(const std::vector<Eigen::Vector3d>& points, const Cone& corners, double sign,
                   double margin, PointIndices& candidates) {
  const Eigen::MatrixXd reaches = reachesOf(points, corners, sign, candidates);
  const Eigen::MatrixXd champions = championsOf(reaches);
  std::size_t left = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto reach = reaches.col(static_cast<Eigen::Index>(i)).array();
    bool is_dominated = false;
    for (Eigen::Index j = 0; j < champions.cols() && !is_dominated; ++j)
      is_dominated = (champions.col(j).array() - reach > margin).all();
    if (!is_dominated) candidates[left++] = candidates[i];
  }
  candidates.resize(left);
}

}  // namespace link_bounds
