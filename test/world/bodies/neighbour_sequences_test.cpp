// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of markers and neighbours, faults among them, beside lists that say in plain
// words who has which name.
#include <random>

#include "testing/neighbours_testing.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

/// Name, x of the box if there is one, and whether it is incomplete.
using Shown = std::multiset<std::tuple<std::string, std::optional<int>, bool>>;

/// A box of a neighbour, as the newest message of its set says it.
struct Thing {
  std::string name;
  std::optional<int> x;  ///< none: bad, or only named as incomplete
  bool is_incomplete = false;
  bool is_static = false;
  bool is_refused_name = false;
  bool stays = false;  ///< it is static; without a box, as all boxes beside it
  ros::Time heard = {};
  std::optional<ros::Time> silent_since = {};
  bool was_static = false;  ///< its name stays until ~reload
};

struct ModelSet {
  std::string sender, frame;
  std::set<std::string> links;
  std::vector<Thing> things;
  int start = 0;  ///< of the sender, by which it was last sent
};

class NeighbourSequencesTest : public NeighboursTest {
 protected:
  NeighbourSequencesTest() {
    tf_.add({edge("map", "b/base", 0, Eigen::Quaterniond::Identity(), {0, 0, 0})}, true, now_);
    update();
  }

  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool chance(int percent) { return pick(100) < percent; }

  bool isTaken(const std::string& name, const ModelSet* own) const {
    const auto marker = markers_.find(name);
    if (marker != markers_.end() && marker->second) return true;
    for (const ModelSet& set : sets_)
      for (const Thing& thing : set.things)
        if (&set != own && thing.name == name && !thing.is_refused_name) return true;
    return false;
  }

  void sendMarker() {
    static const std::vector<std::pair<std::string, int>> kKeys{
        {"/right/cup", 7}, {"/right", 5}, {"scene", 1}, {"/a/b", 1}, {"/a/map/b", 1}};
    const auto& [ns, id] = kKeys[static_cast<std::size_t>(pick(5))];
    const std::string name = objectName({ns, id});
    const int action = chance(50) ? Marker::ADD : chance(80) ? Marker::DELETE : Marker::DELETEALL;
    const std::string publisher = chance(50) ? "/camera" : "/drawer";
    if (action == Marker::DELETEALL && chance(50)) return deleteDrawings(publisher);
    if (action == Marker::DELETEALL) markers_.clear();
    if (action == Marker::DELETE) markers_.erase(name);
    if (action == Marker::ADD) {
      markers_[name] = !isTaken(name, nullptr) || markers_[name];
      publishers_[name] = publisher;
    }
    takeMarker(action, {ns, id}, publisher);
  }

  /// As a node like this one does; only those go that it was the last to send.
  void deleteDrawings(const std::string& publisher) {
    for (auto marker = markers_.begin(); marker != markers_.end();)
      marker = publishers_[marker->first] == publisher ? markers_.erase(marker) : std::next(marker);
    takeMarker(Marker::DELETEALL, {kDrawingsNamespace, 0}, publisher);
  }

  /// A robot has come, and all objects that were there without it are there with it.
  bool isOfNewRobot(const ModelSet& set, const std::set<std::string>& links,
                    const std::map<std::string, Thing>& things) {
    if (!set.links.empty() || links.empty()) return false;
    for (const ModelSet& other : sets_) {
      if (other.sender != set.sender || other.frame != set.frame) continue;
      for (const std::string& link : links)
        if (other.links.count(link) && other.start == starts_[set.sender]) return false;
    }
    for (const Thing& thing : set.things) {
      bool is_there = false;
      for (const auto& [box, sent] : things)
        for (const std::string& name : {box, set.frame + "/" + box})
          is_there |= thing.name == set.sender + "/" + name &&
                      (!thing.stays || thing.is_refused_name || thing.x == sent.x);
      if (!is_there) return false;
    }
    return true;
  }

