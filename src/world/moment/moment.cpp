// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies boxes, poses and stamps; shapes are shared.
#include "world/moment/moment.h"

#include <algorithm>

#include "world/tf/nanoseconds.h"

namespace link_bounds {

void Moment::addIncomplete(const std::string& name, std::optional<std::size_t> link) {
  if (incomplete.empty() || incomplete.back() != name) incomplete.push_back(name);
  if (link) incomplete_links.push_back(*link);
}

MomentPtr momentOf(const Scene& scene) {
  auto moment = std::make_shared<Moment>();
  moment->model = scene.links.sharedModel();
  moment->bodies.reserve(scene.size());
  std::int64_t newest = 0;
  scene.forEach([&](const SceneBody& body) {
    const BoxState& state = body.state;
    if (state.incomplete) moment->addIncomplete(body.name, body.link);
    if (!state.box) return;
    moment->bodies.push_back(
        {body.link, scene.boxSource(body).object, state.stamp, *state.box, scene.pose(body)});
    newest = std::max(newest, state.stamp);
  });
  moment->header.frame_id = moment->model->fixed_frame;
  moment->header.stamp = timeFrom(newest);
  return moment;
}

}  // namespace link_bounds
