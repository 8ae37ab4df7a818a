// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes choose the pairs, BodyDistances measures them.
#include "node/distances/scene_distances.h"

#include <algorithm>
#include <set>
#include <tuple>

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

/// The other way round, because the heap functions of std put the largest first.
bool isFarther(const BoxPair& a, const BoxPair& b) {
  return std::tie(a.distance, a.first, a.second) > std::tie(b.distance, b.first, b.second);
}

}  // namespace

/// Boxes decide in which order bodies are measured, and where a full list ends the search: no pair
/// is nearer than its boxes, nor nearer than 0.
std::optional<ComputedDistances> SceneDistances::compute(
    const std::shared_ptr<const Snapshot>& snapshot, TriangleTrees::Time now,
    const std::function<bool()>& is_cancelled) {
  const Parameters& parameters = snapshot->model->parameters;
  const double limit = parameters.distance_limit;
  bodies_.update(snapshot, now);
  bodies_.setGoal({parameters.distance_accuracy, limit, kMaxSteps});
  if (!findCandidates(*snapshot, is_cancelled)) return std::nullopt;
  PairHeap nearest(static_cast<std::size_t>(parameters.max_pairs));
  left_out_ = 0;
  while (!candidates_.empty()) {
    if (is_cancelled()) return std::nullopt;
    if (nearest.isFull() && std::max(candidates_.front().distance, 0.0) >= nearest.farthest())
      break;
    std::pop_heap(candidates_.begin(), candidates_.end(), isFarther);
    const BoxPair pair = candidates_.back();
    candidates_.pop_back();
    measure(pair, limit, nearest);
  }
  for (const BoxPair& pair : candidates_)
    leaveOut(pair.first, pair.second);
  bodies_.forgetUnused();
  return result(snapshot, nearest.take());
}

/// Fills candidates_, a heap with the nearest boxes first. False if it was cancelled.
bool SceneDistances::findCandidates(const Snapshot& snapshot,
                                    const std::function<bool()>& is_cancelled) {
  const Model& model = *snapshot.model;
  boxes_.clear();
  for (const SnapshotBody& body : snapshot.bodies)
    boxes_.push_back(body.box);
  is_incomplete_.assign(boxes_.size(), false);
  candidates_.clear();
  for (const BoxPair& pair : search_.find(boxes_, model.parameters.distance_limit)) {
    if (is_cancelled()) return false;
    const SnapshotBody& first = snapshot.bodies[pair.first];
    const SnapshotBody& second = snapshot.bodies[pair.second];
    const PairMember one{&nameOf(snapshot, first), first.link};
    const PairMember other{&nameOf(snapshot, second), second.link};
    if (isPair(model, one, other)) candidates_.push_back(pair);
  }
  std::make_heap(candidates_.begin(), candidates_.end(), isFarther);
  return true;
}

/// Of a pair that may push another one out, nothing is remembered: there may be very many.
void SceneDistances::measure(const BoxPair& pair, double limit, PairHeap& nearest) {
  const std::optional<BodyDistance> found =
      nearest.isFull() ? bodies_.findOnce(pair.first, pair.second, nearest.farthest())
                       : bodies_.find(pair.first, pair.second);
  if (!found) {  // coordinates above 1e60 m
    is_incomplete_[pair.first] = true;
    is_incomplete_[pair.second] = true;
  } else if (found->lower <= limit) {
    if (const auto one_too_many = nearest.add({pair.first, pair.second, *found}))
      leaveOut(one_too_many->first, one_too_many->second);
  }
}

void SceneDistances::leaveOut(std::size_t first, std::size_t second) {
  ++left_out_;
  is_incomplete_[first] = true;
  is_incomplete_[second] = true;
}

ComputedDistances SceneDistances::result(const std::shared_ptr<const Snapshot>& snapshot,
                                         const std::vector<FoundPair>& pairs) const {
  const std::vector<SnapshotBody>& bodies = snapshot->bodies;
  ComputedDistances result{snapshot, {}, {}, {}, left_out_};
  result.array.header = snapshot->header;
  for (const FoundPair& pair : pairs) {
    result.array.distances.push_back(
        toMessage(*snapshot, bodies[pair.first], bodies[pair.second], pair.distance));
    ++result.levels[result.array.distances.back().level];
  }
  result.nearest = nearestOf(result.array.distances, snapshot->model->parameters.distance_limit);
  std::vector<std::string>& incomplete = result.array.incomplete;
  incomplete = snapshot->incomplete;
  const std::set<std::string> known(incomplete.begin(), incomplete.end());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_incomplete_[i]) continue;
    const std::string& name = nameOf(*snapshot, bodies[i]);
    if (known.count(name) == 0) incomplete.push_back(name);
  }
  return result;
}

}  // namespace link_bounds
