// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds and scans wait for tf each on their own.
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

class PatientFilter : public FilterInProcess {
 protected:
  PatientFilter() : FilterInProcess(10) {}
};

TEST_F(PatientFilter, AScanThatWaitsForTfDelaysNoCloud) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(1);
  scan.header.frame_id = "nowhere";
  scan.range_max = 2;
  scan.angle_increment = 0.1f;
  scan.ranges = {1};
  scans_.publish(scan);
  ASSERT_TRUE(isServed([this] { return values_["waiting"] == "1"; }));
  send("cube");
  EXPECT_TRUE(isServed([this] { return values_["filtered"] == "1"; }));
  EXPECT_EQ(values_["waiting"], "1") << "the scan waits still";
}

}  // namespace
}  // namespace link_bounds
