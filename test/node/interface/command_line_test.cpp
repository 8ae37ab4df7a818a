// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which arguments the node takes. What roscpp would do with them is not asked for: there is no
// ROS master here.
#include "node/interface/command_line.h"

#include <gtest/gtest.h>

#include <exception>
#include <string>
#include <vector>

#include "testing/refusal.h"

namespace link_bounds {
namespace {

CommandLine read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "link_bounds_publisher");
  return readCommandLine(static_cast<int>(arguments.size()), arguments.data(), publisherTables());
}

/// "" if the arguments are accepted.
std::string refusal(const std::vector<const char*>& arguments) {
  return refusalOf<std::exception>([&] { read(arguments); });
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLine, TakesWhatRoslaunchAndUsersGive) {
  const CommandLine line = read(
      {"__name:=bounds", "__log:=/home/robot/.ros/log/a b.log", "__ns:=/robot", "tf:=/other/tf",
       "~boxes:=/boxes", "robot_description:=/arm/urdf", "_padding:=0.05", "_timeout:=2",
       "_geometry:=collision", "_marker_labels:=True", "_parts_per_link:=8", "_paddign:=x"});
  EXPECT_FALSE(line.help || line.version);
  EXPECT_TRUE(line.warnings.empty());
}

TEST(CommandLine, WarnsOfTopicsWithoutTheirTilde) {
  const CommandLine line = read({"objects:=/markers", "joint_states:=/arm/joint_states"});
  ASSERT_EQ(line.warnings.size(), 1U);  // the other topic is public
  EXPECT_TRUE(contains(line.warnings[0], "write ~objects:=/markers")) << line.warnings[0];
}

TEST(CommandLine, WarnsOfPrivateNamesThatTheNodeDoesNotHave) {
  const CommandLine line =
      read({"~objcts:=/markers", "~geometry:=visual", "~joint_states:=/js", "~get_boxes:=/boxes_at",
            "~reload:=/again", "~get_loggers:=/loggers", "~objects:=/markers",
            "~/objects:=/markers", "~boxes:=/boxes"});
  const std::vector<std::string> expected{"which the node does not have; see --help",
                                          "write _geometry:=visual", "write joint_states:=/js"};
  ASSERT_EQ(line.warnings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_TRUE(contains(line.warnings[i], expected[i])) << line.warnings[i];
  EXPECT_TRUE(contains(refusal({"~padding:=0.05"}), "to set the parameter, write _padding:=0.05"));
}

TEST(CommandLine, KnowsHelpAndVersion) {
  EXPECT_TRUE(read({"-h"}).help);
  EXPECT_TRUE(read({"_padding:=1", "--help"}).help);
  EXPECT_TRUE(read({"--version"}).version);
}

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  for (const char* argument : {"--hepl", "-v", "robot.urdf", "", ":=x", "__nmae:=x"}) {
    const std::string reason = refusal({"_padding:=1", argument});
    EXPECT_TRUE(contains(reason, "argument \"" + std::string(argument) + "\" is unknown"))
        << reason;
  }
  EXPECT_TRUE(contains(refusal({"--hepl"}), "see --help"));
}

TEST(CommandLine, RefusesWhatIsNoName) {
  EXPECT_TRUE(contains(refusal({"__name:=a/b"}), "write a namespace as __ns:=NAMESPACE"));
  EXPECT_TRUE(contains(refusal({"__ns:=0"}), "is no namespace"));
  EXPECT_TRUE(contains(refusal({"tf:=a b"}), "\"a b\" is no name of ROS"));
  EXPECT_TRUE(contains(refusal({"_a b:=1"}), "names no parameter"));
}

TEST(CommandLine, SaysHowAParameterIsSet) {
  EXPECT_TRUE(contains(refusal({"padding:=0.05"}), "to set the parameter, write _padding:=0.05"));
  // A launch file may remap such a name for all nodes of a scope.
  const CommandLine line = read({"geometry:=collision"});
  ASSERT_EQ(line.warnings.size(), 1u);
  EXPECT_TRUE(contains(line.warnings[0], "write _geometry:=collision"));
}

TEST(CommandLine, RefusesValuesThatTheParameterCannotHave) {
  for (const char* argument :
       {"_padding:=abc", "_padding:=-1", "_timeout:=true", "_geometry:=wrong", "_links:=[a]",
        "_parts_per_link:=0", "_parts_per_link:=1.5", "_marker_labels:=1", "_fixed_frame:=7"}) {
    const std::string name = std::string(argument).substr(1, std::string(argument).find(":=") - 1);
    EXPECT_TRUE(contains(refusal({argument}), "~" + name)) << argument;
  }
}

}  // namespace
}  // namespace link_bounds
