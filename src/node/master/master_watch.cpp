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

constexpr std::chrono::milliseconds kPeriod(1000);  // max delay until a new master is noticed

}  // namespace

MasterWatch::MasterWatch(std::string topic)
    : senders_(std::move(topic)),
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
  senders_.beginTick(registration != Registration::kKnown);
  const bool was_taken = std::exchange(name_is_taken_, registration == Registration::kNameTaken);
  if (registration == Registration::kUnreachable) {
    // A restarted master may know the node's name before this thread asks, because the process has
    // registered something else. So the node registers again in any case.
    must_register_ = true;
    return reportLost("it does not answer");
  }
  if (name_is_taken_) {
    // The master shuts down the older node of a name. If this node still runs one period later,
    // that call did not arrive.
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
  senders_.look(master);
}

bool MasterWatch::hasLeft(const std::string& node) {
  const Senders::Answer answer = senders_.ask(node);
  if (answer.is_new) worker_.post("senders", [this] { onTick(); });
  return answer.has_left;
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
