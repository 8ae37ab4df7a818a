// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/watch/zone_watch.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace link_bounds {
namespace {

/// The distance of two boxes changes by no more than this times the way of their points.
constexpr double kPerWay = 1.7321;  // sqrt(3), rounded up

}  // namespace

const char* toText(StayEnd end) {
  constexpr std::array<const char*, 3> kTexts{"left", "lost", "report_ended"};
  return kTexts.at(static_cast<std::size_t>(end));
}

ZoneWatch::ZoneWatch(const std::vector<Zone>& zones, std::function<bool()> gives_up)
    : gives_up_(std::move(gives_up)) {
  for (const Zone& zone : zones)
    zones_.emplace_back().record.zone = zone;
}

void ZoneWatch::watch(Scene& scene, TransformBuffer& tf, ros::Time now) {
  scene_ = &scene;
  tf_ = &tf;
  edges_.emplace(tf);
  for (Watched& watched : zones_) {
    std::string& frame = watched.record.zone.frame;
    if (frame.empty()) frame = scene.model()->fixed_frame;
    FrameView* view = nullptr;
    if (frame != scene.model()->fixed_frame)
      view = &views_.try_emplace(frame, frame, scene, tf, now).first->second;
    auto group = groups_.find(frame);
    if (group == groups_.end())
      group =
          groups_.emplace(frame, Group{view, BodyMotions(scene, *edges_, view), {}, {}, {}}).first;
    group->second.zones.push_back(&watched);
  }
}

/// Skips messages without transforms, which leave all poses as they are.
void ZoneWatch::updateViews(ros::Time now) {
  if (tf_version_ == tf_->version()) return;
  tf_version_ = tf_->version();
  for (auto& [frame, view] : views_)
    have_views_changed_ |= view.update(now);
}

void ZoneWatch::onNews(std::int64_t now, bool is_reported) {
  updateViews(toRosTime(now));
  for (auto& [frame, group] : groups_)
    compareOrRemember(group, now, is_reported);
  have_views_changed_ = false;
}

void ZoneWatch::compareOrRemember(Group& group, std::int64_t now, bool is_reported) {
  if (is_reported) {
    compare(group, now);
  } else if (!group.is_compared) {
    group.motions.remember();
  }
}

/// The frame of a zone may move while the scene stands still in the fixed one.
void ZoneWatch::onStep(std::int64_t now, bool is_tick, bool is_reported) {
  updateViews(toRosTime(now));
  if (is_tick) {
    for (auto& [frame, view] : views_)
      have_views_changed_ |= view.expire(toRosTime(now));
  }
  const bool have_changed = std::exchange(have_views_changed_, false);
  for (auto& [frame, group] : groups_) {
    if (group.view && have_changed) compareOrRemember(group, now, is_reported);
    if (is_tick && is_reported) sample(group, now);
  }
}

/// Adds up how long all links that have a box could be compared.
void ZoneWatch::sample(Group& group, std::int64_t now) {
  if (!group.view) return;
  const std::int64_t passed = std::max<std::int64_t>(now - group.sampled.value_or(now), 0);
  if (group.has_boxes) group.time += passed;
  if (group.has_boxes && group.is_whole) group.whole_time += passed;
  group.sampled = now;
  group.has_boxes = false;
  group.is_whole = true;
  scene_->forEach([&group](const SceneBody& body) {
    if (!body.link || !body.state.box) return;
    group.has_boxes = true;
    group.is_whole &= group.view->placed(body).state.box.has_value();
  });
  if (!group.has_boxes || group.was_whole) return;
  if (!group.since) group.since = now;
  const TransformBuffer::Frame zone = group.view->frame(), fixed = *scene_->frames.fixedFrame();
  begins_.look(*tf_, zone, now);
  begins_.look(*tf_, fixed, now);
  group.was_whole = group.is_whole;
  const auto since = std::max(*group.since, begins_.allSince(*tf_, zone, fixed, now).value_or(0));
  if (group.is_whole && now - since > kRemembered) note(&ZoneRecord::is_late, group);
}

void ZoneWatch::note(bool ZoneRecord::*fault, const Group& group) {
  for (Watched* watched : group.zones)
    watched->record.*fault = true;
}

/// Notes zones with lost links: nothing is examined after the last comparison.
void ZoneWatch::noteEnd(const Group& group) {
  if (group.view && group.has_boxes && !group.is_whole) note(&ZoneRecord::is_lost, group);
}

