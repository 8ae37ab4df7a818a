// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How near two bodies came between two messages.
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
  /// The nearest pose of all that were looked at, if any was.
  std::optional<BodyDistance> nearest;
  std::int64_t stamp = 0;     ///< of that pose
  std::int64_t duration = 0;  ///< from it to the end of the motion [ns]
  std::string undecided;  ///< why it may have come below `wanted` nevertheless; "" if it did not
};

/// A body of a moment.
struct MovedBody : FramedBody {
  static constexpr std::int64_t kForEver = std::numeric_limits<std::int64_t>::max();

  std::int64_t begin = 0;  ///< stamps of its motion; 0: does not move
  std::int64_t end = 0;
  std::int64_t since = 0;         ///< its motion is known from this stamp on
  std::int64_t reported = 0;      ///< its motion is examined from here on beside what is placed now
  std::int64_t rested = 0;        ///< others near its last place were examined until then
  bool was_there = false;         ///< its motion to `end` is known, or it does not move
  bool is_placed_now = false;     ///< in this step, where it stands since an earlier stamp
  bool goes_on = false;           ///< the next moment has it, too, and looks at what follows `end`
  std::int64_t until = kForEver;  ///< when it was deleted
  std::int64_t moved_until = 0;   ///< before that; 0: it is there, or does not move
  double way = 0;  ///< in the fixed frame, of this step and what was not looked at before [m]

  bool isGone() const { return until != kForEver; }
};

/// Remembers of each pair how far apart it was proven to be. It cannot come within a limit before
/// its bodies have moved by the rest: most motions need one look at the edges between them, and no
/// distance.
class PairMotions {
 public:
  struct Handlers {
    /// Clearances above this need not be refined [m]; nothing if the pair is not of interest.
    std::function<std::optional<double>(const Moment&, const BoxPair&)> wanted;
    /// A motion of a pair of the moment, whose clearance may be below that.
    std::function<void(const Moment&, const PairMotion&)> on_motion;
    /// The body of the first name moved, maybe beside the object of the second one, which was
    /// deleted meanwhile: where that was is forgotten.
    std::function<void(const std::string&, const std::string&)> on_forgotten;
    std::function<bool()> gives_up;
  };

  /// What a look needs. `tf` is the same one in all calls.
  struct Means {
    MomentPairs& pairs;
    const LiveBodies& bodies;
    const TransformBuffer& tf;
    const Handlers& handlers;
  };

  /// To be called before the first moment, at the record time `now` [ns], when boxes change: links,
  /// and objects that follow a frame, move from there, also those that are lost when it begins.
  /// Does nothing after that, until finish().
  void remember(const Scene& scene, std::int64_t now);

  /// To be called with each moment, while the bodies are those of the last one. Where one of these
  /// is lost, or does not go on, others are looked at beside its last place, since its stamp. An
  /// object that is not in the moment was deleted or replaced at `now`, the record time [ns], by
  /// the clock of the stamps: until then, others are looked at beside it. Where it moved, it rests
  /// from its last stamp on.
  void begin(const MomentPtr& moment, std::int64_t now, const Means& means);

  /// Looks at all motions from the last moments to this one, of the pairs of the moment's model,
  /// also of bodies that were not in the last one, however long ago they were; of a link that is
  /// first there, from the first stamp at which tf knows it; and from the stamp of an object that
  /// was placed once to now, when it is first there. They are over where an object was replaced. To
  /// be called after begin(), when the bodies are those of the moment.
  void look(const Means& means);

  /// All motions are over. The next moment is a first one.
  void finish(const Means& means);

 private:
  using Frame = TransformBuffer::Frame;

  struct Lease {
    std::int64_t stamp = 0;
    double distance = -std::numeric_limits<double>::infinity();  ///< proven then [m]
  };

  /// A link by its index + 1, an object by 0 and its content, which is another one when it comes
  /// again. Names need not be unique.
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
    std::int64_t stamp;  ///< the last one
    std::int64_t since;
    std::uint64_t pass;  ///< of that moment
    std::size_t place;   ///< among its bodies
    bool moves;
    std::int64_t reported = 0;  ///< as of MovedBody
  };

  /// An object that is gone, while stamps of others are older than that. One that moved is there
  /// twice: until its last stamp it moves, then it rests.
  struct Gone {
    Moment::Body seen;
    std::shared_ptr<const Body> body;
    std::int64_t since;  ///< its motion, or its rest, is known from this stamp on
    std::int64_t until;  ///< the end of that; when it was deleted, by the clock of stamps
    bool rests;          ///< in the fixed frame; else it is where its frame is
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
  std::int64_t forgotten_until_ = 0;               ///< the last one of these
  std::optional<std::int64_t> delay_;  ///< the smallest one of a record time after its stamp [ns]
  std::size_t needed_gone_ = 0;        ///< so many of them are the last bodies of the moment
  std::vector<MovedBody> movers_;      ///< of the bodies of the moment
  std::map<BodyKey, Known> known_;     ///< while the bodies exist
  std::map<PairKey, std::pair<std::uint64_t, Lease>> leases_;  ///< with the pass that renewed it
  std::optional<EdgeWays> edges_;                              ///< of the tf of all calls
  std::map<Frame, WayBound> ways_;                             ///< by target
  std::uint64_t pass_ = 0;
};

}  // namespace link_bounds
