// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A map from points to trees.
#include "world/moment/triangle_trees.h"

#include <utility>

namespace link_bounds {
namespace {

/// A list gets a tree if it has not changed for this time: building takes some 1.5 us per triangle.
constexpr std::chrono::milliseconds kSettled(500);

}  // namespace

/// The entry of these points, and whether it is new. The caller sets the points of a new entry
/// after requesting its tree, which may throw. An old entry at this key may be of freed points that
/// had the same address.
std::pair<TriangleTrees::Entry&, bool> TriangleTrees::entryOf(
    const std::shared_ptr<const PointSet>& points) {
  Entry& entry = entries_[points.get()];
  const bool is_new = entry.points.lock() != points;
  if (is_new) entry = Entry();
  return {entry, is_new};
}

TriangleTrees::Tree TriangleTrees::ofMesh(const std::string& uri,
                                          const std::shared_ptr<const PointSet>& points) {
  const auto [entry, is_new] = entryOf(points);
  if (is_new) requests_.mesh(uri, points);
  entry.points = points;
  return entry.triangles;
}

TriangleTrees::Tree TriangleTrees::ofList(const std::shared_ptr<const ObjectContent>& content,
                                          Time now) {
  const auto [entry, is_new] = entryOf(content->bounded.shapes.front().points);
  if (is_new) {
    entry.list = content;
    entry.since = now;
    entry.is_settling = true;
    entry.points = content->bounded.shapes.front().points;
  }
  return entry.triangles;
}

void TriangleTrees::requestSettled(Time now) {
  for (auto& [key, entry] : entries_) {
    if (!entry.is_settling || now - entry.since < kSettled) continue;
    if (auto content = entry.list.lock()) requests_.list(std::move(content));
    entry.is_settling = false;
  }
}

void TriangleTrees::add(const MadeTree& made) {
  ++version_;
  const auto points = made.points.lock();
  const auto found = entries_.find(points.get());
  if (!points || found == entries_.end()) return;
  found->second.triangles = made.triangles;
  found->second.error = made.error;
}

void TriangleTrees::forgetErrors() {
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.error.empty() ? std::next(entry) : entries_.erase(entry);
}

void TriangleTrees::forgetUnused() {
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.points.expired() ? entries_.erase(entry) : std::next(entry);
}

std::vector<std::string> TriangleTrees::errors() const {
  std::vector<std::string> result;
  for (const auto& [key, entry] : entries_) {
    if (!entry.error.empty()) result.push_back(entry.error);
  }
  return result;
}

}  // namespace link_bounds