void ZoneWatch::compare(Group& group, std::int64_t now) {
  ++comparisons_;
  const auto visit_rest = [&](BodyNumber number, const std::string& name,
                              const BodyMotion& motion) {
    lookAtRest(group, {number, name, {}, &motion}, now);
  };
  group.motions.forEach(visit_rest, [&](BodyNumber number, const std::string& name,
                                        const BoxState& state, const BodyMotion* motion) {
    if (!state.box) return;
    for (Watched* watched : group.zones)
      visit(*watched, {number, name, state, motion}, now);
  });
  for (Watched* watched : group.zones) {
    for (auto body = watched->inside.begin(); body != watched->inside.end();) {
      const auto next = std::next(body);
      if (body->second.seen != comparisons_)
        end(*watched, body, StayEnd::kLost, {now, body->second.stamp});
      body = next;
    }
  }
  sample(group, now);
  group.compared = now;
  group.is_compared = true;
}

void ZoneWatch::visit(Watched& watched, const Seen& body, std::int64_t now) {
  const RecordTime moment{now, body.state.stamp};
  const double distance = signedDistance(*body.state.box, watched.record.zone.box);
  ZoneRecord& record = watched.record;
  if (!record.nearest || distance < record.nearest->distance)
    record.nearest = {body.name, distance, moment};
  record.clearance = std::min(record.clearance, std::max(distance, 0.0));
  if (distance > 0) {
    if (body.motion && body.motion->is_begin_new) visitBegin(watched, body, now);
    if (body.motion) lookBetween(watched, body, distance, now);
    if (watched.inside.empty()) return;
    const auto inside = watched.inside.find(body.number);
    if (inside != watched.inside.end()) end(watched, inside, StayEnd::kLeft, moment);
    return;
  }
  auto inside = watched.inside.find(body.number);
  if (inside == watched.inside.end())
    inside = enter(watched, body, moment, outsideAt(watched, body));
  inside->second.seen = comparisons_;
  inside->second.stamp = body.state.stamp;
}

/// The body may have been inside the zone when its motion began: if a marker had its place before
/// tf showed that, or if the report begins within the motion.
void ZoneWatch::visitBegin(Watched& watched, const Seen& body, std::int64_t now) const {
  const MotionSpan& span = body.motion->span;
  const RecordTime begin{now - (span.end - span.begin), span.begin};
  const double distance = signedDistance(body.motion->before, watched.record.zone.box);
  if (distance > 0 || watched.inside.count(body.number) != 0) return;
  ZoneRecord& record = watched.record;
  if (distance < record.nearest->distance) record.nearest = {body.name, distance, begin};
  record.clearance = 0;
  enter(watched, body, begin, std::nullopt);
}

/// The last stamp outside, for a body that is inside now. Nothing if it may have been inside
/// before.
std::optional<std::int64_t> ZoneWatch::outsideAt(const Watched& watched, const Seen& body) {
  const bool was_outside =
      body.motion && signedDistance(body.motion->before, watched.record.zone.box) > 0;
  return was_outside ? std::optional(body.motion->span.begin) : std::nullopt;
}

void ZoneWatch::lookAtRest(Group& group, const Seen& body, std::int64_t now) {
  const auto& since_replaced = body.motion->since_replaced;
  for (Watched* watched : group.zones)
    lookAtRest(*watched, body, since_replaced ? now - *since_replaced : group.compared);
}

/// Examines a motion in the scene's fixed frame after the last transform of the zone's frame, or
/// the rest of an object until it was replaced. Only a replaced object's stay goes on.
void ZoneWatch::lookAtRest(Watched& watched, const Seen& body, std::int64_t now) {
  ZoneRecord& record = watched.record;
  const double before = signedDistance(body.motion->before, record.zone.box);
  if (before <= 0) return;
  const double wanted = std::max(record.nearest->distance - kZoneAccuracy, 0.0);
  const double clearance = before - kPerWay * body.motion->way;
  if (clearance > wanted) {
    record.clearance = std::min(record.clearance, clearance);
  } else if (body.motion->view_from_target) {
    take(watched, body, searchZone(*tf_, *body.motion, record.zone.box, wanted, gives_up_), now);
  } else {
    take(watched, body, undecidedZone("tf forgot where the frame of the zone was"), now);
  }
  if (body.motion->since_replaced) return;
  const auto inside = watched.inside.find(body.number);
  if (inside != watched.inside.end())
    end(watched, inside, StayEnd::kLost, {now, inside->second.stamp});
}

