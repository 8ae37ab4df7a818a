// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Says what happened to the master once, and once that it is over.
#include "node/master/master_watch.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcException.h>

#include "node/log/guarded.h"
#include "node/master/registration.h"
#include "node/threads/start_thread.h"

namespace link_bounds {
namespace {

constexpr std::chrono::seconds kPeriod(1);

}  // namespace

MasterWatch::MasterWatch() : thread_(startThread("master watch", [this] { run(); })) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  end_.notify_all();
  thread_.join();
}

bool MasterWatch::ends() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ends_ || ros::isShuttingDown();
}

void MasterWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_.wait_for(lock, kPeriod, [this] { return ends_; })) {
    lock.unlock();
    guarded([this] {
      try {
        poll();
      } catch (const XmlRpc::XmlRpcException& error) {
        // It is no std::exception.
        throw std::runtime_error("answer of the ROS master: " + error.getMessage());
      }
    });
    lock.lock();
  }
}

void MasterWatch::poll() {
  const auto caller = [this](const XmlRpcServer& server) -> XmlRpcCall {
    return [this, server](const std::string& method, const XmlRpc::XmlRpcValue& arguments) {
      return callXmlRpc(server, method, arguments, [this] { return ends(); });
    };
  };
  const XmlRpcCall master =
      caller({ros::master::getHost(), static_cast<int>(ros::master::getPort())});
  const Standing standing = askStanding(master);
  // At its end a node takes its entries away from the master itself.
  if (ends()) return;
  if (standing == Standing::kUnreachable) return sayLost("it does not answer");
  if (standing == Standing::kNameTaken) return sayLost("another node has taken this one's name");
  if (standing == Standing::kUnknown) {
    sayLost("it was restarted");
    is_to_register_ = true;
  }
  if (is_to_register_) {
    const int port = static_cast<int>(ros::XMLRPCManager::instance()->getServerPort());
    is_to_register_ = !registerAgain(master, caller({"localhost", port}));
  }
  if (!is_to_register_) sayBack();
}

void MasterWatch::sayLost(const char* how) {
  if (is_lost_) return;
  is_lost_ = true;
  ROS_WARN("lost the ROS master %s: %s; connections go on, new ones have to wait",
           ros::master::getURI().c_str(), how);
}

void MasterWatch::sayBack() {
  if (!is_lost_) return;
  is_lost_ = false;
  ROS_INFO("the ROS master %s knows this node again", ros::master::getURI().c_str());
}

}  // namespace link_bounds
