// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/bodies/neighbour_sets.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

bool share(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&b](const auto& name) { return b.count(name) > 0; });
}

/// If a message has no frame, it is refused, but its links alone tell the set that it belongs to.
bool canBeSame(const std::string& frame, const std::string& other) {
  return frame == other || frame.empty() || other.empty();
}

ObjectKey keyOf(const std::string& name, std::uint64_t set) {
  ObjectKey key = *parseObjectName(name);
  key.set = set;
  return key;
}

}  // namespace

bool NeighbourSets::take(const AxisAlignedBoxArray& array, const NeighbourSender& sender,
                         ros::Time now) {
  NeighbourBoxes boxes = neighbourBoxes(array, sender.name);
  Sender& from = senders_[sender.name];
  const bool is_anew = from.has_connection && from.connection.lock() != sender.connection;
  if (is_anew && boxes.contents.empty()) return false;
  from.connection = sender.connection;
  from.has_connection = sender.connection != nullptr;
  from.lost_since.reset();
  bool is_changed = false;
  Set* const set = setOf(from, sender.name, boxes, is_changed);
  if (set) is_changed |= replace(*set, sender.name, std::move(boxes), now);
  if (set) set->connection = sender.connection;
  if (is_anew) is_changed |= endStatic(from, now);
  return is_changed;
}

/// Whether no set of the current connection has any of these links.
bool NeighbourSets::isNewRobot(const Sender& sender, const std::set<std::string>& links,
                               const std::string& frame) {
  const auto has_links = [&](const Set& set) {
    return canBeSame(set.frame, frame) && share(set.links, links) &&
           set.connection.lock() == sender.connection.lock();
  };
  return !links.empty() && std::none_of(sender.sets.begin(), sender.sets.end(), has_links);
}

/// Whether the message has all boxes of the set, the static ones in the same place.
bool NeighbourSets::haveAllOf(const NeighbourBoxes& boxes, const std::string& sender,
                              const Set& set) const {
  std::map<ObjectKey, const ObjectContent*> sent;
  for (const auto& [box, content] : boxes.contents) {
    for (const std::string& name : {box, boxes.frame + '/' + box})
      sent.emplace(keyOf(neighbourName(sender, name), set.number), &content);
  }
  return std::all_of(set.keys.begin(), set.keys.end(), [&](const ObjectKey& key) {
    const auto now = sent.find(key);
    const auto before = objects_.objects().find(key);
    if (before == objects_.objects().end()) return true;
    const ObjectContent& content = *before->second.content;
    const bool stays = content.is_static && content.refused_name.empty();
    return now != sent.end() && (!stays || isSameBody(content, *now->second));
  });
}

/// From now on, boxes that the sender sent only on a former connection can fall silent, even static
/// ones.
bool NeighbourSets::endStatic(Sender& sender, ros::Time now) {
  bool is_changed = false;
  for (const Set& set : sender.sets) {
    if (set.connection.lock() == sender.connection.lock()) continue;
    for (const ObjectKey& key : set.keys)
      is_changed |= objects_.endStatic(key, now);
  }
  return is_changed;
}

/// The set that a message belongs to, or null if that is unknown: for an empty message of a sender
/// with several sets or none, or one without a frame that fits several. A message may show that two
/// sets belong to one robot; all but the first are then removed.
NeighbourSets::Set* NeighbourSets::setOf(Sender& sender, const std::string& name,
                                         const NeighbourBoxes& boxes, bool& is_changed) {
  std::set<std::string> links = linksOf(boxes);
  const bool is_empty = boxes.contents.empty();
  const bool is_merging = !is_empty && !boxes.frame.empty();
  // The robot may be that of a sender that until now sent only these objects.
  const bool is_new = is_merging && isNewRobot(sender, links, boxes.frame);
  std::list<Set>& sets = sender.sets;
  Set* found = nullptr;
  std::size_t count = 0;
  for (auto set = sets.begin(); set != sets.end();) {
    const bool is_same = is_empty || share(set->links, links) ||
                         (set->links.empty() && links.empty()) ||
                         (is_new && set->links.empty() && haveAllOf(boxes, name, *set));
    if (!is_same || !canBeSame(set->frame, boxes.frame)) {
      ++set;
      continue;
    }
    ++count;
    if (!is_merging || !found) {
      found = &*set++;
      continue;
    }
    is_changed |= removeAll(*set);
    set = sets.erase(set);
  }
  if (is_empty ? count != 1 : !is_merging && count > 1) return nullptr;
  if (!found) found = &sets.emplace_back(Set{++sets_, "", {}, {}, {}});
  if (!boxes.frame.empty()) found->frame = boxes.frame;
  if (!is_empty) found->links = std::move(links);
  return found;
}