/// The body is outside now. Each pose is within half of the way from one of both ends.
void ZoneWatch::lookBetween(Watched& watched, const Seen& body, double distance, std::int64_t now) {
  ZoneRecord& record = watched.record;
  const double before = signedDistance(body.motion->before, record.zone.box);
  if (before <= 0) return;
  const double wanted = std::max(record.nearest->distance - kZoneAccuracy, 0.0);
  const double clearance = (before + distance - kPerWay * body.motion->way) / 2;
  if (clearance > wanted) {
    record.clearance = std::min(record.clearance, clearance);
  } else {
    take(watched, body, searchZone(*tf_, *body.motion, record.zone.box, wanted, gives_up_), now);
  }
}

void ZoneWatch::take(Watched& watched, const Seen& body, const ZoneSearch& found,
                     std::int64_t now) {
  ZoneRecord& record = watched.record;
  const auto at = [&](std::int64_t stamp) {
    return RecordTime{now - (body.motion->span.end - stamp), stamp};
  };
  if (found.nearest < record.nearest->distance)
    record.nearest = {body.name, found.nearest, at(found.nearest_stamp)};
  record.clearance = std::min(record.clearance, found.clearance);
  if (!found.undecided.empty() && record.undecided++ == 0)
    record.first_undecided = body.name + ": " + found.undecided;
  for (const ZoneSearch::Crossing& crossing : found.crossings) {
    auto inside = watched.inside.find(body.number);
    if (inside == watched.inside.end())
      inside = enter(watched, body, at(crossing.is_entry ? crossing.after : crossing.before),
                     crossing.is_entry ? std::optional(crossing.before) : std::nullopt);
    inside->second.stamp = crossing.is_entry ? crossing.after : crossing.before;
    if (!crossing.is_entry) end(watched, inside, StayEnd::kLeft, at(crossing.after));
  }
}

ZoneWatch::InsideBody ZoneWatch::enter(Watched& watched, const Seen& body, const RecordTime& now,
                                       std::optional<std::int64_t> outside_at) const {
  ZoneRecord& record = watched.record;
  ++record.entries;
  const std::size_t stay = record.stays.size();
  const Stay entry{body.name, now, outside_at, StayEnd::kReportEnded, {}, {}};
  if (stay < kMaxStays) record.stays.push_back(entry);
  if (!record.first || now.recorded < record.first->entered.recorded) record.first = entry;
  return watched.inside.insert_or_assign(body.number, Inside{stay, comparisons_, now.stamp}).first;
}

void ZoneWatch::end(Watched& watched, InsideBody body, StayEnd how, const RecordTime& now) {
  if (body->second.stay < watched.record.stays.size()) {
    Stay& stay = watched.record.stays[body->second.stay];
    stay.end = how;
    stay.left = now;
    stay.inside_at = body->second.stamp;
  }
  watched.inside.erase(body);
}

void ZoneWatch::endMotions() {
  begins_.clear();
  for (auto& item : groups_) {
    Group& group = item.second;
    group.motions.finish([&](BodyNumber number, const std::string& name, const BodyMotion& motion) {
      lookAtRest(group, {number, name, {}, &motion}, group.compared);
    });
    group.is_compared = group.was_whole = false;
    noteEnd(group);
    group.since.reset();
  }
}

void ZoneWatch::finish(std::int64_t now) {
  for (auto& [frame, group] : groups_) {
    sample(group, now);
    noteEnd(group);
    if (group.time == 0) continue;
    for (Watched* watched : group.zones)
      watched->record.coverage =
          static_cast<double>(group.whole_time) / static_cast<double>(group.time);
  }
  for (Watched& watched : zones_) {
    while (!watched.inside.empty()) {
      const auto body = watched.inside.begin();
      end(watched, body, StayEnd::kReportEnded, {now, body->second.stamp});
    }
  }
}

std::vector<ZoneRecord> ZoneWatch::records() const {
  std::vector<ZoneRecord> result;
  for (const Watched& watched : zones_)
    result.push_back(watched.record);
  return result;
}

bool ZoneWatch::wasEntered() const {
  return std::any_of(zones_.begin(), zones_.end(),
                     [](const Watched& watched) { return watched.record.entries > 0; });
}

std::uint64_t ZoneWatch::undecided() const {
  std::uint64_t count = 0;
  for (const Watched& watched : zones_)
    count += watched.record.undecided;
  return count;
}

const Zone* ZoneWatch::neverCompared() const {
  const auto found = std::find_if(zones_.begin(), zones_.end(),
                                  [](const Watched& watched) { return !watched.record.nearest; });
  return found == zones_.end() ? nullptr : &found->record.zone;
}

}  // namespace link_bounds
