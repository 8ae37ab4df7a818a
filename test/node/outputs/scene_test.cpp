// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Links before objects; groups over both.
#include "world/bodies/scene.h"

#include <gtest/gtest.h>

#include "node/outputs/messages/box_message.h"
#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

class SceneTest : public testing::Test {
 protected:
  SceneTest() {
    auto model = std::make_shared<Model>(*modelOf("base", {meshLink("base", 1)}));
    model->groups.push_back(groupOf({0}, {{"scene", 2}}, {}));
    model->groups.push_back(groupOf({}, {}, {"scene"}));
    model->groups.push_back(groupOf({}, {}, {"nothing"}));
    scene_.adopt(model, now_);
  }

  static SceneGroup groupOf(std::vector<std::size_t> links, std::vector<ObjectKey> objects,
                            std::vector<std::string> namespaces) {
    SceneGroup group;
    group.members = std::move(links);
    group.objects = std::move(objects);
    group.namespaces = std::move(namespaces);
    return group;
  }

  /// A cube of 1 m at x.
  void put(const std::string& ns, int id, double x, const std::string& frame = "base") {
    ObjectContent content;
    content.bounded.name = objectName({ns, id});
    content.bounded.shapes = {
        {nullptr, Solid::kBox, {1, 1, 1}, Eigen::Affine3d(Eigen::Translation3d(x, 0, 0))}};
    content.frame = frame;
    scene_.objects.put({ns, id}, content, now_);
  }

  BoxState group(std::size_t i) const { return groupState(scene_.model()->groups[i], scene_); }

  ros::Time now_{100};
  TransformBuffer tf_;
  Scene scene_{tf_};
};

TEST_F(SceneTest, LinksComeFirstThenObjectsByNamespaceAndNumber) {
  put("scene", 10, 1);
  put("scene", 2, 2);
  put("a", 3, 3);
  put("b", 1, 4, "unknown");
  AxisAlignedBoxArray message;
  fillBoxes(scene_, message);
  std::vector<std::string> names;
  for (const AxisAlignedBox& box : message.boxes)
    names.push_back(box.name);
  EXPECT_EQ(names, (std::vector<std::string>{"base", "a/3", "scene/2", "scene/10"}));
  EXPECT_EQ(message.incomplete, std::vector<std::string>{"b/1"});
}

TEST_F(SceneTest, AGroupWaitsForTheObjectItNames) {
  EXPECT_TRUE(group(1).incomplete);
  EXPECT_TRUE(group(1).box) << "of the link";
  put("scene", 2, 5);
  EXPECT_FALSE(group(1).incomplete);
  EXPECT_NEAR(group(1).box->max().x(), 5.5, 1e-12);
  put("scene", 2, 5, "unknown");
  EXPECT_TRUE(group(1).incomplete);
}

TEST_F(SceneTest, AGroupOfANamespaceIsWhateverIsThere) {
  EXPECT_FALSE(group(2).box);
  EXPECT_FALSE(group(2).incomplete);
  put("scene", -4, -7);
  put("scene", 2, 5);
  put("scenery", 1, 50);
  put("scen", 1, 50);
  EXPECT_NEAR(group(2).box->min().x(), -7.5, 1e-12);
  EXPECT_NEAR(group(2).box->max().x(), 5.5, 1e-12);
  put("scene", 9, 5, "unknown");
  EXPECT_TRUE(group(2).incomplete);
  EXPECT_FALSE(group(3).incomplete);
  EXPECT_FALSE(group(3).box);
}

TEST_F(SceneTest, TheRobotIsItsLinksAlone) {
  const BoxState before = group(0);
  put("scene", 1, 50);
  EXPECT_EQ(group(0).box->max(), before.box->max());
}

}  // namespace
}  // namespace link_bounds
