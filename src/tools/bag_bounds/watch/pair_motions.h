// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance of two bodies during their motions between two messages.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/bag_bounds/watch/pair_motion_search.h"
#include "world/history/way_bound.h"
#include "world/moment/live_bodies.h"
#include "world/moment/moment_pairs.h"

namespace link_bounds {

/// Two bodies by their indices in the moment.
struct PairMotion {
  std::size_t first;
  std::size_t second;
  /// Proven: the bodies never came nearer [m].
  double clearance;
  /// The nearest pose that was examined, if any.
  std::optional<BodyDistance> nearest;
  std::int64_t stamp = 0;     ///< of that pose [ns]
  std::int64_t duration = 0;  ///< from it to the end of the motion [ns]
  std::string undecided;      ///< why they may have come nearer than `wanted`; "" if they did not
};

/// A body of a moment.
struct MovedBody : FramedBody {
  static constexpr std::int64_t kForEver = std::numeric_limits<std::int64_t>::max();

  std::int64_t begin = 0;  ///< stamps of its motion [ns]; 0: it does not move
  std::int64_t end = 0;
  std::int64_t since = 0;         ///< its motion is known from this stamp on
  std::int64_t reported = 0;      ///< examined from here on beside objects that are placed now
  std::int64_t rested = 0;        ///< motions beside its last place were examined until here
  bool was_there = false;         ///< its motion to `end` is known, or it does not move
  bool is_placed_now = false;     ///< placed in this step, maybe with an earlier stamp
  bool goes_on = false;           ///< the next moment has it and examines its motion from `end` on
  std::int64_t until = kForEver;  ///< when it was deleted
  std::int64_t moved_until = 0;   ///< last stamp of its motion, if it was deleted; else 0
  double way = 0;                 ///< in the fixed frame, since its motion was last examined [m]

  bool isGone() const { return until != kForEver; }
};

/// Remembers a proven distance of each pair. The pair cannot come within a limit before its bodies
/// have moved by the difference. So most motions need a bound on their way, but no distance.
class PairMotions {
 public:
  struct Handlers {
    /// Clearances above this need not be refined [m]; nothing if the pair is not of interest.
    std::function<std::optional<double>(const Moment&, const BoxPair&)> wanted;
    /// Called for each motion that was examined, also if its clearance is above `wanted`.
    std::function<void(const Moment&, const PairMotion&)> on_motion;
    /// The first body moved, maybe near the second one, an object that was deleted meanwhile and
    /// whose place is forgotten.
    std::function<void(const std::string&, const std::string&)> on_forgotten;
    std::function<bool()> gives_up;
  };

  /// Arguments of all steps. `tf` must be the same one in all calls.
  struct Means {
    MomentPairs& pairs;
    const LiveBodies& bodies;
    const TransformBuffer& tf;
    const Handlers& handlers;
  };

  /// Call it when boxes change before the first moment, at the record time `now` [ns]. Links, and
  /// objects that follow a frame, then move from here, even if they are lost at the first moment.
  /// Does nothing after the first moment, until finish().
  void remember(const Scene& scene, std::int64_t now);

  /// Call it with each moment, while `means.bodies` still has the bodies of the last one. If one of
  /// these is lost, or does not go on, examines the motions of others beside its last place, since
  /// its stamp. An object that is not in the moment was deleted or replaced at the record time
  /// `now` [ns]. Until then, by the clock of the stamps, others are examined beside it. If it moved
  /// before, it rests from its last stamp on.
  void begin(const MomentPtr& moment, std::int64_t now, const Means& means);

  /// Examines the motions of all pairs of the moment's model up to this moment. A motion begins at
  /// the last stamp of the body, even if that was several moments ago. The motion of a new link
  /// begins at the first stamp at which tf knows it, that of a new object which was placed once at
  /// its stamp. Motions end where an object was replaced. Call it after begin(), when
  /// `means.bodies` has the bodies of the moment.
  void look(const Means& means);

  /// Ends all motions. The next moment counts as the first one.
  void finish(const Means& means);

 private:
  using Frame = TransformBuffer::Frame;

