// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies poses and stamps; shapes are shared.
#include "node/distances/snapshot.h"

namespace link_bounds {

std::shared_ptr<const Snapshot> takeSnapshot(const Scene& scene, const AxisAlignedBoxArray& boxes) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->model = scene.links.sharedModel();
  snapshot->header = boxes.header;
  snapshot->incomplete = boxes.incomplete;
  snapshot->bodies.reserve(boxes.boxes.size());
  const std::vector<BoxState>& links = scene.links.states();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const BoxState& state = links[i];
    if (!state.box) continue;
    snapshot->bodies.push_back({i, nullptr, state.stamp, *state.box, scene.links.pose(i)});
  }
  for (const auto& [key, object] : scene.objects.objects()) {
    const BoxState& state = object.state;
    if (!state.box) continue;
    snapshot->bodies.push_back({std::nullopt, object.boxed.content, state.stamp, *state.box,
                                object.boxed.fixed_from_header});
  }
  return snapshot;
}

}  // namespace link_bounds
