// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/history/edge_motion.h"

namespace link_bounds {

void EdgeMotion::seek(std::int64_t time) {
  std::size_t place = time < older().stamp ? 0 : place_;
  while (place + 1 < samples_.size() && samples_[place + 1]->stamp <= time)
    ++place;
  if (place != place_) goTo(place);
}

void EdgeMotion::goTo(std::size_t place) {
  place_ = place;
  const Tf2Pose& from = older().parent_from_child;
  const Tf2Pose& to = hasNext() ? newer().parent_from_child : from;
  step_ = stepBetween(from, to);
  is_sudden_ = link_bounds::isSudden(from, to);
}

Tf2Pose EdgeMotion::at(std::int64_t time) const {
  const bool is_between = hasNext() && time > older().stamp;
  return is_between ? interpolated(older(), newer(), time) : older().parent_from_child;
}

EdgeStep EdgeMotion::stepIn(std::int64_t duration) const {
  if (!hasNext()) return step_;
  return step_.in(static_cast<double>(duration) /
                  static_cast<double>(newer().stamp - older().stamp));
}

}  // namespace link_bounds
