// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies poses and stamps; shapes are shared.
#include "world/moment/snapshot.h"

#include <algorithm>

namespace link_bounds {

std::shared_ptr<const Snapshot> takeSnapshot(const Scene& scene) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->model = scene.links.sharedModel();
  const std::vector<BoxState>& links = scene.links.states();
  snapshot->bodies.reserve(links.size() + scene.objects.objects().size());
  std::int64_t newest = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const BoxState& state = links[i];
    if (state.incomplete) {
      snapshot->incomplete.push_back(snapshot->model->links[i].name);
      snapshot->incomplete_links.push_back(i);
    }
    if (!state.box) continue;
    snapshot->bodies.push_back({i, nullptr, state.stamp, *state.box, scene.links.pose(i)});
    newest = std::max(newest, state.stamp);
  }
  for (const auto& [key, object] : scene.objects.objects()) {
    const BoxState& state = object.state;
    if (state.incomplete) snapshot->incomplete.push_back(object.content->bounded.name);
    if (!state.box) continue;
    snapshot->bodies.push_back({std::nullopt, object.boxed.content, state.stamp, *state.box,
                                object.boxed.fixed_from_header});
    newest = std::max(newest, state.stamp);
  }
  snapshot->header.frame_id = snapshot->model->fixed_frame;
  snapshot->header.stamp.fromNSec(static_cast<std::uint64_t>(newest));
  return snapshot;
}

}  // namespace link_bounds
