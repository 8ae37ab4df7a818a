// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bookkeeping of the boxes of other nodes: each message replaces one set of boxes.
#pragma once

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>
#include <functional>
#include <list>
#include <optional>

#include "world/bodies/live_objects.h"
#include "world/bodies/neighbour_boxes.h"
#include "world/log/refusal_log.h"

namespace link_bounds {

struct NeighbourSender {
  std::string name;  ///< of the node
  /// The connection header. roscpp keeps it as long as the publisher is registered, even while the
  /// connection is lost. Null: the sender never ends.
  boost::shared_ptr<const void> connection = nullptr;
};

/// Whether the node of that name was shut down in order. A connection also ends if a node is killed
/// and started again, or while a new master does not know all nodes yet. Called for each sender at
/// each tick.
using HasLeft = std::function<bool(const std::string& node)>;

/// A sender may be a relay that passes on the boxes of several robots. So a set is the boxes from
/// one sender in one frame whose messages share at least one link name with the previous one.
/// Messages without links form another set of their sender and frame. A new robot takes over that
/// set if its first message has all of its boxes, the static ones in the same place. After a sender
/// was started again, an empty message does not end its earlier boxes, because it may not know its
/// robot yet. Once it has sent boxes, earlier boxes that it does not send again fall silent, even
/// static ones. Functions return true if a box, a stamp or an incomplete name changed.
class NeighbourSets {
 public:
  /// Boxes are removed this long after the end of their connection [s], unless a new connection
  /// brings a message: roscpp reconnects 0.1 s after it lost a connection.
  static constexpr double kFarewell = 0.5;

  explicit NeighbourSets(LiveObjects& objects) : objects_(objects) {}
  NeighbourSets(const NeighbourSets&) = delete;
  NeighbourSets& operator=(const NeighbourSets&) = delete;

  /// Removes boxes of the set that the message does not name. If the name of a box belongs to
  /// another object, the frame is added to it; if that name is taken, too, the box is refused.
  bool take(const AxisAlignedBoxArray& array, const NeighbourSender& sender, ros::Time now);

  /// Removes the boxes of senders that were shut down in order, and forgets sets without boxes.
  /// Boxes of other senders whose connection ended stay until they fall silent.
  bool removeEnded(ros::SteadyTime now, const HasLeft& has_left);

  /// Lines that were logged may be logged again.
  void forgetLog() { log_.forget(); }

 private:
  struct Set {
    std::uint64_t number;
    std::string frame;
    std::set<std::string> links;             ///< link names in the newest message
    std::set<ObjectKey> keys;                ///< of the objects in the set
    boost::weak_ptr<const void> connection;  ///< connection of the newest message
    bool is_fresh = false;                   ///< got a message since the last removeEnded()
    std::uint64_t removals = 0;  ///< LiveObjects::removals() when `keys` were last checked
  };

  struct Sender {
    std::list<Set> sets;
    boost::weak_ptr<const void> connection;
    bool has_connection = false;
    std::optional<ros::SteadyTime> lost_since;
  };

  static bool isNewRobot(const Sender& sender, const std::set<std::string>& links,
                         const std::string& frame);
  bool haveAllOf(const NeighbourBoxes& boxes, const std::string& sender, const Set& set) const;
  bool endStatic(Sender& sender, ros::Time now);
  Set* setOf(Sender& sender, const std::string& name, const NeighbourBoxes& boxes,
             bool& is_changed);
  bool replace(Set& set, const std::string& sender, NeighbourBoxes boxes, ros::Time now);
  std::map<ObjectKey, ObjectContent> named(const Set& set, const std::string& sender,
                                           NeighbourBoxes& boxes) const;
  ObjectKey freeKey(const std::vector<std::string>& names, const Set& set,
                    const std::map<ObjectKey, ObjectContent>& taken) const;
  bool removeAll(const Set& set);
  bool isLost(Sender& sender, ros::SteadyTime now) const;
  void forgetEmptySets(Sender& sender) const;

  LiveObjects& objects_;
  std::map<std::string, Sender> senders_;
  std::uint64_t sets_ = 0;  ///< number of sets made so far
  RefusalLog log_{"the box", "further boxes"};
};

}  // namespace link_bounds
