// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares every candidate with the champions of each corner and of the sum of all corners.
#include "geometry/support/table/direction_dominance.h"

#include <algorithm>
#include <array>
#include <limits>

namespace link_bounds {
namespace {

constexpr std::size_t kMaxCorners = 6;  ///< a cell is at most two triangles

/// Dot products of a point with each corner; 0 for corners that do not exist.
using DotProducts = std::array<double, kMaxCorners>;

DotProducts dotProductsOf(const Eigen::Vector3d& point, const Cone& corners, double sign) {
  DotProducts products{};
  for (std::size_t i = 0; i < corners.size(); ++i)
    products[i] = sign * point.dot(corners[i]);
  return products;
}

/// The candidates so far with the largest product at one corner or on average.
class Champions {
 public:
  explicit Champions(std::size_t corners) : corners_(corners), best_(corners + 1) {
    for (DotProducts& products : best_)
      products.fill(-std::numeric_limits<double>::infinity());
  }

  void add(const DotProducts& products) {
    double sum = 0;
    for (std::size_t i = 0; i < corners_; ++i) {
      sum += products[i];
      if (products[i] > best_[i][i]) best_[i] = products;
    }
    if (sum > best_sum_) best_.back() = products;
    best_sum_ = std::max(best_sum_, sum);
  }

  /// True if a champion exceeds the candidate by more than the margin at every corner.
  bool beat(const DotProducts& products, double margin) const {
    return std::any_of(best_.begin(), best_.end(), [&](const DotProducts& best) {
      for (std::size_t i = 0; i < corners_; ++i) {
        if (!(best[i] - products[i] > margin)) return false;
      }
      return true;
    });
  }

 private:
  std::size_t corners_;
  std::vector<DotProducts> best_;
  double best_sum_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

void dropDominated(const std::vector<Eigen::Vector3d>& points, const Cone& corners, double sign,
                   double margin, PointIndices& candidates) {
  std::vector<DotProducts> products;
  products.reserve(candidates.size());
  Champions champions(corners.size());
  for (const std::uint32_t candidate : candidates) {
    products.push_back(dotProductsOf(points[candidate], corners, sign));
    champions.add(products.back());
  }
  std::size_t left = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!champions.beat(products[i], margin)) candidates[left++] = candidates[i];
  }
  candidates.resize(left);
}

}  // namespace link_bounds
