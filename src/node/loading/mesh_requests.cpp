// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The first call on the loader thread takes all requests that have gathered; the others find none.
#include "node/loading/mesh_requests.h"

#include <utility>

#include "node/threads/queued_function.h"

namespace link_bounds {

MeshRequests::MeshRequests(ros::CallbackQueueInterface& loader_queue,
                           ros::CallbackQueueInterface& update_queue, Load load, Handler on_mesh)
    : loader_queue_(loader_queue),
      update_queue_(update_queue),
      load_(std::move(load)),
      on_mesh_(std::move(on_mesh)) {}

void MeshRequests::add(const std::string& uri) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    uris_.push_back(uri);
  }
  enqueue(loader_queue_, [this] { loadAll(); });
}

/// In one call, because files are then read side by side.
void MeshRequests::loadAll() {
  const std::vector<std::string> uris = takeAll();
  if (uris.empty()) return;
  const std::vector<LoadedMesh> meshes = load_(uris);
  for (std::size_t i = 0; i < uris.size(); ++i)
    enqueue(update_queue_, [this, uri = uris[i], mesh = meshes[i]] { on_mesh_(uri, mesh); });
}

std::vector<std::string> MeshRequests::takeAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(uris_, {});
}

}  // namespace link_bounds
