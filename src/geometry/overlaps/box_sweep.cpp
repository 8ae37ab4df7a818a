// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Of two boxes that are near, the one that begins later begins before the other one ends.
#include "geometry/overlaps/box_sweep.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace link_bounds {
namespace {

/// One box and which of the kSweepLanes boxes from another one on are near it, as bits; only such
/// count as begin, on the axis of the sweep, not before it.
class PlainLanes {
 public:
  PlainLanes(const SweepBoxes& boxes, std::size_t i) : boxes_(boxes), i_(i) {}

  unsigned near(std::size_t j) const {
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < kSweepLanes; ++lane)
      bits |= static_cast<unsigned>(isNear(j + lane)) << lane;
    return bits;
  }

 private:
  bool isNear(std::size_t j) const {
    return boxes_.low[0][j] <= boxes_.high[0][i_] && boxes_.low[1][j] <= boxes_.high[1][i_] &&
           boxes_.low[1][i_] <= boxes_.high[1][j] && boxes_.low[2][j] <= boxes_.high[2][i_] &&
           boxes_.low[2][i_] <= boxes_.high[2][j];
  }

  const SweepBoxes& boxes_;
  std::size_t i_;
};

#ifdef __SSE2__
/// Four at a time.
class Lanes {
 public:
  Lanes(const SweepBoxes& boxes, std::size_t i)
      : low0_(boxes.low[0].data()),
        low1_(boxes.low[1].data()),
        low2_(boxes.low[2].data()),
        high1_(boxes.high[1].data()),
        high2_(boxes.high[2].data()),
        end0_(_mm_set1_ps(boxes.high[0][i])),
        end1_(_mm_set1_ps(boxes.high[1][i])),
        end2_(_mm_set1_ps(boxes.high[2][i])),
        begin1_(_mm_set1_ps(low1_[i])),
        begin2_(_mm_set1_ps(low2_[i])) {}

  unsigned near(std::size_t j) const {
    const __m128i eight = _mm_packs_epi32(fourNear(j), fourNear(j + 4));
    return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(eight, _mm_setzero_si128())));
  }

 private:
  __m128i fourNear(std::size_t j) const {
    const __m128 on0 = _mm_cmple_ps(_mm_loadu_ps(low0_ + j), end0_);
    const __m128 on1 = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(low1_ + j), end1_),
                                  _mm_cmple_ps(begin1_, _mm_loadu_ps(high1_ + j)));
    const __m128 on2 = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(low2_ + j), end2_),
                                  _mm_cmple_ps(begin2_, _mm_loadu_ps(high2_ + j)));
    return _mm_castps_si128(_mm_and_ps(on0, _mm_and_ps(on1, on2)));
  }

  const float *low0_, *low1_, *low2_, *high1_, *high2_;
  __m128 end0_, end1_, end2_, begin1_, begin2_;
};
#else
using Lanes = PlainLanes;
#endif

template <class LanesOf>
void sweepBy(const SweepBoxes& boxes, std::vector<NumberPair>& pairs) {
  pairs.clear();
  const float* low = boxes.low[0].data();
  const std::size_t count = boxes.numbers.size() - kSweepLanes;
  for (std::size_t i = 0; i < count; ++i) {
    const LanesOf lanes(boxes, i);
    const float end = boxes.high[0][i];
    for (std::size_t j = i + 1; low[j] <= end; j += kSweepLanes) {
      for (unsigned near = lanes.near(j); near != 0; near &= near - 1) {
        const std::size_t lane = static_cast<unsigned>(__builtin_ctz(near));
        pairs.push_back(pairOf(boxes.numbers[i], boxes.numbers[j + lane]));
      }
    }
  }
}

}  // namespace

void sweep(const SweepBoxes& boxes, std::vector<NumberPair>& pairs) {
  sweepBy<Lanes>(boxes, pairs);
}

void sweepPlain(const SweepBoxes& boxes, std::vector<NumberPair>& pairs) {
  sweepBy<PlainLanes>(boxes, pairs);
}

}  // namespace link_bounds
