// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Repeats the calls that roscpp makes when a topic or service is advertised.
#include "node/master/registration.h"

#include <ros/connection_manager.h>
#include <ros/names.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include "node/interface/topics.h"

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

/// All services of this node; roscpp has no function that lists them.
constexpr std::array<const char*, 5> kOwnServices{{kReloadService.name, kGetBoxesService.name,
                                                   kCheckPathService.name, "~get_loggers",
                                                   "~set_logger_level"}};

std::string ownUri() {
  return ros::XMLRPCManager::instance()->getServerURI();
}

std::string serviceUri() {
  return "rosrpc://" + ros::network::getHost() + ":" +
         std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}

/// The first argument of each call is the name of the caller.
template <class... Values>
XmlRpcValue arguments(const Values&... values) {
  XmlRpcValue result;
  int i = 0;
  result[i++] = ros::this_node::getName();
  ((result[i++] = values), ...);
  return result;
}

/// The value of the answer; nullopt if there is no answer or the call failed.
std::optional<XmlRpcValue> request(const XmlRpcCall& call, const std::string& method,
                                   const XmlRpcValue& arguments) {
  auto answer = call(method, arguments);
  if (!answer || !answer->isSuccess()) return std::nullopt;
  return std::move(answer->value);
}

bool registerPublishers(const XmlRpcCall& master, const XmlRpcCall& node) {
  auto topics = request(node, "getPublications", arguments());
  for (int i = 0; topics && i < topics->size(); ++i) {
    XmlRpcValue& topic = (*topics)[i];
    if (!request(master, "registerPublisher", arguments(topic[0], topic[1], ownUri()))) {
      return false;
    }
  }
  return topics.has_value();
}

/// The master answers with the publishers of the topic. An empty list is not passed on, because it
/// would end connections to publishers that run but have not registered again.
bool registerSubscribers(const XmlRpcCall& master, const XmlRpcCall& node) {
  auto topics = request(node, "getSubscriptions", arguments());
  for (int i = 0; topics && i < topics->size(); ++i) {
    XmlRpcValue& topic = (*topics)[i];
    const auto publishers =
        request(master, "registerSubscriber", arguments(topic[0], topic[1], ownUri()));
    if (!publishers) return false;
    if (publishers->size() > 0 &&
        !request(node, "publisherUpdate", arguments(topic[0], *publishers))) {
      return false;
    }
  }
  return topics.has_value();
}

bool registerServices(const XmlRpcCall& master) {
  for (const char* name : kOwnServices) {
    const std::string service = ros::names::resolve(name);
    if (!ros::ServiceManager::instance()->lookupServicePublication(service)) continue;
    if (!request(master, "registerService", arguments(service, serviceUri(), ownUri()))) {
      return false;
    }
  }
  return true;
}

}  // namespace

Registration queryRegistration(const XmlRpcCall& master) {
  auto answer = master("lookupNode", arguments(ros::this_node::getName()));
  if (!answer) return Registration::kUnreachable;
  if (!answer->isSuccess()) return Registration::kUnknown;
  return answer->value == XmlRpcValue(ownUri()) ? Registration::kKnown : Registration::kNameTaken;
}

std::optional<std::set<std::string>> publishersOf(const XmlRpcCall& master,
                                                  const std::string& topic) {
  auto state = request(master, "getSystemState", arguments());
  if (!state) return std::nullopt;
  std::set<std::string> result;
  XmlRpcValue& topics = (*state)[0];
  for (int i = 0; i < topics.size(); ++i) {
    if (static_cast<std::string>(topics[i][0]) != topic) continue;
    for (int node = 0; node < topics[i][1].size(); ++node)
      result.insert(topics[i][1][node]);
  }
  return result;
}

std::optional<std::string> addressOf(const XmlRpcCall& master, const std::string& node) {
  auto answer = master("lookupNode", arguments(node));
  if (!answer) return std::nullopt;
  return answer->isSuccess() ? static_cast<std::string>(answer->value) : "";
}

bool registerAgain(const XmlRpcCall& master, const XmlRpcCall& node) {
  return registerPublishers(master, node) && registerSubscribers(master, node) &&
         registerServices(master);
}

}  // namespace link_bounds
