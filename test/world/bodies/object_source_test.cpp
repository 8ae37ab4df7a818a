// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a marker that cannot be bounded.
#include "world/bodies/object_source.h"

#include <gtest/gtest.h>

#include <limits>

#include "testing/marker_testing.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

const ObjectKey kMarkerKey{"scene", 1};

class ObjectSourceTest : public testing::Test {
 protected:
  ObjectSourceTest() {
    frames_.setTarget("map", 2, now_);
    objects_.adopt(now_);
  }

  static Marker cube() {
    Marker marker = markerOf(Marker::CUBE, {1, 1, 1});
    marker.header.frame_id = "map";
    marker.ns = kMarkerKey.ns;
    marker.id = kMarkerKey.id;
    return marker;
  }

  static Marker badCube(double lifetime) {
    Marker marker = cube();
    marker.pose.position.x = std::numeric_limits<double>::quiet_NaN();
    marker.lifetime = ros::Duration(lifetime);
    return marker;
  }

  bool take(Marker marker, const std::string& publisher = "/camera") {
    return source_.take(std::move(marker), publisher, now_);
  }

  static Marker meshMarker(int id, const std::string& uri) {
    Marker marker = markerOf(Marker::MESH_RESOURCE, {1, 1, 1});
    marker.header.frame_id = "map";
    marker.ns = "scene";
    marker.id = id;
    marker.mesh_resource = uri;
    return marker;
  }

  static Marker cubeOf(const std::string& ns) {
    Marker marker = cube();
    marker.ns = ns;
    return marker;
  }

  /// As another node of this package sends it with its drawings.
  static Marker deleteAllOfDrawings() {
    Marker marker;
    marker.ns = "link_bounds/";
    marker.action = Marker::DELETEALL;
    return marker;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& [key, object] : objects_.objects())
      result.push_back(objectName(key));
    return result;
  }

  bool pass(double seconds) {
    now_ += ros::Duration(seconds);
    return objects_.expire(now_);
  }

  void expectRefused(const std::string& begin) const {
    const LiveObject& object = objects_.objects().at(kMarkerKey);
    EXPECT_TRUE(object.state.incomplete);
    EXPECT_FALSE(object.state.box);
    EXPECT_EQ(objects_.reason(object).rfind(begin, 0), 0u) << objects_.reason(object);
  }

  ros::Time now_{100};
  TransformBuffer tf_;
  FrameTracker frames_{tf_};
  LiveObjects objects_{frames_};
  int requests_ = 0;
  MeshRequest last_;
  ObjectSource source_{objects_, [this](const MeshRequest& request) {
                         ++requests_;
                         last_ = request;
                       }};
};

/// After ~reload a file may be another one: then nothing is complete before it is read again.
TEST_F(ObjectSourceTest, AMeshThatIsReadAgainHasItsOldBoxAndIsIncomplete) {
  const auto cornersOf = [](float size) {
    const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {size, 0, 0}, {0, size, size}};
    return std::make_shared<const PointSet>(points);
  };
  const auto stateOf = [this](int id) { return objects_.objects().at({"scene", id}).state; };
  const std::string uri = "file:///part.stl";
  const auto markerAt = [&](int id, double x) {
    Marker marker = meshMarker(id, uri);
    marker.pose.position.x = x;
    return marker;
  };
  take(markerAt(1, 0));
  const auto points = cornersOf(1);
  source_.fillMesh(last_, {points, ""}, now_);
  EXPECT_FALSE(stateOf(1).incomplete);
  requests_ = 0;
  EXPECT_FALSE(source_.reloadMeshes({{uri, points}}, now_));
  EXPECT_EQ(requests_, 1);
  EXPECT_FALSE(stateOf(1).incomplete) << "the file has not changed";
  for (const auto& read : {points, cornersOf(2)}) {
    EXPECT_TRUE(source_.reloadMeshes({{uri, cornersOf(3)}}, now_));
    take(markerAt(1, 5));
    take(markerAt(2, 7));
    for (const int id : {1, 2}) {
      const BoxState state = stateOf(id);
      EXPECT_TRUE(state.incomplete);
      ASSERT_TRUE(state.box);
      EXPECT_NEAR(state.box->min().x(), id == 1 ? 5 : 7, 1e-6) << "it moves";
      EXPECT_NEAR(state.box->sizes().x(), 1, 1e-6);
    }
    source_.fillMesh(last_, {read, ""}, now_);
    EXPECT_FALSE(stateOf(1).incomplete || stateOf(2).incomplete);
    take(markerAt(1, 0));
  }
  EXPECT_NEAR(stateOf(1).box->sizes().x(), 2, 1e-6);
  EXPECT_NEAR(stateOf(2).box->sizes().x(), 2, 1e-6);
}

