// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a sample of the boxes tells about all decides how fast the sweep is, not what it finds.
#include "geometry/overlaps/sweep_boxes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "geometry/overlaps/radix_sort.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr std::size_t kSampleSize = 32;

/// The nearest finite float; a larger value never gives a smaller one.
float toFloat(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(std::max(value, -largest), largest));
}

/// The intervals of some boxes on one axis.
struct Sample {
  std::size_t size;
  std::array<float, kSampleSize> low, high;
};

Sample sampleOf(const std::vector<Aabb>& boxes, int axis) {
  Sample sample{std::min(boxes.size(), kSampleSize), {}, {}};
  for (std::size_t i = 0; i < sample.size; ++i) {
    const Aabb& box = boxes[i * boxes.size() / sample.size];
    sample.low[i] = toFloat(box.min()[axis]);
    sample.high[i] = toFloat(box.max()[axis]);
  }
  return sample;
}

/// How many intervals overlap how many others.
int overlapsOf(const Sample& sample) {
  int count = 0;
  for (std::size_t i = 0; i < sample.size; ++i) {
    for (std::size_t j = 0; j < sample.size; ++j)
      count += sample.low[i] <= sample.high[j] && sample.low[j] <= sample.high[i];
  }
  return count;
}

/// Not the mean, which one box far away would spoil.
double medianOf(Sample sample) {
  const auto middle = sample.low.begin() + static_cast<std::ptrdiff_t>(sample.size / 2);
  std::nth_element(sample.low.begin(), middle,
                   sample.low.begin() + static_cast<std::ptrdiff_t>(sample.size));
  return *middle;
}

/// How coordinates become floats.
struct Frame {
  std::array<int, 3> axes{0, 1, 2};  ///< first that of the sweep, along which the fewest overlap
  Eigen::Vector3d origin;            ///< amid the boxes, because floats are finest around 0
  double margin;

  float low(const Aabb& box, int axis) const { return toFloat(box.min()[axis] - origin[axis]); }

  float high(const Aabb& box, int axis) const {
    const double side = margin > 0 ? addUp(box.max()[axis], margin) : box.max()[axis];
    return toFloat(side - origin[axis]);
  }
};

Frame frameOf(const std::vector<Aabb>& boxes, double margin) {
  Frame frame;
  // A difference that is rounded down to the margin was at most the next number.
  frame.margin = margin > 0 ? nextUp(margin) : 0;
  int fewest = std::numeric_limits<int>::max();
  for (int axis = 0; axis < 3; ++axis) {
    const Sample sample = sampleOf(boxes, axis);
    frame.origin[axis] = medianOf(sample);
    const int overlaps = overlapsOf(sample);
    if (overlaps >= fewest) continue;
    fewest = overlaps;
    frame.axes = {axis, (axis + 1) % 3, (axis + 2) % 3};
  }
  return frame;
}

constexpr int kKeyShift = 32;    // above the place in the list
constexpr int kDroppedBits = 8;  // a third of the work of sorting, for boxes 2^-15 apart
constexpr int kKeyBits = 32 - kDroppedBits;

/// The first bits of a float, made such that they are ordered as the floats.
std::uint64_t toKey(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits ^= bits >> 31 ? 0xffffffffu : 0x80000000u;
  return bits >> kDroppedBits;
}

/// The smallest float with that key.
float fromKey(std::uint64_t key) {
  auto bits = static_cast<std::uint32_t>(key << kDroppedBits);
  bits ^= bits >> 31 ? 0x80000000u : 0xffffffffu;
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void sort(const std::vector<Aabb>& boxes, const Frame& frame, SweepBoxes& result) {
  result.order.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    result.order[i] = toKey(frame.low(boxes[i], frame.axes[0])) << kKeyShift | i;
  radixSort(result.order, result.scratch, kKeyShift, kKeyShift + kKeyBits);
}

void resize(SweepBoxes& result, std::size_t size) {
  for (std::size_t k = 0; k < 3; ++k) {
    result.low[k].resize(size);
    result.high[k].resize(size);
  }
  result.numbers.resize(size);
}

}  // namespace

void arrange(const std::vector<Aabb>& boxes, double margin, SweepBoxes& result) {
  const Frame frame = frameOf(boxes, margin);
  sort(boxes, frame, result);
  resize(result, boxes.size() + kSweepLanes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    result.numbers[i] = static_cast<std::uint32_t>(result.order[i]);
    const Aabb& box = boxes[result.numbers[i]];
    result.low[0][i] = fromKey(result.order[i] >> kKeyShift);
    result.high[0][i] = frame.high(box, frame.axes[0]);
    for (std::size_t k = 1; k < 3; ++k) {
      result.low[k][i] = frame.low(box, frame.axes[k]);
      result.high[k][i] = frame.high(box, frame.axes[k]);
    }
  }
  std::fill(result.low[0].end() - kSweepLanes, result.low[0].end(),
            std::numeric_limits<float>::quiet_NaN());
}

}  // namespace link_bounds
