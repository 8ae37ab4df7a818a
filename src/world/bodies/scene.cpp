// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Updates the poses first, then the boxes. Groups cover links and objects.
#include "world/bodies/scene.h"

#include <limits>
#include <utility>

namespace link_bounds {

void Scene::adopt(std::shared_ptr<const Model> model, ros::Time now) {
  frames.setTarget(model->fixed_frame, model->parameters.timeout, now);
  links.adopt(std::move(model));
  objects.adopt(now);
}

bool Scene::update(ros::Time now) {
  frames.update(now);
  const bool links_changed = links.update();
  return objects.update(now) || links_changed;
}

bool Scene::startClock(ros::Time now) {
  frames.updateAll(now);
  const bool links_changed = links.update();
  return objects.startClock(now) || links_changed;
}

bool Scene::restart(ros::Time now) {
  frames.updateAll(now);
  const bool links_changed = links.update();
  return objects.restart(now) || links_changed;
}

bool Scene::expire(ros::Time now) {
  frames.expire(now);
  const bool links_changed = links.update();
  return objects.expire(now) || links_changed;
}

std::string Scene::reason(const SceneBody& body) const {
  return body.link ? links.reason(*body.link) : objects.reason(*body.object);
}

BoxSource Scene::boxSource(const SceneBody& body) const {
  static const std::shared_ptr<const ObjectContent> kNone;
  if (body.link) return {model()->links[*body.link], kNone, links.frame(*body.link), nullptr};
  const BoxedObject& boxed = body.object->boxed;
  // A box of an earlier content stays in place until the current content can be placed.
  if (boxed.content == body.object->content && boxed.content->follows())
    return {boxed.content->bounded, boxed.content, body.object->frame, nullptr};
  return {boxed.content->bounded, boxed.content, *frames.fixedFrame(), &boxed.fixed_from_header};
}

const Eigen::Affine3d& Scene::pose(const SceneBody& body) const {
  return body.link ? links.pose(*body.link) : body.object->boxed.fixed_from_header;
}

BoxState groupState(const SceneGroup& group, const Scene& scene) {
  BoxState state = groupState(group, scene.links.states());
  const LiveObjects::Objects& objects = scene.objects.objects();
  for (const ObjectKey& key : group.objects) {
    const auto [begin, end] = scene.objects.named(key);
    if (begin == end) state.incomplete = true;
    for (auto object = begin; object != end; ++object)
      addMember(state, object->second.state);
  }
  for (const std::string& ns : group.namespaces) {
    auto object = objects.lower_bound({ns, std::numeric_limits<std::int32_t>::min()});
    for (; object != objects.end() && object->first.ns == ns; ++object)
      addMember(state, object->second.state);
  }
  return state;
}

}  // namespace link_bounds
