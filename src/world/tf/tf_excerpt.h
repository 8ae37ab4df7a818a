// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a TransformBuffer that poses of some frames at some times need, copied for another
// thread.
//
// A history of 200 edges at 1 kHz takes 140 MB. So it is copied in pieces, and tf accepts messages
// between two pieces. Each edge is copied as it was at some moment in that time, as if some
// messages had come later for some edges. Only clear() makes the copy start again: transforms from
// before and after a clock jump must not be mixed.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <memory_resource>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// Holds the edges on all ways up from the added frames: those to the newest parents and those to
/// parents in samples at the times of the excerpt.
class TfExcerpt {
 public:
  using Frame = TransformBuffer::Frame;

  /// For poses at all times from `stamp` - `span` to `stamp` [ns]. At stamp 0 the times are, for
  /// each path, the span up to its latest common time. Paths with an edge received before
  /// `stale_before` [ns] need not be covered.
  TfExcerpt(std::int64_t stamp, std::int64_t span, std::int64_t stale_before)
      : stamp_(stamp), span_(span), stale_before_(stale_before) {}

  /// The epoch() of `tf` when the current copy began. A frame must have been added.
  std::uint64_t epoch() const { return *epoch_; }

  /// To be called after clear(), before the next copy().
  void setStaleBefore(std::int64_t stale_before) { stale_before_ = stale_before; }

  /// Makes room for this many frames.
  void reserve(std::size_t frames);

  /// The number in buffer() of a frame of `tf`. To be called before the first copy().
  Frame add(const TransformBuffer& tf, Frame frame);

  /// The memory of the copied samples.
  std::size_t bytes() const { return samples_ * sizeof(EdgeSample); }

  /// Copies for about the time `budget`; true once all is copied. `tf` must be the same in all
  /// calls.
  bool copy(const TransformBuffer& tf, std::chrono::nanoseconds budget);

  /// The copy. At the times of the excerpt it gives the same bits as the original for poses between
  /// added frames. It cannot look up names. Names that it returns belong to the original, which
  /// must outlive it.
  TransformBuffer& buffer() { return *buffer_; }
  const TransformBuffer& buffer() const { return *buffer_; }

  /// The oldest stamp of the edge's history in the original; 0 if it is static or has none.
  std::int64_t oldest(Frame child) const { return oldest_[child]; }

 private:
  static constexpr std::int64_t kEnd = std::numeric_limits<std::int64_t>::max();

  Frame include(const TransformBuffer& tf, Frame frame);
  void restart(const TransformBuffer& tf);
  void copyHead(const TransformBuffer& tf, Frame child);
  bool copySamples(const TransformBuffer& tf, Frame child);
  void copyTransform(const TransformBuffer& tf, const EdgeHistory& history, Frame child);
  std::size_t firstNeeded(const EdgeHistory& history) const;
  Frame parentOf(const TransformBuffer& tf, const EdgeSample& sample);

  std::shared_ptr<void> reader_;  ///< of the original; first member: destroyed last
  std::int64_t stamp_;
  std::int64_t span_;
  std::int64_t stale_before_;
  std::pmr::monotonic_buffer_resource memory_{1 << 16};  ///< of samples: freed as a whole
  std::unique_ptr<TransformBuffer> buffer_ = std::make_unique<TransformBuffer>();
  std::vector<std::unique_ptr<TransformBuffer>> former_;  ///< of old epochs; freed with this object
  std::vector<Frame> added_;                              ///< numbers in the original
  std::unordered_map<Frame, Frame> copies_;  ///< by frame of the original: its number in buffer()
  std::vector<Frame> originals_;             ///< by frame: its number in the original
  std::vector<std::int64_t> oldest_;
  std::optional<std::uint64_t> epoch_;        ///< of the original when the copy began
  std::size_t heads_ = 0;                     ///< number of edges copied without their samples
  std::size_t complete_ = 0;                  ///< number of edges copied completely
  std::size_t samples_ = 0;                   ///< number of copied samples
  std::int64_t common_ = kEnd;                ///< the min of the edges' newest stamps
  std::optional<std::int64_t> begin_;         ///< first time to cover, once samples are copied
  std::optional<std::int64_t> copied_until_;  ///< last stamp copied of the next edge
  std::optional<std::pair<Frame, Frame>> last_parent_;  ///< its number in the original, and here
};

}  // namespace link_bounds
