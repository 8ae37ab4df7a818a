// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares each box with the record of its name.
#include "tools/bag_bounds/boxes/box_records.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace link_bounds {
namespace {

void extend(BoxRecord& record, const Aabb& box, const RecordTime& now) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    if (!record.has_box || box.min()[k] < record.min[axis].value)
      record.min[axis] = {box.min()[k], now};
    if (!record.has_box || box.max()[k] > record.max[axis].value)
      record.max[axis] = {box.max()[k], now};
  }
  record.has_box = true;
}

void addSpeed(BoxRecord& record, const Aabb& box, const RecordTime& now, double timeout) {
  const auto speed = record.last
                         ? centreSpeed(*record.last, record.last_stamp, box, now.stamp, timeout)
                         : std::nullopt;
  if (speed && (!record.speed || *speed > record.speed->value)) record.speed = {*speed, now};
  record.last = box;
  record.last_stamp = now.stamp;
}

void endGap(BoxRecord& record, std::int64_t now) {
  if (record.gap) record.gaps_length += std::max<std::int64_t>(now - *record.gap, 0);
  record.gap.reset();
}

/// An object that was placed counts as covered since its stamp. An object that never was placed is
/// not compared at all, so its record is partial.
void endWait(BoxRecord& record, bool was_placed) {
  const std::int64_t waited = std::exchange(record.waited, 0);
  if (was_placed) {
    record.covered += waited;
  } else if (record.partial.empty()) {
    record.partial = record.waits;
  }
  record.waits.clear();
  record.waiting.reset();
}

/// Begins and ends waits for tf. Another marker may come while one waits. True if one waits now.
template <class GetReason>
bool takeWait(BoxRecord& record, const LiveObject& object, const GetReason& reason) {
  const bool waits = object.problem == TransformProblem::kWaiting;
  if (record.waiting && (!waits || object.content != record.waiting))
    endWait(record, object.boxed.content == record.waiting);
  if (!waits) return false;
  record.waiting = object.content;
  record.waits = reason();
  return true;
}

/// Adds a box or a gap. There is no gap before the first box of a name.
template <class GetReason>
void add(BoxRecord& record, const BoxState& state, std::int64_t now, double timeout, bool waits,
         const GetReason& reason) {
  if (!state.box) record.last.reset();
  record.is_waiting = waits && !state.box;
  if (record.is_waiting) {
    if (!record.has_box) record.reason = record.waits;
    return;
  }
  if (state.box) {
    endGap(record, now);
    if (!waits && state.incomplete && record.partial.empty()) record.partial = reason();
    extend(record, *state.box, {now, state.stamp});
    addSpeed(record, *state.box, {now, state.stamp}, timeout);
  } else if (!record.has_box) {
    record.reason = reason();
  } else if (!record.gap) {
    if (record.gaps++ == 0) {
      record.first_gap = now;
      record.reason = reason();
    }
    record.gap = now;
  }
}

/// Share of its time in which the object had a box, 0 to 1.
double shareOf(const BoxRecord& object) {
  if (object.time > 0)
    return static_cast<double>(object.covered) / static_cast<double>(object.time);
  return object.has_box ? 1 : 0;
}

}  // namespace

std::optional<double> centreSpeed(const Aabb& from, std::int64_t from_stamp, const Aabb& to,
                                  std::int64_t to_stamp, double timeout) {
  const double seconds = static_cast<double>(to_stamp - from_stamp) / 1e9;
  if (from_stamp == 0 || to_stamp <= from_stamp || (timeout > 0 && seconds > timeout))
    return std::nullopt;
  const double speed = (to.center() - from.center()).norm() / seconds;
  return std::isfinite(speed) ? std::optional(speed) : std::nullopt;
}

bool BoxRecords::add(const Scene& scene, std::int64_t now) {
  const double timeout = scene.model()->parameters.timeout;
  bool has_changed = false;
  passTo(now);
  const std::vector<BoxRecord*> before = std::exchange(present_, {});
  for (BoxRecord* object : before)
    object->is_there = false;
  links_.resize(scene.model()->links.size());
  scene.forEach([&](const SceneBody& body) {
    BoxRecord* record = recordOf(body);
    if (!record) return;
    if (record->name.empty()) record->name = body.name;
    if (body.object && !std::exchange(record->is_there, true)) present_.push_back(record);
    const bool had_box = record->has_box && !record->gap;
    has_changed |= body.link && had_box != body.state.box.has_value();
    const auto reason = [&] { return scene.reason(body); };
    const bool waits = body.object && takeWait(*record, *body.object, reason);
    link_bounds::add(*record, body.state, now, timeout, waits, reason);
  });
  for (BoxRecord* object : before) {
    if (object->is_there) continue;
    object->last.reset();
    if (object->waiting) endWait(*object, false);
  }
  return has_changed;
}

/// Null if there are too many objects.
BoxRecord* BoxRecords::recordOf(const SceneBody& body) {
  if (body.link) return &links_[*body.link];
  ObjectKey key = *body.key;
  key.set = 0;  // a box of another node may come again in another set
  const auto found = objects_.find(key);
  if (found != objects_.end()) return &found->second;
  if (objects_.size() < kMaxObjects) {
    BoxRecord& record = objects_[key];
    record.is_object = true;
    return &record;
  }
  ++left_out_;
  return nullptr;
}

/// Adds the time since the last call to all objects that were there.
void BoxRecords::passTo(std::int64_t now) {
  const std::int64_t passed = std::max<std::int64_t>(now - last_, 0);
  for (BoxRecord* object : present_) {
    object->time += passed;
    if (object->is_waiting) {
      object->waited += passed;
    } else if (object->has_box && !object->gap) {
      object->covered += passed;
    }
  }
  last_ = now;
}

void BoxRecords::finish(std::int64_t now) {
  passTo(now);
  present_.clear();
  const auto finish = [now](BoxRecord& record) {
    record.is_lost = record.gap.has_value();
    if (record.partial.empty()) record.partial = record.waits;
    endGap(record, now);
  };
  for (BoxRecord& link : links_)
    finish(link);
  for (auto& [key, record] : objects_) {
    finish(record);
    record.coverage = shareOf(record);
  }
}

std::vector<BoxRecord> BoxRecords::records() const {
  std::vector<BoxRecord> result = links_;
  for (const auto& [key, record] : objects_)
    result.push_back(record);
  return result;
}

bool BoxRecords::hasLinkBox() const {
  return std::any_of(links_.begin(), links_.end(), [](const auto& link) { return link.has_box; });
}

}  // namespace link_bounds
