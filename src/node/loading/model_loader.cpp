// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/loading/model_loader.h"

#include <ros/init.h>
#include <ros/this_node.h>

#include <filesystem>
#include <sstream>

#include "node/interface/parameter_table.h"
#include "node/interface/topics.h"
#include "node/loading/mesh_remedy.h"
#include "node/threads/queued_function.h"
#include "packages/package_path.h"
#include "world/log/log_text.h"

namespace link_bounds {
namespace {

/// The list of packages is searched again after this time, so that new packages are found. A search
/// takes about 10 ms.
constexpr std::chrono::seconds kPackagesAge(1);

bool isExpired(const std::weak_ptr<const PointSet>& points) {
  return points.expired();
}

}  // namespace

ModelLoader::ModelLoader(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                         ros::CallbackQueueInterface& update_queue, Handlers handlers)
    : update_queue_(update_queue),
      handlers_(std::move(handlers)),
      robot_loader_(nodeRemedy),
      loading_(kReloadService, node, private_node, update_queue, loadingHandlers()) {}

ModelLoader::Loading::Handlers ModelLoader::loadingHandlers() {
  Loading::Handlers handlers;
  handlers.read = [this](const ParameterServer& server) {
    robot_loader_.forgetFailures();
    forgetPackages();
    return readParameters<Parameters>(
        server, ros::this_node::getName(),
        [](auto& parameters, auto& reader) { visitParameters(parameters, reader); });
  };
  handlers.load = [this](const auto&... all) { return load(all...); };
  handlers.load_nothing = [this](const Parameters& parameters) -> ModelPtr {
    if (parameters.fixed_frame.empty()) return nullptr;
    const auto model = std::make_shared<Model>(modelWithoutRobot(parameters));
    model->object_meshes = unchangedMeshes();
    return model;
  };
  handlers.adopt = [this](const ModelPtr& model) { adopt(model); };
  handlers.on_failure = ros::requestShutdown;
  return handlers;
}

/// Throws RobotError, ParameterError.
ModelLoader::Loading::Loaded ModelLoader::load(const std::string& urdf,
                                               const Parameters& parameters,
                                               const std::function<bool()>& is_stopping) {
  MeshSource source = meshSource(parameters);
  source.is_cancelled = is_stopping;
  const auto model = std::make_shared<Model>(makeModel(urdf, parameters, robot_loader_, source));
  model->object_meshes = unchangedMeshes();
  return {model, "bounding " + std::to_string(model->links.size()) + " links in frame \"" +
                     logText(model->fixed_frame) + "\" with " +
                     std::to_string(model->mesh_bytes.size()) + " meshes" +
                     (model->left_out.empty() ? "" : "; " + logText(model->left_out))};
}

/// The loaded meshes of objects whose files have not changed. Runs on the loader thread, so that
/// the update thread adopts this result together with the model.
ObjectSource::Points ModelLoader::unchangedMeshes() {
  ObjectSource::Points loaded;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    loaded = object_meshes_;
  }
  ObjectSource::Points unchanged;
  const auto source = this->source({});
  for (const auto& [uri, points] : loaded) {
    if (isExpired(points)) continue;
    const auto found = source ? robot_loader_.find(uri, *source) : nullptr;
    if (found && found == points.lock()) unchanged.emplace(uri, points);
  }
  return unchanged;
}

/// Runs on the update thread.
void ModelLoader::adopt(const ModelPtr& model) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    limits_ = meshSource(model->parameters).limits;
  }
  handlers_.adopt(model);
}

/// A package that is new may come before the one that a mesh was read from.
void ModelLoader::forgetPackages() {
  const std::lock_guard<std::mutex> lock(mutex_);
  packages_ = nullptr;
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

/// 0 if there is no such file; loading the mesh then reports the reason.
std::uint64_t ModelLoader::fileBytes(const std::string& uri) {
  try {
    const auto source = this->source({});
    return source ? std::filesystem::file_size(resolveMeshUri(uri, source->package_path).path) : 0;
  } catch (const std::exception&) {
    return 0;
  }
}

void ModelLoader::requestMesh(const MeshRequest& request) {
  const auto load = [this, request](const MeshReaders::IsCancelled& is_cancelled) {
    const auto is_unwanted = [&] { return is_cancelled() || request.use.expired(); };
    const auto source = this->source(is_unwanted);
    if (!source) return;
    const LoadedMesh mesh = robot_loader_.loadMeshes({request.uri}, *source).front();
    if (is_unwanted()) return;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      eraseDead(object_meshes_, max_object_meshes_, isExpired);
      object_meshes_[request.uri] = mesh.points;
    }
    enqueue(update_queue_,
            [on_mesh = handlers_.on_mesh, request, mesh] { on_mesh(request, mesh); });
  };
  readers_.post("mesh " + request.uri,
                {[this, uri = request.uri] { return fileBytes(uri); }, load});
}

void ModelLoader::requestTree(const TreeRequest& request) {
  const auto load = [this, request](const MeshReaders::IsCancelled& is_cancelled) {
    const auto is_unwanted = [&] { return is_cancelled() || request.points.expired(); };
    const auto source = this->source(is_unwanted);
    if (!source) return;
    const LoadedTree tree = robot_loader_.loadTrees({request.uri}, *source).front();
    if (!is_unwanted()) handlers_.on_tree(request, tree);
  };
  std::ostringstream key;  // has the points: a replaced file may be in use with its old points
  key << "tree " << request.points.lock() << " " << request.uri;
  readers_.post(key.str(), {[this, uri = request.uri] { return fileBytes(uri); }, load});
}

std::vector<LoadedTree> ModelLoader::loadTrees(const std::vector<std::string>& uris,
                                               const MeshReaders::IsCancelled& is_cancelled) {
  const auto source = this->source(is_cancelled);
  return source ? robot_loader_.loadTrees(uris, *source) : std::vector<LoadedTree>();
}

}  // namespace link_bounds
