// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread that spins its own callback queue and, until the first model is there, looks for it.
#include "model_loader.h"

#include <malloc.h>
#include <ros/callback_queue_interface.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/param.h>

#include <future>
#include <optional>

#include "link_bounds/mesh_process.h"
#include "log_text.h"
#include "object_meshes.h"
#include "package_path.h"
#include "topics.h"

namespace link_bounds {
namespace {

const ros::WallDuration kPollPeriod(0.2);
const ros::WallDuration kWaitMessagePeriod(10.0);
constexpr std::chrono::milliseconds kHandOverPoll(20);

/// There is no description to load yet.
class NoDescription : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string readDescription() {
  const ros::NodeHandle node;
  std::string key;
  std::string description;
  if (!node.searchParam("robot_description", key)) {
    throw NoDescription("parameter robot_description is not set");
  }
  if (!ros::param::get(key, description)) {
    throw RobotError("parameter " + key + " is not a string");
  }
  return description;
}

Parameters readParametersAndWarn() {
  const ReadParameters read = readParameters();
  for (const std::string& warning : read.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  return read.parameters;
}

void report(const Model& model) {
  for (const std::string& problem : model.problems)
    ROS_ERROR("%s", logText(problem).c_str());
  for (const std::string& warning : model.warnings)
    ROS_WARN("%s", logText(warning).c_str());
  ROS_INFO("bounding %zu links in frame \"%s\" with %zu meshes", model.links.size(),
           logText(model.fixed_frame).c_str(), model.mesh_bytes.size());
}

/// A function as an entry of a callback queue.
class QueuedFunction : public ros::CallbackInterface {
 public:
  explicit QueuedFunction(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    function_();
    return Success;
  }

 private:
  std::function<void()> function_;
};

/// Of what loading took for a while; the C library would keep it for later.
void trimHeap() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace

ModelLoader::ModelLoader(ros::NodeHandle& private_node, std::function<ModelPtr(ModelPtr)> adopt,
                         MeshHandler on_mesh)
    : adopt_(std::move(adopt)),
      on_mesh_(std::move(on_mesh)),
      worker_(meshWorker()),
      store_([this](const MeshFile& file) { return import(file); }) {
  ros::NodeHandle own_queue_node(private_node);
  own_queue_node.setCallbackQueue(&queue_);
  reload_service_ =
      own_queue_node.advertiseService(privateName(kReloadService), &ModelLoader::onReload, this);
  thread_ = std::thread([this] { run(); });
}

ModelLoader::~ModelLoader() {
  stops_ = true;
  queue_.disable();
  thread_.join();
}

void ModelLoader::run() {
  try {
    parameters_ = readParametersAndWarn();
    while (!stops_ && ros::ok()) {
      if (!has_loaded_) firstLoad();
      queue_.callAvailable(kPollPeriod);
    }
  } catch (const std::exception& error) {
    ROS_FATAL("%s", logText(error.what()).c_str());
    has_failed_ = true;
    ros::requestShutdown();
  }
}

void ModelLoader::firstLoad() {
  try {
    load();
  } catch (const NoDescription&) {
    waits_for_description_ = true;
    sayWaiting();
    if (!serves_objects_) serveObjectsMeanwhile();
  }
}

void ModelLoader::serveObjectsMeanwhile() {
  if (parameters_.fixed_frame.empty()) return;
  serves_objects_ = handOver(std::make_shared<const Model>(modelWithoutRobot(parameters_)));
}

void ModelLoader::sayWaiting() {
  const ros::WallTime now = ros::WallTime::now();
  if (now - last_said_ < kWaitMessagePeriod) return;
  last_said_ = now;
  ROS_WARN("waiting for parameter robot_description");
}

void ModelLoader::requestMesh(const std::string& uri) {
  {
    const std::lock_guard<std::mutex> lock(requests_mutex_);
    requests_.push_back(uri);
  }
  queue_.addCallback(boost::make_shared<QueuedFunction>([this] { loadRequestedMeshes(); }));
}

void ModelLoader::giveBackMemory() {
  queue_.addCallback(boost::make_shared<QueuedFunction>([] { trimHeap(); }));
}

/// All that have gathered, so that files load side by side.
void ModelLoader::loadRequestedMeshes() {
  std::vector<std::string> uris;
  {
    const std::lock_guard<std::mutex> lock(requests_mutex_);
    uris.swap(requests_);
  }
  if (uris.empty()) return;
  const std::vector<LoadedMesh> meshes = loadObjectMeshes(uris, rosPackages(), store_);
  for (std::size_t i = 0; i < uris.size(); ++i) {
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<QueuedFunction>(
        [this, uri = uris[i], mesh = meshes[i]] { on_mesh_(uri, mesh); }));
  }
  trimHeap();
}

/// Called from several threads while load() waits; a node that ends does not wait for meshes.
TriangleMesh ModelLoader::import(const MeshFile& file) const {
  const MeshLimits limits{parameters_.mesh_timeout,
                          static_cast<std::uint64_t>(parameters_.max_mesh_bytes)};
  return importInProcess(worker_, file, limits, [this] { return stops_ || !ros::ok(); });
}

/// Throws NoDescription, RobotError.
void ModelLoader::load() {
  const std::string description = readDescription();
  waits_for_description_ = false;
  const auto model = std::make_shared<const Model>(makeModel(description, parameters_, store_));
  report(*model);
  has_loaded_ = handOver(model) || has_loaded_;
  trimHeap();
}

bool ModelLoader::onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  try {
    // Reading parameters would wait for it without end.
    if (!ros::master::check()) throw std::runtime_error("the ROS master does not answer");
    store_.forgetFailures();
    const Parameters old_parameters = parameters_;
    parameters_ = readParametersAndWarn();
    try {
      load();
    } catch (const NoDescription&) {
      if (has_loaded_) parameters_ = old_parameters;
      if (has_loaded_ || parameters_.fixed_frame.empty()) throw;
      serveObjectsMeanwhile();
    } catch (...) {
      if (has_loaded_) parameters_ = old_parameters;
      throw;
    }
    response.success = true;
    response.message = "reloaded";
  } catch (const std::exception& error) {
    const std::string reason = logText(error.what());
    ROS_ERROR("reload failed, everything stays as it was: %s", reason.c_str());
    response.success = false;
    response.message = reason;
  }
  return true;
}

/// Returns once the update thread uses the model; false if the node stops before.
bool ModelLoader::handOver(ModelPtr model) {
  const auto done = std::make_shared<std::promise<ModelPtr>>();
  std::future<ModelPtr> old_model = done->get_future();
  ros::getGlobalCallbackQueue()->addCallback(
      boost::make_shared<QueuedFunction>([this, done, model = std::move(model)]() mutable {
        done->set_value(adopt_(std::move(model)));
      }));
  while (old_model.wait_for(kHandOverPoll) != std::future_status::ready) {
    if (stops_ || !ros::ok()) return false;
  }
  return true;
}

}  // namespace link_bounds
