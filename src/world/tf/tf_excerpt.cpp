// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The list of frames is also the queue of edges to copy: parents that are met are appended.
#include "world/tf/tf_excerpt.h"

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kEdgesPerLook = 8;  // edges per look at the clock
constexpr std::size_t kChunk = 128;       // samples per step; takes some microseconds

}  // namespace

TfExcerpt::Frame TfExcerpt::add(const TransformBuffer& tf, Frame frame) {
  if (!epoch_) {
    reader_ = tf.addReader();
    epoch_ = tf.epoch();
  }
  added_.push_back(frame);
  return include(tf, frame);
}

void TfExcerpt::reserve(std::size_t frames) {
  buffer_->names_.reserve(frames);
  buffer_->edges_.reserve(frames);
  originals_.reserve(frames);
  oldest_.reserve(frames);
}

TfExcerpt::Frame TfExcerpt::include(const TransformBuffer& tf, Frame frame) {
  const auto known = copies_.find(frame);
  if (known != copies_.end()) return known->second;
  const Frame copy = buffer_->names_.borrow(tf.name(frame));
  buffer_->edges_.emplace_back();
  originals_.push_back(frame);
  copies_.emplace(frame, copy);
  return copy;
}

bool TfExcerpt::copy(const TransformBuffer& tf, std::chrono::nanoseconds budget) {
  const Clock::time_point end = Clock::now() + budget;
  if (epoch_ != tf.epoch()) restart(tf);
  for (std::size_t i = 1; complete_ < originals_.size(); ++i) {
    if (heads_ < originals_.size()) {
      copyHead(tf, heads_++);
    } else if (copySamples(tf, complete_)) {
      ++complete_;
    }
    const bool looks = i % kEdgesPerLook == 0 || copied_until_;
    if (looks && complete_ < originals_.size() && Clock::now() >= end) return false;
  }
  buffer_->settled_ = tf.settled();
  return true;
}

/// The frames that were added keep their numbers.
void TfExcerpt::restart(const TransformBuffer& tf) {
  former_.push_back(std::exchange(buffer_, std::make_unique<TransformBuffer>()));
  copies_.clear();
  originals_.clear();
  oldest_.clear();
  for (const Frame frame : added_)
    include(tf, frame);
  epoch_ = tf.epoch();
  heads_ = complete_ = samples_ = 0;
  common_ = kEnd;
  begin_.reset();
  copied_until_.reset();
  last_parent_.reset();
}

/// Copies the edge without its samples.
void TfExcerpt::copyHead(const TransformBuffer& tf, Frame child) {
  const TransformBuffer::Edge& original = tf.edges_[originals_[child]];
  const Frame parent = original.has_parent ? include(tf, original.parent) : 0;
  TransformBuffer::Edge& edge = buffer_->edges_[child];
  edge.parent = parent;
  edge.has_parent = original.has_parent;
  edge.is_static = original.is_static;
  edge.is_in_doubt = original.is_in_doubt;
  edge.newest = original.newest;
  edge.received = original.received;
  const bool moves = original.has_parent && !original.is_static;
  oldest_.push_back(0);
  if (original.history) edge.history.emplace(original.is_static, memory_);
  if (!moves) return;
  oldest_.back() = original.history->oldestStamp();
  if (!begin_ && original.received >= stale_before_) common_ = std::min(common_, original.newest);
}

/// True if the edge has all its samples; otherwise the next call goes on.
bool TfExcerpt::copySamples(const TransformBuffer& tf, Frame child) {
  if (!begin_) begin_ = (stamp_ == 0 ? common_ : stamp_) - span_;
  const EdgeHistory* const history = tf.history(originals_[child]);
  if (!history || !buffer_->history(child)) {
    copied_until_.reset();  // the frame was forgotten meanwhile
    return true;
  }
  if (stamp_ != 0 && span_ == 0) {
    copyTransform(tf, *history, child);
    return true;
  }
  const SampleRing& samples = history->samples();
  std::size_t i = copied_until_ ? samples.countUntil(*copied_until_) : firstNeeded(*history);
  bool is_complete = i == samples.size();
  for (const std::size_t end = i + kChunk; i < end && !is_complete; ++i) {
    const Frame parent = parentOf(tf, samples[i]);
    buffer_->edges_[child].history->insert(samples[i].stamp, parent, samples[i].parent_from_child);
    ++samples_;
    copied_until_ = samples[i].stamp;
    is_complete = i + 1 == samples.size() || (stamp_ != 0 && samples[i].stamp > stamp_);
  }
  if (is_complete) copied_until_.reset();
  return is_complete;
}

/// For an excerpt of a single time: one sample with the transform at that time is enough.
void TfExcerpt::copyTransform(const TransformBuffer& tf, const EdgeHistory& history, Frame child) {
  EdgeSample scratch;
  const EdgeSample* edge = history.at(stamp_, scratch);
  if (!edge) return;
  const Frame parent = parentOf(tf, *edge);
  buffer_->edges_[child].history->insert(stamp_, parent, edge->parent_from_child);
}

/// The index of the first sample to copy. It is one before the last sample up to `begin_`: whether
/// such a sample exists decides if tf2 interpolates at the stamp of the one after it.
std::size_t TfExcerpt::firstNeeded(const EdgeHistory& history) const {
  const SampleRing& samples = history.samples();
  const std::size_t count = samples.countUntil(std::max(*begin_, history.oldestKept()));
  std::size_t first = count - std::min<std::size_t>(count, 2);
  while (first < samples.size() && samples[first].stamp < history.oldestKept())
    ++first;
  return first;
}

TfExcerpt::Frame TfExcerpt::parentOf(const TransformBuffer& tf, const EdgeSample& sample) {
  if (!last_parent_ || last_parent_->first != sample.parent)
    last_parent_ = {sample.parent, include(tf, sample.parent)};
  return last_parent_->second;
}

}  // namespace link_bounds
