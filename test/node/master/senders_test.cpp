// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of nodes that come and go, and of masters that are lost and replaced, beside
// what really happened.
#include "node/master/senders.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

constexpr char kTopic[] = "/boxes";
constexpr int kTicks = 300;

/// As rosmaster: a node is known while it has any registration, under the newest address.
struct Master {
  std::map<std::string, std::string> addresses;
  std::set<std::string> publishers;
  bool knows_us = false;

  XmlRpcCall call() {
    return [this](const std::string& method,
                  const XmlRpcValue& arguments) -> std::optional<XmlRpcAnswer> {
      if (method == "getSystemState") {
        XmlRpcValue state;
        state[0].setSize(publishers.empty() ? 0 : 1);
        int i = 0;
        for (const std::string& node : publishers)
          state[0][0][1][i++] = node;
        if (!publishers.empty()) state[0][0][0] = kTopic;
        return XmlRpcAnswer{1, state};
      }
      XmlRpcValue copy = arguments;
      const auto found = addresses.find(static_cast<std::string>(copy[1]));
      if (found == addresses.end()) return XmlRpcAnswer{-1, 0};
      return XmlRpcAnswer{1, found->second};
    };
  }
};

struct Node {
  std::string name;
  bool registers_again = false;  ///< with a new master; nodes of rospy do not
  bool is_alive = false;
  bool publishes = false;
  std::string address = "";
  std::string known_address = "";  ///< when it was seen first
};

class World {
 public:
  explicit World(unsigned seed) : random_(seed) {
    for (const char* name : {"/a", "/b", "/c", "/d"})
      nodes_.push_back({name, name[1] < 'c'});
  }

  /// One tick, after what has happened since the one before.
  void tick() {
    for (Node& node : nodes_)
      happen(node);
    if (chance(0.04)) master_.reset();
    if (!master_ && chance(0.5)) master_.emplace();
    const bool is_lost = !master_ || !master_->knows_us;
    if (is_lost) seen_.clear();
    senders_.beginTick(is_lost);
    if (!master_) return check();
    master_->knows_us = true;
    senders_.look(master_->call());
    check();
  }

  int left() const { return left_; }

 private:
  bool chance(double probability) { return std::bernoulli_distribution(probability)(random_); }

  void registerAt(const Node& node) {
    if (!master_) return;
    master_->addresses[node.name] = node.address;
    if (node.publishes) master_->publishers.insert(node.name);
  }

  void happen(Node& node) {
    if (!node.is_alive) {
      if (!master_ || !chance(0.2)) return;  // a node waits for a master before it begins
      node.is_alive = true;
      node.publishes = chance(0.9);
      node.address = node.name + std::to_string(++runs_);
      if (master_->addresses.count(node.name) > 0) master_->publishers.erase(node.name);
      return registerAt(node);
    }
    if (chance(0.05)) {
      node.publishes = !node.publishes;
      if (node.publishes) return registerAt(node);
      if (master_) master_->publishers.erase(node.name);
    } else if (chance(0.05)) {
      node.is_alive = node.publishes = false;
      if (chance(0.3)) return;  // killed, so the master is not told
      if (master_ && master_->publishers.erase(node.name) + master_->addresses.erase(node.name) > 0)
        return;
    } else if (node.registers_again && chance(0.3)) {
      registerAt(node);
    } else if (master_ && chance(0.02)) {
      master_->addresses[node.name] = node.address;  // for another topic
    }
  }

  void check() {
    for (Node& node : nodes_) {
      const Senders::Answer answer = senders_.ask(node.name);
      const bool is_published = node.is_alive && node.publishes;
      ASSERT_FALSE(answer.has_left && is_published) << node.name;
      if (answer.is_new) continue;
      if (!master_) continue;
      const auto entry = master_->addresses.find(node.name);
      const std::string address = entry == master_->addresses.end() ? "" : entry->second;
      const bool is_registered = master_->publishers.count(node.name) > 0;
      if (is_registered && node.known_address.empty()) node.known_address = address;
      if (is_registered) seen_.insert(node.name);
      if (is_registered || seen_.count(node.name) == 0) continue;
      if (!address.empty() && address != node.known_address) continue;  // was started again
      ASSERT_TRUE(answer.has_left) << node.name;
      ++left_;
    }
  }

  std::mt19937 random_;
  std::vector<Node> nodes_;
  std::optional<Master> master_ = Master();
  Senders senders_{kTopic};
  std::set<std::string> seen_;  ///< published the topic, as this master has said
  int runs_ = 0;
  int left_ = 0;
};

TEST(Senders, NoLivingPublisherIsSaidToHaveLeftAndAllOthersAre) {
  int left = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(seed);
    for (int tick = 0; tick < kTicks; ++tick) {
      world.tick();
      if (HasFatalFailure()) return;
    }
    left += world.left();
  }
  EXPECT_GT(left, 10000);
}

TEST(Senders, OneThatNobodyAsksAboutIsForgotten) {
  Master master;
  master.addresses["/a"] = "address";
  master.publishers.insert("/a");
  Senders senders(kTopic);
  EXPECT_TRUE(senders.ask("/a").is_new);
  for (int tick = 0; tick < 10; ++tick) {
    senders.beginTick(false);
    senders.look(master.call());
  }
  EXPECT_FALSE(senders.ask("/a").is_new);
  for (int tick = 0; tick < 11; ++tick)
    senders.beginTick(false);
  EXPECT_TRUE(senders.ask("/a").is_new);
}

}  // namespace
}  // namespace link_bounds
