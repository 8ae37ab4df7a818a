// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which boxes of other nodes there are: each message replaces one set of boxes.
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
  /// The header of the connection. roscpp keeps it as long as the publisher is registered, also
  /// while the connection is lost. Null: the sender never ends.
  boost::shared_ptr<const void> connection = nullptr;
};

/// Whether the node of that name has ended in order. A connection also ends where a node was killed
/// and started again, and where a new master does not know all nodes yet. Asked of each sender at
/// each tick.
using HasLeft = std::function<bool(const std::string& node)>;

/// A sender may be a relay that passes on the boxes of several robots. So a set is what a sender
/// says in one frame of links of which at least one is the same in each message. Messages without
/// links are one more set of their sender and frame, which becomes that of a robot whose first
/// message has all of its boxes, the static ones in the same place. An empty message of a sender
/// that was started again does not end what it had before: it may not know its robot yet. Once it
/// has sent boxes, what it does not send again falls silent, also what is static. Functions return
/// true if a box, a stamp or an incomplete name changed.
class NeighbourSets {
 public:
  /// How long after the end of a connection [s] its boxes go, unless a new one brings a message:
  /// roscpp tries again 0.1 s after it lost a connection.
  static constexpr double kFarewell = 0.5;

  explicit NeighbourSets(LiveObjects& objects) : objects_(objects) {}
  NeighbourSets(const NeighbourSets&) = delete;
  NeighbourSets& operator=(const NeighbourSets&) = delete;

  /// Boxes that the set had and that the message does not name are gone. A box whose name belongs
  /// to another object has the frame in its name; if that name is taken, too, it is refused.
  bool take(const AxisAlignedBoxArray& array, const NeighbourSender& sender, ros::Time now);

  /// Removes the boxes of senders that have ended in order, and forgets sets without boxes. Others
  /// whose connection has ended are silent.
  bool removeEnded(ros::SteadyTime now, const HasLeft& has_left);

  /// What was logged may be logged again.
  void forgetLog() { log_.forget(); }

 private:
  struct Set {
    std::uint64_t number;
    std::string frame;
    std::set<std::string> links;             ///< in the newest message
    std::set<ObjectKey> keys;                ///< of its objects
    boost::weak_ptr<const void> connection;  ///< of the newest message
    bool is_fresh = false;                   ///< since the last call of removeEnded()
    std::uint64_t removals = 0;  ///< of all objects, when `keys` were last compared with them
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
  std::uint64_t sets_ = 0;  ///< so far
  RefusalLog log_{"the box", "further boxes"};
};

}  // namespace link_bounds
