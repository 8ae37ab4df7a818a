// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts use the poses of the link boxes, so both always agree.
#include "node/outputs/messages/part_boxes.h"

#include <utility>

#include "node/outputs/messages/box_message.h"

namespace link_bounds {

void PartBoxes::adopt(std::shared_ptr<const Model> model) {
  model_ = std::move(model);
  parts_.clear();
  for (const std::vector<BoundedLink>& parts : model_->parts)
    parts_.emplace_back(parts);
}

bool PartBoxes::fill(const Moment& moment, AxisAlignedBoxArray& message) {
  if (moment.model->parameters.parts_per_link <= 1) return false;
  if (moment.model != model_) adopt(moment.model);
  BoxFiller filler(message, model_->fixed_frame);
  for (const std::size_t i : moment.incomplete_links)
    filler.addIncomplete(model_->links[i].name);
  for (const Moment::Body& body : moment.bodies) {
    if (!body.link) break;
    const std::size_t i = *body.link;
    BoxState state;
    state.stamp = body.stamp;
    state.incomplete = false;  // incomplete links are named once, above
    for (std::size_t part = 0; part < model_->parts[i].size(); ++part) {
      parts_[i].update(part, body.frame_from_body);
      state.box = parts_[i].box(part);
      filler.add(model_->links[i].name, state);
    }
  }
  filler.finish();
  return true;
}

}  // namespace link_bounds