bool NeighbourSets::replace(Set& set, const std::string& sender, NeighbourBoxes boxes,
                            ros::Time now) {
  std::map<ObjectKey, ObjectContent> contents = named(set, sender, boxes);
  bool is_changed = false;
  for (const ObjectKey& key : set.keys)
    if (!contents.count(key)) is_changed |= objects_.remove(key);
  set.keys.clear();
  set.is_fresh = true;
  for (auto& [key, content] : contents) {
    set.keys.insert(key);
    is_changed |= objects_.put(key, std::move(content), now);
  }
  for (const auto& [name, reason] : boxes.refused) {
    const auto line = log_.line(name, reason, sender, ros::SteadyTime::now());
    if (line) ROS_ERROR_STREAM(*line);
  }
  return is_changed;
}

/// The first of the names that no other object has; names.front() if all are taken.
ObjectKey NeighbourSets::freeKey(const std::vector<std::string>& names, const Set& set,
                                 const std::map<ObjectKey, ObjectContent>& taken) const {
  for (const std::string& name : names) {
    const ObjectKey key = keyOf(name, set.number);
    if (!taken.count(key) && !objects_.otherOfName(key)) return key;
  }
  return keyOf(names.front(), set.number);
}

std::map<ObjectKey, ObjectContent> NeighbourSets::named(const Set& set, const std::string& sender,
                                                        NeighbourBoxes& boxes) const {
  std::map<ObjectKey, ObjectContent> result;
  for (auto& [box, content] : boxes.contents) {
    const ObjectKey key = freeKey(
        {neighbourName(sender, box), neighbourName(sender, boxes.frame + '/' + box)}, set, result);
    const auto [entry, is_new] = result.try_emplace(key);
    if (!is_new) {
      entry->second.bounded.missing = boxes.refused[box] =
          "its name is that of another box of this node; give one of them another name";
      continue;
    }
    content.bounded.name = objectName(key);
    if (const LiveObject* other = objects_.otherOfName(key)) {
      content.bounded.shapes.clear();
      content.bounded.missing = boxes.refused[box] = content.refused_name = whyNameRefused(*other);
    }
    entry->second = std::move(content);
  }
  return result;
}

bool NeighbourSets::removeAll(const Set& set) {
  bool is_changed = false;
  for (const ObjectKey& key : set.keys)
    is_changed |= objects_.remove(key);
  return is_changed;
}

bool NeighbourSets::removeEnded(ros::SteadyTime now, const HasLeft& has_left) {
  bool is_changed = false;
  for (auto sender = senders_.begin(); sender != senders_.end();) {
    const bool may_leave = sender->second.has_connection && has_left(sender->first);
    if (isLost(sender->second, now) && may_leave) {
      for (const Set& set : sender->second.sets)
        is_changed |= removeAll(set);
      sender->second.sets.clear();
    }
    forgetEmptySets(sender->second);
    sender = sender->second.sets.empty() ? senders_.erase(sender) : std::next(sender);
  }
  return is_changed;
}

bool NeighbourSets::isLost(Sender& sender, ros::SteadyTime now) const {
  if (!sender.has_connection || !sender.connection.expired()) return false;
  if (!sender.lost_since) sender.lost_since = now;
  return now - *sender.lost_since >= ros::WallDuration(kFarewell);
}

/// Forgets sets whose objects were removed after a long silence or by a ~reload.
void NeighbourSets::forgetEmptySets(Sender& sender) const {
  for (auto set = sender.sets.begin(); set != sender.sets.end();) {
    if (!std::exchange(set->is_fresh, false) && set->removals != objects_.removals()) {
      set->removals = objects_.removals();
      for (auto key = set->keys.begin(); key != set->keys.end();)
        key = objects_.objects().count(*key) ? std::next(key) : set->keys.erase(key);
    }
    set = set->keys.empty() ? sender.sets.erase(set) : std::next(set);
  }
}

}  // namespace link_bounds
