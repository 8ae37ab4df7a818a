// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts have the poses of the published boxes of their links, so both always agree.
#include "node/outputs/part_boxes.h"

#include "node/outputs/box_message.h"

namespace link_bounds {

void PartBoxes::adopt(const Model& model) {
  are_wanted_ = model.parameters.parts_per_link > 1;
  parts_.clear();
  states_.clear();
  for (const std::vector<BoundedLink>& parts : model.parts)
    parts_.emplace_back(parts);
}

void PartBoxes::place(const LiveBoxes& links) {
  if (!are_wanted_) return;
  states_ = links.states();
  poses_.resize(states_.size());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].box) poses_[i] = links.pose(i);
  }
}

void PartBoxes::fill(const Model& model, AxisAlignedBoxArray& message) {
  BoxFiller filler(message, model.fixed_frame);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    BoxState state = states_[i];
    if (!state.box) {
      filler.add(model.links[i].name, state);
      continue;
    }
    for (std::size_t part = 0; part < model.parts[i].size(); ++part) {
      parts_[i].update(part, poses_[i]);
      state.box = parts_[i].box(part);
      filler.add(model.links[i].name, state);
      state.incomplete = false;  // names the link once
    }
  }
  filler.finish();
}

}  // namespace link_bounds
