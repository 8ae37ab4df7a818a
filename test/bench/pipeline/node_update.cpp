// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Scene::update() in its parts.
#include "bench/pipeline/node_update.h"

#include <stdexcept>

#include "node/outputs/messages/box_message.h"

namespace link_bounds::bench {

std::shared_ptr<const Model> modelOf(const TfRobot& robot, const MeasuredMeshes& meshes) {
  auto model = std::make_shared<Model>();
  model->fixed_frame = robot.base;
  model->frames = robot.links;
  SceneGroup all;
  all.name = "robot";
  for (const std::string& link : robot.links) {
    Shape shape;
    shape.points = meshes[all.members.size() % meshes.size()].points;
    model->links.push_back({link, {shape}, 0, ""});
    all.members.push_back(all.members.size());
  }
  model->groups.push_back(all);
  return model;
}

const std::array<NodeUpdate::Stage, 7> NodeUpdate::kStages{
    {{"read the message", &NodeUpdate::readMessage},
     {"insert transforms", &NodeUpdate::insertTransforms},
     {"poses", &NodeUpdate::updatePoses},
     {"boxes", &NodeUpdate::updateBoxes},
     {"objects", &NodeUpdate::updateObjects},
     {"fill ~boxes", &NodeUpdate::fillBoxMessage},
     {"fill ~groups", &NodeUpdate::fillGroupMessage}}};

NodeUpdate::NodeUpdate(const std::shared_ptr<const Model>& model) {
  scene_.adopt(model, ros::Time(1));
}

void NodeUpdate::receive(Bytes& bytes, ros::Time now) {
  readMessage(bytes, now);
  insertTransforms(bytes, now);
}

__attribute__((noinline)) void NodeUpdate::answer(Bytes& bytes, ros::Time now) {
  for (const Stage& stage : kStages)
    (this->*stage.run)(bytes, now);
  if (!is_changed_) throw std::runtime_error("the update brought nothing new");
  if (!boxes_.incomplete.empty()) throw std::runtime_error("a link has no box");
}

__attribute__((noinline)) void NodeUpdate::readMessage(Bytes& bytes, ros::Time) {
  deserialize(bytes, message_);
}

__attribute__((noinline)) void NodeUpdate::insertTransforms(Bytes&, ros::Time now) {
  tf_.add(message_.transforms, false, now);
}

__attribute__((noinline)) void NodeUpdate::updatePoses(Bytes&, ros::Time now) {
  scene_.frames.update(now);
}

__attribute__((noinline)) void NodeUpdate::updateBoxes(Bytes&, ros::Time) {
  is_changed_ = scene_.links.update();
}

__attribute__((noinline)) void NodeUpdate::updateObjects(Bytes&, ros::Time now) {
  is_changed_ |= scene_.objects.update(now);
}

__attribute__((noinline)) void NodeUpdate::fillBoxMessage(Bytes&, ros::Time) {
  fillBoxes(scene_, boxes_);
}

__attribute__((noinline)) void NodeUpdate::fillGroupMessage(Bytes&, ros::Time) {
  fillGroups(scene_, groups_);
}

}  // namespace link_bounds::bench
