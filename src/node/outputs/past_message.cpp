// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/outputs/past_message.h"

#include "node/outputs/box_message.h"

namespace link_bounds {

void fillBoxes(const PastScene& scene, const PastBoxes& boxes, const BoxRequest& request,
               AxisAlignedBoxArray& message) {
  BoxFiller filler(message, scene.frameName());
  for (const PastBoxes::Entry& entry : boxes.entries)
    filler.add(*entry.name, entry.state);
  filler.finish();
  if (request.stamp != 0) message.header.stamp.fromNSec(static_cast<std::uint64_t>(request.stamp));
}

}  // namespace link_bounds
