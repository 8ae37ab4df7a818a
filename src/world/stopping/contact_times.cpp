// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs within distance_limit are measured. All other pairs are farther apart than that, and at
// least as far as their boxes; of these, only the earliest contact is kept, if it comes before all
// measured ones. Pairs that no joint moves relative to each other are not measured: in a typical
// scene these are most pairs, those of two objects.
#include "world/stopping/contact_times.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "world/stopping/contact_reach.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// Published times are at most this long after the header's stamp; nobody plans further ahead [ns].
constexpr std::int64_t kHorizon = 10'000'000'000;

ros::Time toTime(std::int64_t nanoseconds) {
  return timeFrom(std::max<std::int64_t>(nanoseconds, 0));
}

class Contacts {
 public:
  Contacts(const WayBoxes& boxes, const StopRules& rules, std::int64_t end)
      : moment_(*boxes.moment), end_(end), first_(end) {
    for (std::size_t i = 0; i < boxes.ways.size(); ++i) {
      reaches_.emplace_back(boxes.ways[i], moment_.bodies[i].box, rules);
    }
  }

  /// Whether the distance of two bodies can change.
  bool canMeet(std::size_t a, std::size_t b) const { return reaches_[a].canMeet(reaches_[b]); }

  /// Adds the pairs that were measured.
  void add(const ComputedDistances& computed) {
    limit_ = computed.array.limit;
    complete_ = computed.is_complete;
    for (std::size_t i = 0; i < computed.pairs.size(); ++i)
      add(computed.pairs[i].first, computed.pairs[i].second, computed.array.distances[i].distance);
  }

  /// Bodies farther apart than this cannot touch before the earliest contact found so far [m].
  double margin() const {
    double largest = 0;
    for (const ContactReach& reach : reaches_)
      largest = std::max(largest, reach.until(first_));
    return 2 * largest;
  }

  bool needsOthers() const {
    return margin() > limit_ || std::count(complete_.begin(), complete_.end(), false) > 0;
  }

  /// Adds the earliest contact of the pairs that were not measured, by the distance of their boxes.
  void addOthers(std::vector<BoxPair> pairs) {
    const auto cannot_meet = [this](const BoxPair& pair) {
      return !canMeet(pair.first, pair.second);
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), cannot_meet), pairs.end());
    std::sort(pairs.begin(), pairs.end(), [](const BoxPair& a, const BoxPair& b) {
      return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
    });
    std::optional<Found> earliest;
    for (const BoxPair& pair : pairs) {
      if (measured_.count({pair.first, pair.second})) continue;
      const bool is_far = complete_[pair.first] && complete_[pair.second];
      const double distance = std::max(pair.distance, is_far ? limit_ : 0);
      const auto time =
          reaches_[pair.first].earliestContact(reaches_[pair.second], distance, first_);
      if (!time || (*time >= first_ && earliest)) continue;
      earliest = {pair.first, pair.second, distance, *time};
      first_ = std::min(first_, *time);
    }
    if (earliest) found_.push_back(*earliest);
  }

  /// Writes the contacts, the earliest first.
  void write(EarliestContactArray& array) {
    std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return std::tie(a.time, a.first, a.second) < std::tie(b.time, b.first, b.second);
    });
    for (const Found& found : found_) {
      EarliestContact& contact = array.contacts.emplace_back();
      contact.first = moment_.name(moment_.bodies[found.first]);
      contact.second = moment_.name(moment_.bodies[found.second]);
      contact.earliest = toTime(found.time);
      contact.distance = found.distance;
    }
    array.valid_until = toTime(first_);
  }

 private:
  struct Found {
    std::size_t first;
    std::size_t second;
    double distance;
    std::int64_t time;
  };

  void add(std::size_t a, std::size_t b, double distance) {
    measured_.insert({a, b});
    const auto time = reaches_[a].earliestContact(reaches_[b], distance, end_);
    if (!time) return;
    found_.push_back({a, b, distance, *time});
    first_ = std::min(first_, *time);
  }

  const Moment& moment_;
  const std::int64_t end_;
  std::int64_t first_;  ///< the earliest contact so far [ns]
  std::vector<ContactReach> reaches_;
  std::set<std::pair<std::size_t, std::size_t>> measured_;
  std::vector<Found> found_;
  std::vector<bool> complete_;
  double limit_ = 0;
};

}  // namespace

std::optional<ComputedContacts> ContactTimes::compute(PastScene& scene, const StopRules& rules,
                                                      const JointStates* states,
                                                      TriangleTrees::Time now,
                                                      const std::function<bool()>& is_cancelled) {
  if (!is_whole_) forget();
  is_whole_ = false;
  BodyWays ways(scene, rules, WayPurpose::kContact, states);
  const WayBoxes boxes = wayBoxes(scene, ways, [](const PastBody& body, const BodyWay& way) {
    return linkBox(*body.bounded, way.pose);
  });
  const ros::Time stamp = boxes.moment->header.stamp;
  const auto clock = nanosecondsOf(scene.now);
  const std::int64_t start = stamp.isZero() ? clock : std::min(nanosecondsOf(stamp), clock);
  Contacts contacts(boxes, rules, start + kHorizon);
  const auto can_meet = [&contacts](std::size_t a, std::size_t b) {
    return contacts.canMeet(a, b);
  };
  const auto computed = distances_.compute(boxes.moment, pairs_, now, is_cancelled, can_meet);
  if (!computed) return std::nullopt;
  contacts.add(*computed);
  if (contacts.needsOthers()) {
    std::vector<BoxPair> others;
    const auto read = [&others](const NearPairs& near) { others = near.compared; };
    if (!pairs_.read(boxes.moment, contacts.margin(), read, is_cancelled)) return std::nullopt;
    contacts.addOthers(std::move(others));
  }
  ComputedContacts result;
  result.array.header = boxes.moment->header;
  result.array.incomplete = computed->array.incomplete;
  contacts.write(result.array);
  const std::vector<Moment::Body>& bodies = boxes.moment->bodies;
  const bool has_link =
      std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.link; });
  if (!boxes.have_poses || !has_link) result.array.valid_until = ros::Time();
  result.problem = boxes.problem;
  is_whole_ = true;
  return result;
}

void ContactTimes::forget() {
  distances_ = SceneDistances(requests_);
  pairs_.freeMemory();
}

}  // namespace link_bounds
