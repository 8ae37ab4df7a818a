// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of objects that come and go, kept up to date with tf and with time.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_store.h"
#include "world/bodies/object_clock.h"
#include "world/bodies/object_placer.h"
#include "world/model/object_key.h"

namespace link_bounds {

/// Before a fixed frame is known, objects are kept without boxes. All functions that return bool
/// tell whether a box, its content, a stamp or an incomplete name changed.
class LiveObjects {
 public:
  using Objects = std::map<ObjectKey, LiveObject>;

  explicit LiveObjects(FrameTracker& frames) : frames_(frames), placer_(frames) {}

  /// From now on, tf also counts as needed the edges that place an object once, as long as the
  /// object exists, see TransformBuffer::neededIntake().
  void needPlaces() { needs_places_ = true; }

  /// In the order of ~boxes.
  const Objects& objects() const { return objects_; }

  /// How many objects have been removed so far.
  std::uint64_t removals() const { return removals_; }

  /// The objects with the name of `key` in any set: max one that owns the name, and those that are
  /// refused because of it.
  std::pair<Objects::const_iterator, Objects::const_iterator> named(const ObjectKey& key) const;

  /// The object in another set that owns the name of `key`; null if there is none.
  const LiveObject* otherOfName(const ObjectKey& key) const;

  /// Starts over with the tracker's current fixed frame and timeout. Objects that were placed once
  /// are transformed to it by the newest transform between the two frames, as soon as there is one.
  /// Silent neighbours are removed.
  void adopt(ros::Time now);

  /// Adds or replaces an object. Until the new one can be placed, the previous box stays and is
  /// listed as incomplete.
  bool put(const ObjectKey& key, ObjectContent content, ros::Time now);
  bool remove(const ObjectKey& key);
  /// Of the objects with this mesh, the first by name; null if there is none.
  const LiveObject* firstWithMesh(const std::string& uri) const;
  /// From now on a static neighbour's box can fall silent, too. Its name then stays.
  bool endStatic(const ObjectKey& key, ros::Time now);
  /// Removes all objects of markers. Neighbours stay: they end with the messages of their sender.
  bool removeAll();
  /// Removes the objects of markers that this publisher was the last to send.
  bool removeAllOf(const std::string& publisher);

  /// Passes a mesh, or the reason why there is none, to the objects that wait for it or have an
  /// older version.
  bool fillMesh(const std::string& uri, const LoadedMesh& mesh, ros::Time now);

  /// To be called after each update of the poses, and before any other function reads them.
  bool update(ros::Time now);

  /// After the clock began to run. Remaining lifetimes stay the same, waiting begins again, and
  /// stamps of boxes ahead of `now` are set to `now`.
  bool startClock(ros::Time now);

  /// As startClock(), after the clock jumped back. Placed objects stay where they are until they
  /// are sent again. Only then are they placed again, by transforms of the new time, which may
  /// cover their stamps. Static transforms can place an object even before that.
  bool restart(ros::Time now);

  /// To be called now and then, after FrameTracker::expire(). Ends lifetimes, drops stale boxes and
  /// those of silent neighbours, and gives up waiting. Neighbours that were silent for kForget
  /// times the timeout are removed.
  bool expire(ros::Time now);
  static constexpr double kForget = 10;

  /// Objects whose wait was given up since the last call and that still have no transform.
  std::vector<const LiveObject*> takeGivenUp();

  /// An object that is sent again and again before there is a transform at its stamp.
  struct NeverPlaced {
    const LiveObject* object;
    double ahead;  ///< its stamp minus the stamp of the newest transform [s]
  };

  /// Objects that have waited, over several receipts, longer than a single wait may last, although
  /// tf connects their frame.
  std::vector<NeverPlaced> neverPlaced(ros::Time now);

  /// The frame whose transform places the object: its header frame, or the former fixed frame as
  /// long as the placement is not transformed to the current one.
  const std::string& neededFrame(const LiveObject& object) const;

  /// Why the object is incomplete, in words; "" if it is not.
  std::string reason(const LiveObject& object) const;

 private:
  void leaveFixedFrame();
  void follow(LiveObject& object);
  void release(LiveObject& object);
  bool sendAgain(LiveObject& object, ros::Time now);
  StampTime stampTime(const LiveObject& object, bool had_stamp) const;
  Objects::iterator erase(Objects::iterator object);
  template <class Key>
  static void erase(const Key& key, LiveObject& object, std::map<Key, std::set<LiveObject*>>& sets);
  bool removeIf(const std::function<bool(const Objects::value_type&)>& is_over);
  bool isSilent(const LiveObject& object, std::int64_t now, double timeouts = 1) const;
  bool dropSilent(LiveObject& object, ros::Time now);
  bool nameAgain(const ObjectKey& key, LiveObject& object, ros::Time now);
  bool refresh(LiveObject& object, ros::Time now);
  bool refreshAll(ros::Time now);
  bool refreshFollowing(ros::Time now);
  bool refreshNotCarried(ros::Time now);
  bool refreshWaiting(ros::Time now);
  TransformProblem bound(LiveObject& object, ros::Time now, BoxState& state);

  FrameTracker& frames_;
  bool needs_places_ = false;
  bool has_jumped_back_ = false;  ///< whether the clock ever jumped back
  ObjectPlacer placer_;
  ObjectClock clock_;
  Objects objects_;
  std::uint64_t removals_ = 0;
  std::map<FrameTracker::Frame, std::set<LiveObject*>> followers_;  ///< by header frame
  std::map<std::string, std::set<LiveObject*>> mesh_users_;         ///< by URI
  std::optional<FrameTracker::Frame> fixed_frame_;                  ///< in which the boxes are
  std::vector<ObjectKey> given_up_;
  std::size_t waiting_ = 0;  ///< number of objects that wait for a transform
};

}  // namespace link_bounds
