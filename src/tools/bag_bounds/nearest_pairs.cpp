// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Trees come back within the request, so that nothing waits for them.
#include "tools/bag_bounds/nearest_pairs.h"

#include "tools/command_line/interrupt.h"
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

/// Time stands still: lists of markers settle at once.
constexpr TriangleTrees::Time kNow{};
constexpr TriangleTrees::Time kSettled = kNow + std::chrono::hours(1);

struct Interrupted {};

void throwIfInterrupted() {
  if (isInterrupted()) throw Interrupted();
}

}  // namespace

NearestPairs::NearestPairs(LoadTree load_tree)
    : load_tree_(std::move(load_tree)), distances_(requests()) {}

TreeRequests NearestPairs::requests() {
  TreeRequests requests;
  requests.mesh = [this](const auto& uri, const auto& points) {
    const LoadedTree tree = load_tree_(uri);
    MadeTree made{points, nullptr, tree.error};
    if (tree.points == points) {
      made.triangles = tree.triangles;
    } else if (made.error.empty()) {
      made.error = uri + " was replaced meanwhile; run this again";
    }
    if (!made.error.empty()) problems_.insert(made.error);
    distances_.trees().add(made);
  };
  requests.list = [this](const std::shared_ptr<const ObjectContent>& list) {
    throwIfInterrupted();
    distances_.trees().add(listTree(*list, throwIfInterrupted));
  };
  return requests;
}

void NearestPairs::add(const Scene& scene, std::int64_t now) {
  latest_.clear();
  const auto computed = compute(momentOf(scene));
  if (!computed) return;
  const DistanceArray& array = computed->array;
  has_compared_ |= !array.complete.empty() || !array.distances.empty();
  for (std::size_t i = computed->moment->incomplete.size(); i < array.incomplete.size(); ++i)
    incomplete_.insert(array.incomplete[i]);
  const double limit = scene.model()->parameters.distance_limit;
  latest_ = array.distances;
  for (const Distance& distance : latest_) {
    was_undercut_ |= distance.distance < limit;
    keep(distance, now);
  }
}

/// Nothing if it was interrupted: without all trees, distances are smaller than they need be.
std::optional<ComputedDistances> NearestPairs::compute(const MomentPtr& moment) try {
  auto computed = distances_.compute(moment, moment_pairs_, kNow, isInterrupted);
  const std::uint64_t version = distances_.trees().version();
  distances_.trees().requestSettled(kSettled);
  if (distances_.trees().version() != version)
    computed = distances_.compute(moment, moment_pairs_, kNow, isInterrupted);
  return computed;
} catch (const Interrupted&) {
  return std::nullopt;
}

void NearestPairs::keep(const Distance& distance, std::int64_t now) {
  const std::pair<std::string, std::string> names{distance.first, distance.second};
  const auto found = pairs_.find(names);
  const RecordTime when{now, static_cast<std::int64_t>(distance.stamp.toNSec())};
  if (found != pairs_.end()) {
    if (distance.distance < found->second.distance.distance) found->second = {distance, when};
  } else if (pairs_.size() < kMaxPairs) {
    pairs_[names] = {distance, when};
  } else {
    ++left_out_;
  }
}

std::vector<NearestPair> NearestPairs::pairs() const {
  std::vector<NearestPair> result;
  for (const auto& [names, pair] : pairs_)
    result.push_back(pair);
  return result;
}

}  // namespace link_bounds