  /// The set that a message belongs to; null if that is unknown.
  ModelSet* setOf(const std::string& sender, const std::string& frame,
                  const std::set<std::string>& links, const std::map<std::string, Thing>& things) {
    const bool is_empty = things.empty();
    std::vector<std::list<ModelSet>::iterator> same;
    for (auto set = sets_.begin(); set != sets_.end(); ++set) {
      if (set->sender != sender || set->frame != frame) continue;
      bool is_same =
          is_empty || (links.empty() && set->links.empty()) || isOfNewRobot(*set, links, things);
      for (const std::string& link : links)
        is_same |= set->links.count(link) > 0;
      if (is_same) same.push_back(set);
    }
    if (is_empty && same.size() != 1) return nullptr;
    if (same.empty()) return &sets_.emplace_back(ModelSet{sender, frame, links, {}});
    const auto first = same.front();
    if (is_empty) return &*first;
    for (std::size_t i = 1; i < same.size(); ++i)
      sets_.erase(same[i]);
    first->links = links;
    return &*first;
  }

  void send() {
    static const std::vector<std::string> kSenders{"/right", "/right/cup", "/a", "/a/b"};
    static const std::vector<std::vector<std::string>> kRobots{
        {"arm", "7", "b/1", "cup/7", "5"},
        {"left_arm", "left_hand", "cup/7", "b/c"},
        {"c", "1", "5"}};
    const std::string sender = kSenders[static_cast<std::size_t>(pick(4))];
    const std::string frame = chance(70) ? "map" : "b/base";
    AxisAlignedBoxArray array = arrayOf(frame, {boxAround("/other/node/arm", {0, 0, 0}, 1)});
    std::map<std::string, Thing> things;
    std::set<std::string> links;
    std::vector<bool> are_static;  // of the boxes
    for (const std::string& box : kRobots[static_cast<std::size_t>(pick(3))]) {
      if (chance(40)) continue;
      Thing& thing = things[box];
      thing.is_incomplete = chance(20);
      thing.is_static = chance(20);
      if (thing.is_incomplete) array.incomplete.push_back(box);
      if (!thing.is_incomplete || chance(50)) {
        const bool is_bad = chance(10);
        thing.x = is_bad ? std::nullopt : std::optional<int>(pick(3));
        const double x = is_bad ? kNan : *thing.x;
        array.boxes.push_back(boxAround(box, {x, 0, 0}, thing.is_static ? 0 : now_.toSec() - 0.01));
        are_static.push_back(thing.is_static);
      }
      if (!parseObjectName(box)) links.insert(box);
    }
    const bool is_still =
        !are_static.empty() && std::count(are_static.begin(), are_static.end(), false) == 0;
    for (auto& [box, thing] : things)
      thing.stays = thing.x ? thing.is_static : is_still;
    const bool is_known = !things.empty() || !restarted_.count(sender);
    ModelSet* const set = is_known ? setOf(sender, frame, links, things) : nullptr;
    if (set) fill(*set, things);
    if (is_known && restarted_.erase(sender) > 0) endStatic(sender);
    std::shuffle(array.boxes.begin(), array.boxes.end(), random_);
    left_.erase(sender);
    connections_.try_emplace(sender, boost::make_shared<int>());
    neighbours_.take(array, {sender, connections_[sender]}, now_);
  }

  /// Of what was sent before the last start, nothing stays.
  void endStatic(const std::string& sender) {
    for (ModelSet& set : sets_) {
      if (set.sender != sender || set.start == starts_[sender]) continue;
      for (Thing& thing : set.things) {
        if (!thing.stays) continue;
        thing.stays = thing.is_static = false;
        thing.was_static = true;
        thing.heard = now_;
        thing.silent_since.reset();
      }
    }
  }

  /// Things in the order of their names at the sender.
  void fill(ModelSet& set, const std::map<std::string, Thing>& things) {
    set.things.clear();
    set.start = starts_[set.sender];
    for (const auto& [box, thing] : things) {
      Thing& added = set.things.emplace_back(thing);
      added.heard = now_;
      const auto isFree = [&](const std::string& name) {
        for (std::size_t i = 0; i + 1 < set.things.size(); ++i)
          if (set.things[i].name == name) return false;
        return !isTaken(name, &set);
      };
      added.name = set.sender + "/" + box;
      if (isFree(added.name)) continue;
      if (isFree(set.sender + "/" + set.frame + "/" + box)) {
        added.name = set.sender + "/" + set.frame + "/" + box;
      } else {
        added.is_refused_name = true;
        added.x.reset();
      }
    }
  }

