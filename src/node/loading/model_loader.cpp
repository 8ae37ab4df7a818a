// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The thread serves its own callback queue. Until there is a robot, it polls for the description.
#include "node/loading/model_loader.h"

#include <ros/init.h>

#include <algorithm>

#include "node/loading/mesh_remedy.h"
#include "node/log/log_text.h"
#include "node/names/topics.h"
#include "node/parameters/parameter_text.h"
#include "node/threads/start_thread.h"

namespace link_bounds {
namespace {

const ros::WallDuration kPollPeriod(0.2);        // of the description, until there is one
const ros::WallDuration kQueuePeriod(10.0);      // then a request or the end wakes the thread
constexpr std::size_t kMaxAnsweredWarnings = 4;  // the answer of ~reload is one line

ReadParameters readParametersAndWarn(const ParameterServer& server) {
  ReadParameters read = readParameters(server);
  for (const std::string& warning : read.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  return read;
}

void report(const Model& model) {
  for (const std::string& problem : model.problems)
    ROS_ERROR("%s", logText(problem).c_str());
  for (const std::string& warning : model.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  ROS_INFO("bounding %zu links in frame \"%s\" with %zu meshes", model.links.size(),
           logText(model.fixed_frame).c_str(), model.mesh_bytes.size());
}

/// The answer of a ~reload that succeeded, with the first of its warnings.
std::string reloadedText(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "reloaded";
  std::string text = "reloaded, with " + std::to_string(warnings.size()) + " warning" +
                     (warnings.size() > 1 ? "s" : "");
  for (std::size_t i = 0; i < std::min(warnings.size(), kMaxAnsweredWarnings); ++i)
    text += (i == 0 ? ": " : "; ") + warnings[i];
  return logText(text + (warnings.size() > kMaxAnsweredWarnings ? "; see the log for all" : ""));
}

}  // namespace

ModelLoader::ModelLoader(ros::NodeHandle& private_node, Handlers handlers)
    : hand_over_(*ros::getGlobalCallbackQueue(), std::move(handlers.adopt)),
      server_([this] { return isStopping(); }),
      description_(server_),
      robot_loader_(nodeRemedy, [this] { return isStopping(); }),
      mesh_requests_(
          queue_,
          [this](const auto& uris) {
            return robot_loader_.loadMeshes(uris, meshSource(parameters_));
          },
          [on_mesh = std::move(handlers.on_mesh)](const std::string& uri, const LoadedMesh& mesh) {
            enqueue(*ros::getGlobalCallbackQueue(), [=] { on_mesh(uri, mesh); });
          }),
      tree_requests_(
          queue_, [this](const auto& requests) { return loadTrees(requests); },
          std::move(handlers.on_tree)) {
  ros::NodeHandle own_queue_node(private_node);
  own_queue_node.setCallbackQueue(&queue_);
  reload_service_ =
      own_queue_node.advertiseService(privateName(kReloadService), &ModelLoader::onReload, this);
  thread_ = startThread("loader", [this] { run(); });
}

ModelLoader::~ModelLoader() {
  stops_ = true;
  queue_.disable();
  thread_.join();
}

void ModelLoader::run() {
  try {
    parameters_ = readParametersAndWarn(server_).parameters;
    while (!isStopping()) {
      if (!has_loaded_) firstLoad();
      queue_.callAvailable(has_loaded_ ? kQueuePeriod : kPollPeriod);
    }
  } catch (const std::exception& error) {
    if (isStopping()) return;
    ROS_FATAL("%s", logText(error.what()).c_str());
    has_failed_ = true;
    ros::requestShutdown();
  }
}

void ModelLoader::firstLoad() {
  try {
    const XmlRpc::XmlRpcValue description = description_.read();
    if (!refused_.valid() || !(refused_ == description)) load(description);
  } catch (const NoDescription& reason) {
    refused_.clear();
    waits_for_description_ = true;
    description_.warnOfWaiting(reason.what());
    if (!serves_objects_) serveObjectsMeanwhile();
  } catch (const std::exception& error) {
    if (!serves_objects_) throw;
    waits_for_description_ = true;
    ROS_ERROR("%s; waiting for another robot_description", logText(error.what()).c_str());
  }
}

void ModelLoader::serveObjectsMeanwhile() {
  if (parameters_.fixed_frame.empty()) return;
  serves_objects_ = handOver(std::make_shared<const Model>(modelWithoutRobot(parameters_)));
}

std::vector<LoadedTree> ModelLoader::loadTrees(const std::vector<TreeRequest>& requests) {
  std::vector<std::string> uris;
  for (const TreeRequest& request : requests)
    uris.push_back(request.uri);
  return robot_loader_.loadTrees(uris, meshSource(parameters_));
}

/// Throws RobotError, ParameterError, and what `adopt` throws.
ModelLoader::ModelPtr ModelLoader::load(XmlRpc::XmlRpcValue description) {
  refused_ = description;
  if (description.getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw RobotError("parameter " + description_.name() + " is " + valueText(description) +
                     ", not a string; load the text of the URDF there");
  }
  waits_for_description_ = false;
  const auto model = std::make_shared<const Model>(
      makeModel(static_cast<std::string&>(description), parameters_, robot_loader_));
  report(*model);
  has_loaded_ = handOver(model) || has_loaded_;
  refused_.clear();
  return model;
}

bool ModelLoader::onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const Parameters old_parameters = parameters_;
  try {
    response.message = reloadedText(reload());
    response.success = true;
  } catch (const std::exception& error) {
    const std::string reason = logText(error.what());
    parameters_ = old_parameters;
    waits_for_description_ = !has_loaded_;
    ROS_ERROR("reload failed, everything stays as it was: %s", reason.c_str());
    response.success = false;
    response.message = reason;
  }
  return true;
}

/// Returns what was logged of the parameters and the robot.
std::vector<std::string> ModelLoader::reload() {
  robot_loader_.forgetFailures();
  ReadParameters read = readParametersAndWarn(server_);
  parameters_ = read.parameters;
  std::vector<std::string> warnings = std::move(read.warnings);
  try {
    const ModelPtr model = load(description_.read());
    warnings.insert(warnings.end(), model->problems.begin(), model->problems.end());
    warnings.insert(warnings.end(), model->warnings.begin(), model->warnings.end());
  } catch (const NoDescription&) {
    if (has_loaded_ || parameters_.fixed_frame.empty()) throw;
    serveObjectsMeanwhile();
  }
  return warnings;
}

/// Returns true when the update thread uses the model, false if the node stops before.
bool ModelLoader::handOver(ModelPtr model) {
  return hand_over_.give(std::move(model), [this] { return isStopping(); });
}

/// While roscpp shuts down, ros::ok() is still true, and it waits for services that work.
bool ModelLoader::isStopping() const {
  return stops_ || ros::isShuttingDown() || !ros::ok();
}

}  // namespace link_bounds
