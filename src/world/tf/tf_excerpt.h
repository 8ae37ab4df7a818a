// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the poses of some frames at some times need of a TransformBuffer, copied for another thread.
//
// A history of 200 edges at 1 kHz takes 140 MB. So it is copied in pieces, between which tf goes
// on. Each edge is then as it was at some moment of the copying, as if the messages that came
// meanwhile had come later for some edges. Only after clear() all begins again: what lies before a
// clock jump and what lies behind it must not meet.
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

/// Holds the edges on all ways up from the frames that were added, by the newest parents and by
/// those that occur in the samples of its times.
class TfExcerpt {
 public:
  using Frame = TransformBuffer::Frame;

  /// For poses at all times from `stamp` - `span` to `stamp` [ns]. At stamp 0 these are, for each
  /// path, its latest common time and the span before it. Edges received before `stale_before` need
  /// not be part of such a path.
  TfExcerpt(std::int64_t stamp, std::int64_t span, std::int64_t stale_before)
      : stamp_(stamp), span_(span), stale_before_(stale_before) {}

  /// That of `tf` when what was copied last began. A frame must have been added.
  std::uint64_t epoch() const { return *epoch_; }

  /// To be called after clear(), before the next copy().
  void setStaleBefore(std::int64_t stale_before) { stale_before_ = stale_before; }

  /// Makes room for so many frames.
  void reserve(std::size_t frames);

  /// The number in buffer() of a frame of `tf`. To be called before the first copy().
  Frame add(const TransformBuffer& tf, Frame frame);

  /// How much memory the samples take that were copied.
  std::size_t bytes() const { return samples_ * sizeof(EdgeSample); }

  /// Copies for about that time; true when everything is there. It must always be the same `tf`.
  bool copy(const TransformBuffer& tf, std::chrono::nanoseconds budget);

  /// At the times of the excerpt, poses between added frames have the bits that they have in the
  /// original. It looks up no names; those that it returns belong to the original, which must live
  /// longer.
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

  TransformBuffer::Readers readers_;  ///< of the original: first, it ends last
  std::int64_t stamp_;
  std::int64_t span_;
  std::int64_t stale_before_;
  std::pmr::monotonic_buffer_resource memory_{1 << 16};  ///< of samples: allocated and freed as one
  std::unique_ptr<TransformBuffer> buffer_ = std::make_unique<TransformBuffer>();
  std::vector<std::unique_ptr<TransformBuffer>> former_;  ///< not freed on the update thread
  std::vector<Frame> added_;                              ///< numbers in the original
  std::unordered_map<Frame, Frame> copies_;  ///< by frame of the original: its number in buffer()
  std::vector<Frame> originals_;             ///< by frame: its number in the original
  std::vector<std::int64_t> oldest_;
  std::optional<std::uint64_t> epoch_;        ///< of the original, when it began
  std::size_t heads_ = 0;                     ///< edges that were copied without their samples
  std::size_t complete_ = 0;                  ///< edges that were copied
  std::size_t samples_ = 0;                   ///< of these
  std::int64_t common_ = kEnd;                ///< the oldest of the newest stamps
  std::optional<std::int64_t> begin_;         ///< of the times, once samples are copied
  std::optional<std::int64_t> copied_until_;  ///< within the next edge
  std::optional<std::pair<Frame, Frame>> last_parent_;  ///< in the original and here
};

}  // namespace link_bounds
