// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Until there is a robot, the loader thread polls for the description.
#include "node/loading/model_loader.h"

#include <ros/init.h>

#include <filesystem>
#include <sstream>

#include "node/interface/parameter_text.h"
#include "node/interface/read_parameters.h"
#include "node/interface/topics.h"
#include "node/loading/mesh_remedy.h"
#include "node/loading/reloaded_text.h"
#include "node/threads/queued_function.h"
#include "packages/package_path.h"
#include "world/log/log_text.h"

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kPollPeriod(200);  // of the description, until there is one

/// Packages that are installed later are found, too. Searching takes some 10 ms.
constexpr std::chrono::seconds kPackagesAge(1);

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

}  // namespace

ModelLoader::ModelLoader(ros::NodeHandle& private_node, ros::CallbackQueueInterface& update_queue,
                         Handlers handlers)
    : update_queue_(update_queue),
      handlers_(std::move(handlers)),
      server_([this] { return worker_.isStopping(); }),
      description_(server_),
      robot_loader_(nodeRemedy),
      worker_({"loader", false, [this] { return onTick(); }, kPollPeriod}) {
  ros::NodeHandle loader_node(private_node);
  loader_node.setCallbackQueue(&worker_);
  reload_service_ =
      loader_node.advertiseService(privateName(kReloadService), &ModelLoader::onReload, this);
}

ModelLoader::~ModelLoader() {
  worker_.stop();
  readers_.stop();
}

bool ModelLoader::onTick() {
  if (has_loaded_ || has_failed_) return false;
  try {
    if (!has_parameters_) parameters_ = readParametersAndWarn(server_).parameters;
    has_parameters_ = true;
    firstLoad();
  } catch (const std::exception& error) {
    if (worker_.isStopping()) return false;
    ROS_FATAL("%s", logText(error.what()).c_str());
    has_failed_ = true;
    ros::requestShutdown();
  }
  return !has_loaded_;
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
  serves_objects_ = hand_over_.give(std::make_shared<const Model>(modelWithoutRobot(parameters_)));
}

/// Throws RobotError, ParameterError, and what `adopt` throws.
ModelLoader::ModelPtr ModelLoader::load(XmlRpc::XmlRpcValue description) {
  refused_ = description;
  if (description.getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw RobotError("parameter " + description_.name() + " is " + valueText(description) +
                     ", not a string; load the text of the URDF there");
  }
  waits_for_description_ = false;
  MeshSource source = meshSource(parameters_);
  source.is_cancelled = [this] { return worker_.isStopping(); };
  const auto model = std::make_shared<const Model>(
      makeModel(static_cast<std::string&>(description), parameters_, robot_loader_, source));
  report(*model);
  has_loaded_ = hand_over_.give(model) || has_loaded_;
  refused_.clear();
  return model;
}

bool ModelLoader::onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const Parameters old_parameters = parameters_;
  const XmlRpc::XmlRpcValue old_refused = refused_;
  try {
    response.message = reloadedText(reload());
    response.success = true;
  } catch (const std::exception& error) {
    const std::string reason = logText(error.what());
    parameters_ = old_parameters;
    refused_ = old_refused;
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

/// On the update thread.
void ModelLoader::adopt(const ModelPtr& model) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    limits_ = meshSource(model->parameters).limits;
  }
  handlers_.adopt(model);
}

std::optional<MeshSource> ModelLoader::source(const MeshReaders::IsCancelled& is_cancelled) {
  const auto now = std::chrono::steady_clock::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!limits_) return std::nullopt;
  if (!packages_ || now - packages_since_ > kPackagesAge) {
    packages_ = rosPackages();
    packages_since_ = now;
  }
  return MeshSource{packages_, "", nullptr, *limits_, is_cancelled};
}

/// 0 if there is no such file; loading it then says why.
std::uint64_t ModelLoader::fileBytes(const std::string& uri) {
  try {
    const auto source = this->source({});
    return source ? std::filesystem::file_size(resolveMeshUri(uri, source->package_path).path) : 0;
  } catch (const std::exception&) {
    return 0;
  }
}

void ModelLoader::requestMesh(const std::shared_ptr<const std::string>& wanted) {
  const std::string& uri = *wanted;
  const std::weak_ptr<const std::string> use = wanted;
  const auto load = [this, uri, use](const MeshReaders::IsCancelled& is_cancelled) {
    const auto is_unwanted = [&] { return is_cancelled() || use.expired(); };
    const auto source = this->source(is_unwanted);
    if (!source) return;
    const LoadedMesh mesh = robot_loader_.loadMeshes({uri}, *source).front();
    if (is_unwanted()) return;
    enqueue(update_queue_, [on_mesh = handlers_.on_mesh, uri, mesh] { on_mesh(uri, mesh); });
  };
  readers_.post("mesh " + uri, {[this, uri] { return fileBytes(uri); }, load});
}

void ModelLoader::requestTree(const TreeRequest& request) {
  const auto load = [this, request](const MeshReaders::IsCancelled& is_cancelled) {
    const auto is_unwanted = [&] { return is_cancelled() || request.points.expired(); };
    const auto source = this->source(is_unwanted);
    if (!source) return;
    const LoadedTree tree = robot_loader_.loadTrees({request.uri}, *source).front();
    if (!is_unwanted()) handlers_.on_tree(request, tree);
  };
  std::ostringstream key;  // a file that was replaced may be in use with old points, too
  key << "tree " << request.points.lock() << " " << request.uri;
  readers_.post(key.str(), {[this, uri = request.uri] { return fileBytes(uri); }, load});
}

std::vector<LoadedTree> ModelLoader::loadTrees(const std::vector<std::string>& uris,
                                               const MeshReaders::IsCancelled& is_cancelled) {
  const auto source = this->source(is_cancelled);
  return source ? robot_loader_.loadTrees(uris, *source) : std::vector<LoadedTree>();
}

}  // namespace link_bounds
