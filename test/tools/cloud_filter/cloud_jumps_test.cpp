// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated time jumps back while the filter is busy: what is of the old time gets no pose of the
// new one, and what is of the new time none of the old one.
#include <string>

#include "tools/cloud_filter/simulated_filter.h"

namespace link_bounds {
namespace {

TEST_F(SimulatedFilter, MixesNoTimes) {
  holdUp();
  for (int i = 1; i <= 5; ++i)
    tell(kBegin + i, 1);
  sendCloud(ros::Time(kBegin + 5.5));  // tf of that time never comes
  tell(kBegin, 0);
  sendCloud(ros::Time(kBegin + 5.2));  // is late, too
  for (int i = 1; i <= 10; ++i)
    tell(kBegin + i, 0);
  sendCloud(ros::Time(kBegin + 3));  // where the cube is at the sensor
  for (std::uint32_t i = 0; i < TfReceiver::kQueue; ++i)
    tellTime(kBegin + 10);
  gate_.open();
  std::string robot_points;
  ASSERT_TRUE(isServed([&] {
    if (values_["robot points [%]"] != "0.00") robot_points = values_["robot points [%]"];
    EXPECT_EQ(message_.find("transforms may have been lost"), std::string::npos) << "all came";
    return values_["filtered"] == "1" && values_["dropped"] == "3";
  })) << values_["filtered"]
      << " filtered, " << values_["dropped"] << " dropped";
  EXPECT_EQ(robot_points, "100.00");
}

}  // namespace
}  // namespace link_bounds
