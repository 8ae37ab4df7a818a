// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes choose the pairs, BodyDistances measures them.
#include "node/distances/scene_distances.h"

#include <algorithm>

#include "link_bounds/ros/messages.h"

namespace link_bounds {
namespace {

/// Pairs of tree nodes that one search may compare, about 1 us each. Links of public robots need
/// fewer than 10,000; the limit bounds the time that hostile meshes take.
constexpr std::size_t kMaxSteps = 100'000;

const std::string& nameOf(const Snapshot& snapshot, const SnapshotBody& body) {
  return body.link ? snapshot.model->links[*body.link].name : body.object->bounded.name;
}

/// 0 if both are.
std::int64_t olderStamp(std::int64_t a, std::int64_t b) {
  if (a == 0 || b == 0) return std::max(a, b);
  return std::min(a, b);
}

std::uint8_t toLevel(DistanceLevel level) {
  switch (level) {
    case DistanceLevel::kBox:
      return Distance::BOX;
    case DistanceLevel::kHull:
      return Distance::HULL;
    case DistanceLevel::kMesh:
      return Distance::MESH;
  }
  return Distance::BOX;
}

Distance toMessage(const Snapshot& snapshot, const SnapshotBody& first, const SnapshotBody& second,
                   const BodyDistance& found) {
  Distance message;
  message.first = nameOf(snapshot, first);
  message.second = nameOf(snapshot, second);
  message.stamp.fromNSec(static_cast<std::uint64_t>(olderStamp(first.stamp, second.stamp)));
  message.distance = found.lower;
  message.distance_max = found.upper;
  message.on_first = toPoint(found.on_first);
  message.on_second = toPoint(found.on_second);
  message.normal.x = found.normal.x();
  message.normal.y = found.normal.y();
  message.normal.z = found.normal.z();
  message.level = toLevel(found.level);
  return message;
}

/// If no pair is within the limit: nothing is nearer than that.
Distance nearestOf(const std::vector<Distance>& distances, double limit) {
  const auto nearest =
      std::min_element(distances.begin(), distances.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (nearest != distances.end()) return *nearest;
  Distance none;
  none.distance = limit;
  none.distance_max = limit;
  none.level = Distance::BOX;
  return none;
}

void addIncomplete(const std::string& name, std::vector<std::string>& incomplete) {
  if (std::find(incomplete.begin(), incomplete.end(), name) == incomplete.end())
    incomplete.push_back(name);
}

}  // namespace

std::optional<ComputedDistances> SceneDistances::compute(
    const std::shared_ptr<const Snapshot>& snapshot, TriangleTrees::Time now,
    const std::function<bool()>& is_cancelled) {
  const Model& model = *snapshot->model;
  const std::vector<SnapshotBody>& bodies = snapshot->bodies;
  const double limit = model.parameters.distance_limit;
  bodies_.update(snapshot, now);
  bodies_.setGoal({model.parameters.distance_accuracy, limit, kMaxSteps});
  boxes_.clear();
  for (const SnapshotBody& body : bodies)
    boxes_.push_back(body.box);
  ComputedDistances result{snapshot, {}, {}, {}};
  result.array.header = snapshot->header;
  result.array.incomplete = snapshot->incomplete;
  for (const BoxPair& pair : search_.find(boxes_, limit)) {
    if (is_cancelled()) return std::nullopt;
    const SnapshotBody& first = bodies[pair.first];
    const SnapshotBody& second = bodies[pair.second];
    const std::string& first_name = nameOf(*snapshot, first);
    const std::string& second_name = nameOf(*snapshot, second);
    if (!isPair(model, {&first_name, first.link}, {&second_name, second.link})) continue;
    const std::optional<BodyDistance> found = bodies_.find(pair.first, pair.second);
    if (!found) {  // coordinates above 1e60 m
      addIncomplete(first_name, result.array.incomplete);
      addIncomplete(second_name, result.array.incomplete);
    } else if (found->lower <= limit) {
      result.array.distances.push_back(toMessage(*snapshot, first, second, *found));
      ++result.levels[result.array.distances.back().level];
    }
  }
  result.nearest = nearestOf(result.array.distances, limit);
  return result;
}

}  // namespace link_bounds
