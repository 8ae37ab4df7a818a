// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rebuilds a body if its content changed or if a triangle tree that it lacks may have arrived.
#include "world/moment/live_bodies.h"

#include <algorithm>
#include <utility>

#include "world/moment/object_body.h"

namespace link_bounds {

void LiveBodies::update(const MomentPtr& moment, TriangleTrees::Time now) {
  if (moment->model != model_) adopt(moment->model);
  ++moment_;
  const bool has_new_trees = std::exchange(trees_version_, trees_.version()) != trees_.version();
  slots_of_bodies_.clear();
  for (const Moment::Body& body : moment->bodies) {
    const std::size_t index = slotOf(body);
    Slot& slot = slots_[index];
    const bool is_known = slot.pose && slot.object == body.object;
    if (!is_known || (slot.lacks_trees && has_new_trees)) set(index, body, now);
    if (!slot.pose || slot.pose->matrix() != body.frame_from_body.matrix()) {
      slot.pose = body.frame_from_body;
      distances_.move(index, *slot.pose);
    }
    slot.seen = moment_;
    slots_of_bodies_.push_back(index);
  }
  removeUnseen();
}

/// Forgets all bodies; the next moment adds them again. Trees stay as long as their points.
void LiveBodies::adopt(const std::shared_ptr<const Model>& model) {
  model_ = model;
  distances_ = BodyDistances();
  trees_.forgetErrors();
  mesh_uris_.clear();
  for (const auto& [uri, points] : model_->mesh_uris)
    mesh_uris_[points.get()] = &uri;
  slots_.assign(model_->links.size(), Slot());
  objects_.clear();
  free_slots_.clear();
}

std::size_t LiveBodies::slotOf(const Moment::Body& body) {
  if (body.link) return *body.link;
  const auto [entry, is_new] = objects_.try_emplace(body.object->bounded.name, slots_.size());
  if (!is_new) return entry->second;
  if (free_slots_.empty()) {
    slots_.emplace_back();
  } else {
    entry->second = free_slots_.back();
    free_slots_.pop_back();
  }
  return entry->second;
}

void LiveBodies::set(std::size_t index, const Moment::Body& body, TriangleTrees::Time now) {
  Slot& slot = slots_[index];
  slot = Slot();
  slot.object = body.object;
  auto made = std::make_shared<Body>(body.link ? linkBody(model_->links[*body.link])
                                               : objectBodyOf(body.object, now));
  slot.lacks_trees =
      std::any_of(made->shapes.begin(), made->shapes.end(),
                  [](const BodyShape& shape) { return shape.shape.points && !shape.triangles; });
  slot.body = std::move(made);
  distances_.set(index, slot.body);
}

Body LiveBodies::linkBody(const BoundedLink& link) {
  Body body;
  for (const Shape& shape : link.shapes) {
    body.shapes.push_back({shape});
    const auto uri = mesh_uris_.find(shape.points.get());
    if (uri != mesh_uris_.end())
      body.shapes.back().triangles = trees_.ofMesh(*uri->second, shape.points);
  }
  return body;
}

Body LiveBodies::objectBodyOf(const std::shared_ptr<const ObjectContent>& content,
                              TriangleTrees::Time now) {
  if (!hasTree(*content)) return objectBody(*content, nullptr);
  if (content->mesh_uri.empty()) return objectBody(*content, trees_.ofList(content, now));
  const auto& points = content->bounded.shapes.front().points;
  return objectBody(*content, trees_.ofMesh(content->mesh_uri, points));
}

void LiveBodies::removeUnseen() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.seen == moment_ || !slot.pose) continue;
    distances_.set(i, nullptr);
    if (slot.object) {
      objects_.erase(slot.object->bounded.name);
      free_slots_.push_back(i);
    }
    slot = Slot();
  }
  trees_.forgetUnused();
}

}  // namespace link_bounds
