// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Access to the connection behind a ros::SingleSubscriberPublisher.
//
// roscpp gives it to nobody, and SingleSubscriberPublisher itself ends with the callback that it is
// given to. In an explicit instantiation C++ allows to name a private member. ROS 1 is frozen: the
// member stays.
#pragma once

#include <ros/single_subscriber_publisher.h>

namespace link_bounds {
namespace {

ros::SubscriberLinkPtr linkOf(const ros::SingleSubscriberPublisher& subscriber);

template <ros::SubscriberLinkPtr ros::SingleSubscriberPublisher::*member>
struct LinkAccess {
  friend ros::SubscriberLinkPtr linkOf(const ros::SingleSubscriberPublisher& subscriber) {
    return subscriber.*member;
  }
};

template struct LinkAccess<&ros::SingleSubscriberPublisher::link_>;

}  // namespace
}  // namespace link_bounds
