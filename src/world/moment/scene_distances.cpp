// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects pairs by their boxes and measures them with BodyDistances.
#include "world/moment/scene_distances.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

#include "world/moment/compared_bodies.h"
#include "world/moment/distance_message.h"

namespace link_bounds {
namespace {

/// Pairs of tree nodes that one search may compare, about 1 us each. Links of public robots need
/// fewer than 10,000; the limit bounds the time that hostile meshes take.
constexpr std::size_t kMaxSteps = 100'000;

/// Reversed order for the heap functions of std, which put the largest first.
bool isFarther(const BoxPair& a, const BoxPair& b) {
  return std::tie(a.distance, a.first, a.second) > std::tie(b.distance, b.first, b.second);
}

}  // namespace

/// If there may be too many pairs, measures them in the order of their boxes' distance. Once the
/// list is full, the search ends at the first pair whose boxes are farther apart than the farthest
/// listed pair: no pair is nearer than its boxes, nor nearer than 0.
std::optional<ComputedDistances> SceneDistances::compute(const MomentPtr& moment,
                                                         MomentPairs& pairs,
                                                         TriangleTrees::Time now,
                                                         const std::function<bool()>& is_cancelled,
                                                         const Concerns& concerns) {
  const Parameters& parameters = moment->model->parameters;
  const double limit = parameters.distance_limit;
  bodies_.update(moment, now);
  bodies_.setGoal(
      {parameters.distance_accuracy, limit, kMaxSteps, parameters.distance_relative_accuracy});
  if (!findCandidates(moment, pairs, is_cancelled, concerns)) return std::nullopt;
  const auto max_pairs = static_cast<std::size_t>(parameters.max_pairs);
  const bool has_order = candidates_.size() > max_pairs;
  if (has_order) std::make_heap(candidates_.begin(), candidates_.end(), isFarther);
  PairHeap nearest(max_pairs, candidates_.size());
  left_out_ = 0;
  while (!candidates_.empty()) {
    if (is_cancelled()) return std::nullopt;
    if (nearest.isFull() && std::max(candidates_.front().distance, 0.0) >= nearest.farthest())
      break;
    if (has_order) std::pop_heap(candidates_.begin(), candidates_.end(), isFarther);
    const BoxPair pair = candidates_.back();
    candidates_.pop_back();
    measure(pair, limit, nearest);
  }
  for (const BoxPair& pair : candidates_)
    leaveOut(pair.first, pair.second);
  bodies_.forgetUnused();
  return result(moment, nearest.take());
}

/// Fills candidates_ and not_compared_. False if it was cancelled.
bool SceneDistances::findCandidates(const MomentPtr& moment, MomentPairs& pairs,
                                    const std::function<bool()>& is_cancelled,
                                    const Concerns& concerns) {
  const double limit = moment->model->parameters.distance_limit;
  const auto is_candidate = [&](const BoxPair& pair) {
    return pair.distance <= limit && (!concerns || concerns(pair.first, pair.second));
  };
  const auto read = [&](const NearPairs& near) {
    candidates_.clear();
    std::copy_if(near.compared.rbegin(), near.compared.rend(), std::back_inserter(candidates_),
                 is_candidate);
    not_compared_ = near.left_out;
    are_pairs_listed_ = near.is_listed;
  };
  if (!pairs.read(moment, limit, read, is_cancelled)) return false;
  is_incomplete_.assign(moment->bodies.size(), false);
  is_compared_ = areCompared(*moment, candidates_);
  return true;
}

/// Caches nothing for pairs after the list is full, because there may be very many.
std::optional<BodyDistance> SceneDistances::distanceOf(const BoxPair& pair,
                                                       const PairHeap& nearest) {
  if (nearest.isFull()) return bodies_.findOnce(pair.first, pair.second, nearest.farthest());
  if (are_carried_) return bodies_.follow(pair.first, pair.second);
  return bodies_.find(pair.first, pair.second);
}

void SceneDistances::measure(const BoxPair& pair, double limit, PairHeap& nearest) {
  const std::optional<BodyDistance> found = distanceOf(pair, nearest);
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

ComputedDistances SceneDistances::result(const MomentPtr& moment,
                                         const std::vector<FoundPair>& pairs) const {
  const Parameters& parameters = moment->model->parameters;
  ComputedDistances result;
  result.moment = moment;
  result.left_out = left_out_;
  DistanceArray& array = result.array;
  array.header = moment->header;
  array.limit = parameters.distance_limit;
  array.accuracy = parameters.distance_accuracy;
  array.distances.reserve(pairs.size());
  for (const FoundPair& pair : pairs) {
    array.distances.push_back(toMessage(*moment, pair));
    result.pairs.emplace_back(pair.first, pair.second);
    ++result.levels[array.distances.back().level];
  }
  result.nearest = nearestOf(array.distances, parameters.distance_limit);
  for (const BoxPair& pair : not_compared_)
    array.not_compared.push_back(toMessage(*moment, pair));
  addNames(result);
  return result;
}

void SceneDistances::addNames(ComputedDistances& result) const {
  const Moment& moment = *result.moment;
  DistanceArray& array = result.array;
  array.incomplete = moment.incomplete;
  std::set<std::string> incomplete(array.incomplete.begin(), array.incomplete.end());
  for (std::size_t i = 0; i < moment.bodies.size(); ++i) {
    const std::string& name = moment.name(moment.bodies[i]);
    if (is_incomplete_[i] && incomplete.insert(name).second) array.incomplete.push_back(name);
  }
  for (std::size_t i = 0; i < moment.bodies.size(); ++i) {
    const std::string& name = moment.name(moment.bodies[i]);
    result.is_complete.push_back(is_compared_[i] && are_pairs_listed_[i] &&
                                 incomplete.count(name) == 0);
    if (result.is_complete.back()) array.complete.push_back(name);
  }
}

}  // namespace link_bounds
