// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangle trees are loaded within the request, so no computation waits for them.
#include "tools/bag_bounds/watch/nearest_pairs.h"

#include <algorithm>

#include "tools/command_line/interrupt.h"
#include "world/moment/distance_message.h"
#include "world/moment/object_body.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// Two fixed times, so that lists of markers settle at once.
constexpr TriangleTrees::Time kNow{};
constexpr TriangleTrees::Time kSettled = kNow + std::chrono::hours(1);

/// A contact is a finding for any limit, also for 0.
bool isFinding(const Distance& distance, double limit) {
  return distance.distance < limit || distance.distance == 0;
}

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

void NearestPairs::add(const Scene& scene, const TransformBuffer& tf, std::int64_t now) {
  latest_.clear();
  const MomentPtr moment = momentOf(scene);
  const PairMotions::Handlers handlers = motionHandlers();
  motions_.begin(moment, now, {moment_pairs_, distances_.bodies(), tf, handlers});
  now_ = now;
  const auto computed = compute(moment);
  if (computed) {
    addNow(*computed, scene.model()->parameters.distance_limit, now);
    motions_.look({moment_pairs_, distances_.bodies(), tf, handlers});
  }
  was_interrupted_ = isInterrupted();
}

void NearestPairs::endMotions(const TransformBuffer& tf) {
  motions_.finish({moment_pairs_, distances_.bodies(), tf, motionHandlers()});
  was_interrupted_ = isInterrupted();
}

void NearestPairs::addNow(const ComputedDistances& computed, double limit, std::int64_t now) {
  const DistanceArray& array = computed.array;
  has_compared_ |= !array.complete.empty() || !array.distances.empty();
  for (std::size_t i = computed.moment->incomplete.size(); i < array.incomplete.size(); ++i)
    incomplete_.insert(array.incomplete[i]);
  latest_ = array.distances;
  for (const Distance& distance : latest_) {
    was_undercut_ |= isFinding(distance, limit);
    keep(distance, {now, nanosecondsOf(distance.stamp)});
  }
}

PairMotions::Handlers NearestPairs::motionHandlers() {
  PairMotions::Handlers handlers;
  handlers.wanted = [this](const Moment& moment, const BoxPair& pair) -> std::optional<double> {
    const double limit = moment.model->parameters.distance_limit;
    const auto found =
        find(moment.name(moment.bodies[pair.first]), moment.name(moment.bodies[pair.second]));
    if (found == pairs_.end()) return limit;
    if (found->second.clearance <= 0) return std::nullopt;
    const double nearest = found->second.distance.distance;
    return nearest < limit ? std::max(nearest - kPairAccuracy, 0.0) : limit;
  };
  handlers.on_motion = [this](const Moment& moment, const PairMotion& motion) {
    take(moment, motion);
  };
  handlers.on_forgotten = [this](const std::string& first, const std::string& second) {
    const auto found = find(first, second);
    if (found != pairs_.end()) found->second.clearance = 0;
    takeUndecided(first, second, "the second one was deleted before it is known how they moved");
  };
  handlers.gives_up = isInterrupted;
  return handlers;
}

void NearestPairs::take(const Moment& moment, const PairMotion& motion) {
  const double limit = moment.model->parameters.distance_limit;
  if (motion.nearest && motion.nearest->lower <= limit) {
    Distance distance = toMessage(moment, FoundPair{motion.first, motion.second, *motion.nearest});
    distance.stamp = timeFrom(motion.stamp);
    was_undercut_ |= isFinding(distance, limit);
    keep(distance, {now_ - motion.duration, motion.stamp});
  }
  const auto& first = moment.name(moment.bodies[motion.first]);
  const auto& second = moment.name(moment.bodies[motion.second]);
  const auto found = find(first, second);
  if (found != pairs_.end())
    found->second.clearance = std::min(found->second.clearance, motion.clearance);
  if (!motion.undecided.empty()) takeUndecided(first, second, motion.undecided);
}

void NearestPairs::takeUndecided(const std::string& first, const std::string& second,
                                 const std::string& why) {
  if (undecided_++ == 0) first_undecided_ = first + " and " + second + ": " + why;
}

/// std::nullopt if it was interrupted: without all trees, lower bounds are smaller than necessary.
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

void NearestPairs::keep(const Distance& distance, const RecordTime& when) {
  const auto found = find(distance.first, distance.second);
  if (found != pairs_.end()) {
    NearestPair& pair = found->second;
    if (distance.distance >= pair.distance.distance) return;
    pair = {distance, when, std::min(pair.clearance, distance.distance)};
  } else if (pairs_.size() < kMaxPairs) {
    pairs_[{distance.first, distance.second}] = {distance, when, distance.distance};
  } else {
    ++left_out_;
  }
}

/// Looks for both orders of the names: objects may come again in another order.
NearestPairs::Pairs::iterator NearestPairs::find(const std::string& first,
                                                 const std::string& second) {
  const auto found = pairs_.find({first, second});
  return found != pairs_.end() ? found : pairs_.find({second, first});
}

std::vector<NearestPair> NearestPairs::pairs() const {
  std::vector<NearestPair> result;
  for (const auto& [names, pair] : pairs_)
    result.push_back(pair);
  return result;
}

}  // namespace link_bounds
