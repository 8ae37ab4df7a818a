// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes that moved by at most the slack each are near only if they were near with twice the slack.
#include "geometry/overlaps/overlap_candidates.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/overlaps/radix_sort.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

// More slack lasts longer and gives more pairs to look at in each step; for small steps these cost
// the least. A slack that does not last for some steps costs more than it spares.
constexpr double kMostSteps = 16;
constexpr double kFewestSteps = 4;
constexpr double kMostSlack = 0.1;  // of the longest side of a usual box

constexpr std::size_t kSampleSize = 31;

/// How far any side moved [m].
double motion(const std::vector<Aabb>& from, const std::vector<Aabb>& to) {
  Eigen::Array3d farthest = Eigen::Array3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    farthest = farthest.max((to[i].min() - from[i].min()).array().abs())
                   .max((to[i].max() - from[i].max()).array().abs());
  }
  return farthest.maxCoeff();
}

/// The median of the longest sides of some boxes.
double usualLength(const std::vector<Aabb>& boxes) {
  std::array<double, kSampleSize> lengths{};
  const std::size_t size = std::min(boxes.size(), kSampleSize);
  for (std::size_t i = 0; i < size; ++i)
    lengths[i] = boxes[i * boxes.size() / size].sizes().maxCoeff();
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(size / 2);
  std::nth_element(lengths.begin(), middle, lengths.begin() + static_cast<std::ptrdiff_t>(size));
  return *middle;
}

double slackFor(const std::vector<Aabb>& boxes, double speed) {
  const double slack = std::min(kMostSteps * speed, kMostSlack * usualLength(boxes));
  return slack >= kFewestSteps * speed ? slack : 0;
}

/// How many bits numbers below `count` have.
int bitsOf(std::size_t count) {
  int bits = 1;
  while (bits < kNumberBits && count > std::size_t{1} << bits)
    ++bits;
  return bits;
}

void sort(std::size_t box_count, OverlapCandidates& candidates) {
  const int bits = bitsOf(box_count);
  radixSort(candidates.pairs, candidates.scratch, 0, bits);
  radixSort(candidates.pairs, candidates.scratch, kNumberBits, kNumberBits + bits);
}

}  // namespace

void update(const std::vector<Aabb>& boxes, double margin, OverlapCandidates& candidates) {
  ++candidates.steps;
  if (boxes.size() == candidates.boxes.size() && margin == candidates.margin) {
    const double moved = motion(candidates.boxes, boxes);
    if (moved <= candidates.slack) return;
    candidates.speed = moved / static_cast<double>(candidates.steps);
  }
  candidates.boxes = boxes;
  candidates.margin = margin;
  candidates.slack = boxes.empty() ? 0 : slackFor(boxes, candidates.speed);
  candidates.steps = 0;
  // Twice the slack, and what rounding may have hidden of the motion.
  arrange(boxes, addUp(margin, (2 + 1e-9) * candidates.slack), candidates.sweep_boxes);
  sweep(candidates.sweep_boxes, candidates.pairs);
  sort(boxes.size(), candidates);
}

}  // namespace link_bounds
