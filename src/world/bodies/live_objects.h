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

/// Until a fixed frame is known the objects are kept and none has a box. All functions that return
/// bool tell whether a box, what is in it, a stamp or an incomplete name changed.
class LiveObjects {
 public:
  using Objects = std::map<ObjectKey, LiveObject>;

  explicit LiveObjects(FrameTracker& frames) : frames_(frames), placer_(frames) {}

  /// From now on the edges that place an object once are needed edges of tf, too, as long as the
  /// object is there, see TransformBuffer::neededIntake().
  void needPlaces() { needs_places_ = true; }

  /// In the order of ~boxes.
  const Objects& objects() const { return objects_; }

  /// How many objects have been removed so far.
  std::uint64_t removals() const { return removals_; }

  /// The objects of a name, whatever their set: at most one that has the name, and those that are
  /// refused because of it.
  std::pair<Objects::const_iterator, Objects::const_iterator> named(const ObjectKey& key) const;

  /// The object that has the name of `key`, but for that of `key` itself; null if none has.
  const LiveObject* otherOfName(const ObjectKey& key) const;

  /// Starts over with the fixed frame and timeout that the tracker has now. Objects that were
  /// placed once are carried over by the newest transform between the two frames, as soon as there
  /// is one. Neighbours that are silent are removed.
  void adopt(ros::Time now);

  /// Adds an object or replaces it. Until the new one can be placed, the previous box stays, named
  /// as incomplete.
  bool put(const ObjectKey& key, ObjectContent content, ros::Time now);
  bool remove(const ObjectKey& key);
  /// By its name; null if none has the mesh.
  const LiveObject* firstWithMesh(const std::string& uri) const;
  /// A neighbour's that is static falls silent, too, from now on. Its name stays then.
  bool endStatic(const ObjectKey& key, ros::Time now);
  /// Removes all objects of markers. Neighbours stay: they end with the messages of their sender.
  bool removeAll();
  /// Removes the objects of markers that this publisher was the last to send.
  bool removeAllOf(const std::string& publisher);

  /// Gives a mesh, or why there is none, to the objects that wait for it or have an older version.
  bool fillMesh(const std::string& uri, const LoadedMesh& mesh, ros::Time now);

  /// To be called after each update of the poses, and before any other function reads them.
  bool update(ros::Time now);

  /// After the clock began to run. What is left of a lifetime stays as it was, waiting begins
  /// again, and no stamp of a box is ahead of `now`.
  bool startClock(ros::Time now);

  /// The same after the clock jumped back. What was placed before stays there until it is sent
  /// again. Only then is it placed by tf of the new time, which may know its stamp, too; what is
  /// static places it before.
  bool restart(ros::Time now);

  /// To be called now and then, after that of the poses: ends lifetimes, drops stale boxes and
  /// those of silent neighbours, gives up waiting. A neighbour that has been silent for kForget
  /// times the timeout is forgotten.
  bool expire(ros::Time now);
  static constexpr double kForget = 10;

  /// The objects that were given up since the last call and still are.
  std::vector<const LiveObject*> takeGivenUp();

  /// An object that is sent again and again before there is a transform at its stamp.
  struct NeverPlaced {
    const LiveObject* object;
    double ahead;  ///< its stamp minus that of the newest transform [s]
  };

  /// Those that wait for longer than others until they are given up, in frames that tf connects.
  std::vector<NeverPlaced> neverPlaced(ros::Time now);

  /// The frame whose transform places the object: its header frame, or the fixed frame in which it
  /// was placed, while that one is not carried over.
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
  bool has_jumped_back_ = false;  ///< the clock
  ObjectPlacer placer_;
  ObjectClock clock_;
  Objects objects_;
  std::uint64_t removals_ = 0;
  std::map<FrameTracker::Frame, std::set<LiveObject*>> followers_;  ///< by header frame
  std::map<std::string, std::set<LiveObject*>> mesh_users_;         ///< by URI
  std::optional<FrameTracker::Frame> fixed_frame_;                  ///< in which the boxes are
  std::vector<ObjectKey> given_up_;
  std::size_t waiting_ = 0;  ///< objects whose transform is not there yet
};

}  // namespace link_bounds
