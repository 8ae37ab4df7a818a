// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A name that is looked up is one that is in the zone, or a body beside it.
#include "tools/bag_bounds/zone_watch.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace link_bounds {

ZoneWatch::ZoneWatch(const std::vector<Zone>& zones) {
  for (const Zone& zone : zones)
    zones_.emplace_back().record.zone = zone;
}

void ZoneWatch::watch(Scene& scene, TransformBuffer& tf, ros::Time now) {
  scene_ = &scene;
  tf_ = &tf;
  for (Watched& watched : zones_) {
    std::string& frame = watched.record.zone.frame;
    if (frame.empty()) frame = scene.model()->fixed_frame;
    if (frame == scene.model()->fixed_frame) continue;
    watched.view = &views_.try_emplace(frame, frame, scene, tf, now).first->second;
  }
}

/// A message without transforms leaves the poses as they are.
void ZoneWatch::updateViews(ros::Time now) {
  if (tf_version_ == tf_->version()) return;
  tf_version_ = tf_->version();
  for (auto& [frame, view] : views_)
    have_views_changed_ |= view.update(now);
}

void ZoneWatch::onNews(std::int64_t now, bool is_reported) {
  updateViews(toRosTime(now));
  if (!is_reported) return;
  for (Watched& watched : zones_)
    compare(watched, now);
  have_views_changed_ = false;
}

/// The frame of a zone may move while the scene stands still in the fixed one.
void ZoneWatch::onStep(std::int64_t now, bool is_tick, bool is_reported) {
  updateViews(toRosTime(now));
  if (is_tick) {
    for (auto& [frame, view] : views_)
      have_views_changed_ |= view.expire(toRosTime(now));
  }
  if (!is_reported || !std::exchange(have_views_changed_, false)) return;
  for (Watched& watched : zones_) {
    if (watched.view) compare(watched, now);
  }
}

void ZoneWatch::compare(Watched& watched, std::int64_t now) {
  ++comparisons_;
  const auto visit_box = [&](const std::string& name, const BoxState& state) {
    visit(watched, name, state, now);
  };
  if (watched.view) {
    watched.view->forEach(visit_box);
  } else {
    scene_->forEach(visit_box);
  }
  for (auto body = watched.inside.begin(); body != watched.inside.end();) {
    const auto next = std::next(body);
    if (body->second.seen != comparisons_)
      end(watched, body, StayEnd::kLost, {now, body->second.stamp});
    body = next;
  }
}

void ZoneWatch::visit(Watched& watched, const std::string& name, const BoxState& state,
                      std::int64_t now) {
  if (!state.box) return;
  const RecordTime moment{now, state.stamp};
  const double distance = signedDistance(*state.box, watched.record.zone.box);
  std::optional<NearestToZone>& nearest = watched.record.nearest;
  if (!nearest || distance < nearest->distance) nearest = {name, distance, moment};
  if (distance > 0) {
    if (watched.inside.empty()) return;
    const auto body = watched.inside.find(name);
    if (body != watched.inside.end()) end(watched, body, StayEnd::kLeft, moment);
    return;
  }
  if (!watched.inside.count(name)) enter(watched, name, moment);
  Inside& inside = watched.inside[name];
  inside.seen = comparisons_;
  inside.stamp = state.stamp;
}

void ZoneWatch::enter(Watched& watched, const std::string& name, const RecordTime& now) const {
  ZoneRecord& record = watched.record;
  ++record.entries;
  watched.inside[name] = {record.stays.size(), comparisons_, now.stamp};
  if (record.stays.size() == kMaxStays) {
    watched.inside[name].stay = kMaxStays;
  } else {
    record.stays.push_back({name, now, StayEnd::kReportEnded, {}});
  }
}

void ZoneWatch::end(Watched& watched, std::map<std::string, Inside>::iterator body, StayEnd how,
                    const RecordTime& now) {
  if (body->second.stay < watched.record.stays.size()) {
    Stay& stay = watched.record.stays[body->second.stay];
    stay.end = how;
    stay.left = now;
  }
  watched.inside.erase(body);
}

void ZoneWatch::finish(std::int64_t now) {
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

const Zone* ZoneWatch::neverCompared() const {
  const auto found = std::find_if(zones_.begin(), zones_.end(),
                                  [](const Watched& watched) { return !watched.record.nearest; });
  return found == zones_.end() ? nullptr : &found->record.zone;
}

}  // namespace link_bounds
