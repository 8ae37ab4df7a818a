// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two observations suffice: the younger one takes the place of the older one after a moment.
#include "world/tf/recent_time.h"

namespace link_bounds {

void RecentTime::observe(ros::Time now, ros::SteadyTime steady_now) {
  if (steady_now - young_.steady >= moment_ || now < old_.time) {
    old_ = young_;
    young_ = {now, steady_now};
  }
  if (steady_now - old_.steady > moment_ + moment_ || now < old_.time) old_ = young_;
}

void RecentTime::setMoment(ros::WallDuration moment) {
  *this = RecentTime();
  moment_ = moment;
}

}  // namespace link_bounds
