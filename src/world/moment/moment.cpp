// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies poses and stamps; shapes are shared.
#include "world/moment/moment.h"

#include <algorithm>

namespace link_bounds {

void Moment::addIncomplete(const std::string& name, std::optional<std::size_t> link) {
  if (incomplete.empty() || incomplete.back() != name) incomplete.push_back(name);
  if (link) incomplete_links.push_back(*link);
}

MomentPtr momentOf(const Scene& scene) {
  auto moment = std::make_shared<Moment>();
  moment->model = scene.links.sharedModel();
  const std::vector<BoxState>& links = scene.links.states();
  moment->bodies.reserve(links.size() + scene.objects.objects().size());
  std::int64_t newest = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const BoxState& state = links[i];
    if (state.incomplete) moment->addIncomplete(moment->model->links[i].name, i);
    if (!state.box) continue;
    moment->bodies.push_back({i, nullptr, state.stamp, *state.box, scene.links.pose(i)});
    newest = std::max(newest, state.stamp);
  }
  for (const auto& [key, object] : scene.objects.objects()) {
    const BoxState& state = object.state;
    if (state.incomplete) moment->addIncomplete(object.content->bounded.name, std::nullopt);
    if (!state.box) continue;
    moment->bodies.push_back({std::nullopt, object.boxed.content, state.stamp, *state.box,
                              object.boxed.fixed_from_header});
    newest = std::max(newest, state.stamp);
  }
  moment->header.frame_id = moment->model->fixed_frame;
  moment->header.stamp.fromNSec(static_cast<std::uint64_t>(newest));
  return moment;
}

}  // namespace link_bounds