  /// Silent boxes whose time has come.
  void forget(double seconds) {
    for (auto set = sets_.begin(); set != sets_.end();) {
      std::vector<Thing> rest;
      for (const Thing& thing : set->things) {
        const auto& silent = thing.silent_since;
        const bool is_over = silent && now_ - *silent > ros::Duration(seconds);
        const bool is_kept = thing.stays || (thing.was_static && seconds > 0);
        if (!is_over || is_kept) rest.push_back(thing);
      }
      set->things = rest;
      set = rest.empty() ? sets_.erase(set) : std::next(set);
    }
  }

  void passTime(double seconds) {
    pass(seconds);
    forget(18);
    for (auto& [name, has_name] : markers_)
      has_name = has_name || !isTaken(name, nullptr);
    for (ModelSet& set : sets_)
      for (Thing& thing : set.things)
        if (!thing.silent_since && now_ - thing.heard > ros::Duration(2)) thing.silent_since = now_;
    endSenders(0);
  }

  void endSenders(double seconds) {
    wall_ += ros::WallDuration(seconds);
    neighbours_.removeEnded(wall_,
                            [this](const std::string& name) { return left_.count(name) > 0; });
    sets_.remove_if([](const ModelSet& set) { return set.things.empty(); });
  }

  void endOne() {
    if (connections_.empty()) return;
    const auto ended = std::next(connections_.begin(), pick(static_cast<int>(connections_.size())));
    if (pick(2) == 0) {  // else it was started again, and is silent until it sends
      left_.insert(ended->first);
      restarted_.erase(ended->first);
      sets_.remove_if([&](const ModelSet& set) { return set.sender == ended->first; });
    } else {
      restarted_.insert(ended->first);
      ++starts_[ended->first];
    }
    connections_.erase(ended);
    endSenders(0);
    endSenders(0.6);
  }

  void reload() {
    forget(-1);
    adopt("map", 2);
    endSenders(0);
    endSenders(0);
  }

  void expectSame() const {
    Shown expected;
    for (const auto& [name, has_name] : markers_)
      expected.emplace(name, has_name ? std::optional<int>(0) : std::nullopt, !has_name);
    for (const ModelSet& set : sets_) {
      for (const Thing& thing : set.things) {
        const bool has_box = thing.x && (!thing.silent_since || thing.is_static);
        expected.emplace(thing.name, has_box ? thing.x : std::nullopt,
                         !has_box || thing.is_incomplete);
      }
    }
    Shown shown;
    for (const auto& [key, object] : objects_.objects()) {
      const std::optional<Aabb>& box = object.state.box;
      const auto x = [&] { return std::lround((box->min().x() + box->max().x()) / 2); };
      shown.emplace(object.content->bounded.name, box ? std::optional<int>(x()) : std::nullopt,
                    object.state.incomplete);
    }
    ASSERT_EQ(shown, expected);
  }

  std::mt19937 random_{1};
  std::map<std::string, bool> markers_;            ///< whether it has its name, by name
  std::map<std::string, std::string> publishers_;  ///< the last one of a marker, by name
  std::list<ModelSet> sets_;
  std::map<std::string, boost::shared_ptr<int>> connections_;
  std::set<std::string> restarted_;  ///< who has not sent a box since it was started again
  std::map<std::string, int> starts_;
  std::set<std::string> left_;  ///< who has ended in order since it sent
  ros::SteadyTime wall_{1000};
};

TEST_F(NeighbourSequencesTest, ObjectsAreWhatTheNewestMessagesSay) {
  for (int step = 0; step < repetitions(5000); ++step) {
    SCOPED_TRACE(step);
    for (int i = 0; i < 3; ++i) {
      if (chance(50)) send();
      ASSERT_NO_FATAL_FAILURE(expectSame());
      if (chance(30)) sendMarker();
      ASSERT_NO_FATAL_FAILURE(expectSame());
    }
    passTime(chance(3) ? 15 : chance(5) ? 3 : 0.1);
    ASSERT_NO_FATAL_FAILURE(expectSame());
    if (chance(5)) endOne();
    if (chance(5)) reload();
    ASSERT_NO_FATAL_FAILURE(expectSame());
  }
}

}  // namespace
}  // namespace link_bounds
