// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes a status WARN although all boxes are there.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "node/inputs/tf_receiver.h"
#include "node/upkeep/diagnostics.h"
#include "testing/live_boxes_testing.h"
#include "testing/own_master.h"
#include "testing/patience.h"

namespace link_bounds {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kAge = 40;  // of a box [s]

class DiagnosticsLevels : public testing::Test {
 protected:
  DiagnosticsLevels() {
    auto model = std::make_shared<Model>(
        *modelOf("base", {meshLink("base", 1), meshLink("slow", 1), meshLink("fast", 1)}));
    model->parameters.distance_warning = 0.1;
    model->left_out = "left out are links";
    for (const char* const name : {"whole", "lacking"})
      model->groups.emplace_back().name = name;
    model->groups.front().members = {1, 2};
    model->groups.back().objects = {{"cup", 1}};
    scene_.adopt(model, ros::Time(1));
    const ros::Time now = ros::Time::now();
    for (const auto& [name, age] : {std::pair("slow", kAge), std::pair("fast", kAge / 2)})
      tf_.add({edge("base", name, now.toSec() - age, Eigen::Quaterniond::Identity(),
                    Eigen::Vector3d::Zero())},
              false, now);
    scene_.update(now);
    subscriber_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          status_ = array->status.front();
          has_status_ = true;
        });
  }

  /// The status of a node whose health a function changes.
  DiagnosticStatus statusWith(const std::function<void(Health&)>& change) {
    Health health;
    change(health);
    has_status_ = false;
    EXPECT_TRUE(becomesTrue([this] { return subscriber_.getNumPublishers() > 0; }));
    diagnostics_.publish(scene_, health, times_);
    EXPECT_TRUE(isServed([this] { return has_status_; }));
    return status_;
  }

  OwnMaster master_{"diagnostics_levels_test"};
  ros::NodeHandle node_;
  Diagnostics diagnostics_{node_};
  TransformBuffer tf_;
  Scene scene_{tf_};
  CallbackTimes times_;
  ros::Subscriber subscriber_;
  DiagnosticStatus status_;
  bool has_status_ = false;
};

/// In one test: a process has one master.
TEST_F(DiagnosticsLevels, MessagesOfTfThatWereLostAreTold) {
  const DiagnosticStatus calm =
      statusWith([](Health& health) { health.max_waiting = TfReceiver::kQueue - 1; });
  EXPECT_EQ(calm.level, DiagnosticStatus::OK) << calm.message;
  const auto value = [&calm](const std::string& key) {
    const auto row = std::find_if(calm.values.begin(), calm.values.end(),
                                  [&key](const auto& entry) { return entry.key == key; });
    return row == calm.values.end() ? "" : row->value;
  };
  EXPECT_EQ(value("left out"), "left out are links");
  EXPECT_EQ(value("incomplete groups"), "lacking");
  const std::string oldest = value("oldest box of a link [ms]");
  EXPECT_NE(oldest.find(" (slow)"), std::string::npos) << oldest;
  EXPECT_GE(std::stod(oldest), kAge * 1e3 - 1);
  EXPECT_LT(std::stod(oldest), kAge * 2e3);
  const DiagnosticStatus full =
      statusWith([](Health& health) { health.max_waiting = TfReceiver::kQueue; });
  EXPECT_EQ(full.level, DiagnosticStatus::WARN);
  EXPECT_EQ(full.message, "messages of /tf, ~objects or ~neighbours may have been dropped");
  const auto failed = [](Health& health) { health.errors = 3; };
  const DiagnosticStatus failing = statusWith(failed);
  EXPECT_EQ(failing.level, DiagnosticStatus::ERROR);
  EXPECT_EQ(failing.message.rfind("3 unexpected errors: ", 0), 0U) << failing.message;
  EXPECT_EQ(statusWith(failed).level, DiagnosticStatus::OK) << "no error since the last status";
  const DiagnosticStatus skipped = statusWith([](Health& health) { health.skipped = 1; });
  EXPECT_EQ(skipped.level, DiagnosticStatus::WARN);
  EXPECT_EQ(skipped.message, "tf comes faster than it can be read");
  const DiagnosticStatus behind = statusWith([](Health& health) {
    health.distances.behind = 60;
    health.distances.nearest = Distance();
    health.distances.nearest->first = "a";
    health.distances.nearest->distance = 0.5;
  });
  EXPECT_EQ(behind.level, DiagnosticStatus::WARN);
  EXPECT_EQ(behind.message, "60 s without new distances");
  const DiagnosticStatus late = statusWith([](Health& health) {
    health.behind = {{"earliest", 0.2}, {"stopping", 0.3}};
  });
  EXPECT_EQ(late.level, DiagnosticStatus::WARN);
  EXPECT_EQ(late.message, "~stopping was up to 300 ms behind ~boxes");
}

}  // namespace
}  // namespace link_bounds