  struct Lease {
    std::int64_t stamp = 0;
    double distance = -std::numeric_limits<double>::infinity();  ///< proven at `stamp` [m]
  };

  /// A link by its index + 1; an object by 0 and its content, which is a new one when the object
  /// comes again. Names would not do: they need not be unique.
  struct BodyKey {
    std::size_t link;
    std::weak_ptr<const ObjectContent> object;

    BodyKey(std::optional<std::size_t> index_of_link,
            const std::shared_ptr<const ObjectContent>& content)
        : link(index_of_link ? *index_of_link + 1 : 0), object(content) {}
    explicit BodyKey(const Moment::Body& body) : BodyKey(body.link, body.object) {}
    bool operator<(const BodyKey& other) const {
      return link != other.link ? link < other.link : object.owner_before(other.object);
    }
  };

  using PairKey = std::pair<BodyKey, BodyKey>;

  struct Known {
    std::int64_t stamp;  ///< the last one [ns]
    std::int64_t since;
    std::uint64_t pass;  ///< of the last moment with this body
    std::size_t place;   ///< index among the bodies of that moment
    bool moves;
    std::int64_t reported = 0;  ///< see MovedBody
  };

  /// An object that is gone, kept while others have stamps before its end. An object that moved is
  /// stored twice: it moves until its last stamp, then it rests.
  struct Gone {
    Moment::Body seen;
    std::shared_ptr<const Body> body;
    std::int64_t since;  ///< its motion, or its rest, is known from this stamp on
    std::int64_t until;  ///< the end of that; when it was deleted, by the clock of stamps
    bool rests;          ///< stands in the fixed frame; else it is where its frame is
  };

  void findGone(const Moment& moment, std::int64_t now, const Means& means);
  void compareClocks(std::int64_t stamp, std::int64_t now);
  std::int64_t stampAt(std::int64_t recorded) const;
  void addGone(std::size_t i, std::int64_t until, const Means& means);
  std::int64_t oldestNeeded(std::int64_t newest) const;
  void forgetGone();
  MomentPtr withGone(const MomentPtr& moment, const TransformBuffer& tf);
  MovedBody moverOf(const Gone& gone, const Moment::Body& body, const TransformBuffer& tf) const;
  void findBegins(const Moment& moment, const TransformBuffer& tf,
                  std::vector<MovedBody>& last_movers);
  void forgetObjects();
  void findWays(const TransformBuffer& tf, Frame fixed);
  MovedBody moverOf(const Moment::Body& body, const TransformBuffer& tf) const;
  static std::vector<BoxPair> near(const MomentPtr& moment, double way, const Means& means);
  void lookAt(const BoxPair& pair, const Means& means);
  void lookAtForgotten(const Means& means) const;
  void lookAtRests(const std::vector<MovedBody>& movers, const Means& means);
  void lookAtRest(const BoxPair& pair, MovedBody first, MovedBody second, const Means& means);
  void lookDuring(MotionSpan span, const Moment& moment, const BoxPair& pair, MovedBody& first,
                  MovedBody& second, double wanted, Lease& lease, const Means& means);

  void walk(const MovedBody& first, const MovedBody& second, MotionSpan span, double wanted,
            const Means& means, PairMotion& motion) const;

  MomentPtr moment_;
  MomentPtr last_;
  std::vector<Gone> gone_;
  std::map<std::string, std::int64_t> forgotten_;  ///< objects that are gone, with their `until`
  std::int64_t forgotten_until_ = 0;               ///< the latest of these
  std::optional<std::int64_t> delay_;              ///< min of record time minus stamp [ns]
  std::size_t needed_gone_ = 0;     ///< number of gone_ among the last bodies of the moment
  std::vector<MovedBody> movers_;   ///< by body of the moment
  std::map<BodyKey, Known> known_;  ///< while the bodies exist
  std::map<PairKey, std::pair<std::uint64_t, Lease>> leases_;  ///< with the pass that renewed it
  std::optional<EdgeWays> edges_;                              ///< of the tf of all calls
  std::map<Frame, WayBound> ways_;                             ///< by target
  std::uint64_t pass_ = 0;
};

}  // namespace link_bounds