/// Objects of one mesh wait for the same load, however many names there were between them.
TEST_F(ObjectSourceTest, MeshesInUseAreNotForgottenForOthers) {
  take(meshMarker(1, "file:///part.stl"));
  for (int i = 0; i < 25000; ++i)
    take(meshMarker(2, "file:///" + std::to_string(i)));
  EXPECT_EQ(requests_, 25001);
  take(meshMarker(3, "file:///part.stl"));
  EXPECT_EQ(requests_, 25001);
  EXPECT_EQ(objects_.objects().at({"scene", 1}).content->mesh_use,
            objects_.objects().at({"scene", 3}).content->mesh_use);
}

TEST_F(ObjectSourceTest, AnUnknownActionIsRefusedWithAReason) {
  for (const int action : {1, 4, -1, 1000}) {
    take(cube());
    EXPECT_TRUE(objects_.objects().at(kMarkerKey).state.box);
    Marker marker = cube();
    marker.action = action;
    EXPECT_TRUE(take(marker));
    expectRefused("action " + std::to_string(action));
  }
  EXPECT_TRUE(take(cube()));
  EXPECT_FALSE(objects_.objects().at(kMarkerKey).state.incomplete);
}

TEST_F(ObjectSourceTest, AnUnknownActionOfATextIsRefusedToo) {
  Marker text = cube();
  text.type = Marker::TEXT_VIEW_FACING;
  text.action = 7;
  take(text);
  expectRefused("action 7");
}

TEST_F(ObjectSourceTest, ARefusedMarkerHasItsLifetime) {
  take(badCube(0.5));
  expectRefused("pose");
  EXPECT_FALSE(pass(0.4));
  EXPECT_FALSE(take(badCube(0.5))) << "nothing changes but its age";
  EXPECT_FALSE(pass(0.4));
  EXPECT_TRUE(pass(0.2));
  EXPECT_TRUE(objects_.objects().empty());
}

TEST_F(ObjectSourceTest, WithoutALifetimeARefusedMarkerStays) {
  take(badCube(0));
  pass(1000);
  expectRefused("pose");
}

TEST_F(ObjectSourceTest, RunningNumbersLeaveNothingBehind) {
  for (int i = 0; i < 300; ++i) {
    Marker marker = badCube(0.5);
    marker.id = i;
    take(marker);
    pass(0.1);
  }
  EXPECT_LE(objects_.objects().size(), 6u);
}

TEST_F(ObjectSourceTest, ARefusedMarkerLeavesNoFrame) {
  const std::size_t frames = tf_.size();
  take(badCube(0));
  for (const char* frame : {"", "/"}) {
    Marker marker = cube();
    marker.header.frame_id = frame;
    take(marker);
    expectRefused("header.frame_id");
  }
  EXPECT_EQ(tf_.size(), frames);
  EXPECT_TRUE(take(cube()));
}

TEST_F(ObjectSourceTest, ADeleteAllOfDrawingsRemovesThoseOfItsSenderOnly) {
  take(cubeOf("table"), "/camera");
  take(cubeOf("forearm"), "/arm");
  take(cubeOf("link_bounds/objects/table"), "/arm");
  EXPECT_TRUE(take(deleteAllOfDrawings(), "/arm"));
  EXPECT_EQ(names(), std::vector<std::string>{"table/1"});
  EXPECT_FALSE(take(deleteAllOfDrawings(), "/arm"));
  Marker all = deleteAllOfDrawings();
  all.ns = "any";
  EXPECT_TRUE(take(all, "/arm"));
  EXPECT_TRUE(objects_.objects().empty());
}

TEST_F(ObjectSourceTest, WhoSentAnObjectLastIsItsSender) {
  take(cubeOf("table"), "/arm");
  take(cubeOf("forearm"), "/camera");
  take(cubeOf("table"), "/camera");
  take(cubeOf("forearm"), "/arm");
  EXPECT_TRUE(take(deleteAllOfDrawings(), "/arm"));
  EXPECT_EQ(names(), std::vector<std::string>{"table/1"});
}

}  // namespace
}  // namespace link_bounds
