// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Logs once that the master is lost, and once that it is back.
#include "node/master/master_watch.h"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <utility>

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kPeriod(1000);  // how late a new master is noticed
constexpr int kForgotten = 10;  // ticks without a question about a node, more than an update takes

}  // namespace

MasterWatch::MasterWatch(std::string topic)
    : topic_(std::move(topic)),
      worker_({"master watch", false, [this] { return onTick(); }, kPeriod}) {}

bool MasterWatch::onTick() {
  try {
    poll();
  } catch (const XmlRpc::XmlRpcException& error) {
    // XmlRpcException does not derive from std::exception.
    throw std::runtime_error("answer of the ROS master: " + error.getMessage());
  }
  return true;
}

void MasterWatch::poll() {
  const auto caller = [this](const XmlRpcServer& server) -> XmlRpcCall {
    return [this, server](const std::string& method, const XmlRpc::XmlRpcValue& arguments) {
      return callXmlRpc(server, method, arguments, [this] { return worker_.isStopping(); });
    };
  };
  const XmlRpcCall master = caller(rosMaster());
  const Registration registration = queryRegistration(master);
  // A node that ends removes its own entries from the master.
  if (worker_.isStopping()) return;
  beginTick(registration != Registration::kKnown);
  const bool was_taken = std::exchange(name_is_taken_, registration == Registration::kNameTaken);
  if (registration == Registration::kUnreachable) {
    // A new one may know the node by what else the process registers, before it is asked.
    must_register_ = true;
    return reportLost("it does not answer");
  }
  if (name_is_taken_) {
    // The master ends the older node of a name. One that lives on a period later was not reached.
    if (was_taken) reportNameTaken();
    return;
  }
  if (registration == Registration::kUnknown) {
    reportLost("it was restarted");
    must_register_ = true;
  }
  if (must_register_) {
    const int port = static_cast<int>(ros::XMLRPCManager::instance()->getServerPort());
    must_register_ = !registerAgain(master, caller({"localhost", port}));
  }
  if (!must_register_) reportBack();
  lookForPublishers(master);
}

bool MasterWatch::hasLeft(const std::string& node) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [entry, is_new] = senders_.try_emplace(node);
  if (is_new) worker_.post("publishers", [this] { onTick(); });
  entry->second.unasked = 0;
  return entry->second.has_left;
}

void MasterWatch::beginTick(bool is_master_lost) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto entry = senders_.begin(); entry != senders_.end();) {
    Sender& sender = entry->second;
    sender.is_doubted |= is_master_lost;
    sender.has_left = false;
    entry = ++sender.unasked > kForgotten ? senders_.erase(entry) : std::next(entry);
  }
}

void MasterWatch::lookForPublishers(const XmlRpcCall& master) {
  std::map<std::string, Sender> senders;  // a call may take long
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    senders = senders_;
  }
  const auto publishers = senders.empty() ? std::nullopt : publishersOf(master, topic_);
  if (!publishers) return;
  for (auto& [node, sender] : senders) {
    const bool publishes = publishers->count(node) > 0;
    if (publishes) sender.is_doubted = false;
    if (sender.is_doubted || (publishes && !sender.address.empty())) continue;
    const auto address = addressOf(master, node);
    if (publishes) {
      sender.address = address.value_or("");
    } else {
      sender.has_left = address && (address->empty() || *address == sender.address);
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& [node, sender] : senders) {
    Sender& known = senders_[node];
    sender.unasked = known.unasked;
    known = std::move(sender);
  }
}

void MasterWatch::reportLost(const char* reason) {
  if (is_lost_) return;
  is_lost_ = true;
  ROS_WARN("lost the ROS master %s: %s; connections go on, new ones have to wait",
           ros::master::getURI().c_str(), reason);
}

void MasterWatch::reportNameTaken() {
  if (is_name_told_) return;
  is_lost_ = is_name_told_ = true;
  ROS_WARN(
      "the ROS master %s knows another node as %s: new connections go there; end one of the two",
      ros::master::getURI().c_str(), ros::this_node::getName().c_str());
}

void MasterWatch::reportBack() {
  if (!is_lost_) return;
  is_lost_ = is_name_told_ = false;
  ROS_INFO("the ROS master %s knows this node again", ros::master::getURI().c_str());
}

}  // namespace link_bounds
