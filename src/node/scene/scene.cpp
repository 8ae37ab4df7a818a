// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Groups over links and objects.
#include "node/scene/scene.h"

namespace link_bounds {

BoxState groupState(const SceneGroup& group, const Scene& scene) {
  BoxState state = groupState(group, scene.links.states());
  const LiveObjects::Objects& objects = scene.objects.objects();
  for (const ObjectKey& key : group.objects) {
    const auto found = objects.find(key);
    if (found == objects.end()) {
      state.incomplete = true;
    } else {
      addMember(state, found->second.state);
    }
  }
  for (const std::string& ns : group.namespaces) {
    auto object = objects.lower_bound({ns, std::numeric_limits<std::int32_t>::min()});
    for (; object != objects.end() && object->first.ns == ns; ++object)
      addMember(state, object->second.state);
  }
  return state;
}

}  // namespace link_bounds
