// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which link carries a body, where on that link it is, and what is not known of it.
#include "world/path/path_scene.h"

#include "testing/live_objects_testing.h"
#include "testing/moving_robot.h"

namespace link_bounds {
namespace {

constexpr double kStamp = MovingRobot::kStamp;

/// An arm turns on a base; a frame without geometry is fixed to the arm.
constexpr char kRobot[] = R"(<robot name="arm">
  <link name="base"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <link name="arm"><visual><geometry><box size="0.7 0.1 0.1"/></geometry></visual></link>
  <link name="tool"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="flange" type="fixed"><parent link="arm"/><child link="tool"/>
    <origin xyz="1 0 0"/></joint>
</robot>)";

using Names = std::vector<std::string>;

Eigen::Isometry3d at(double x, double angle = 0) {
  return Eigen::Translation3d(x, 0, 0) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
}

Parameters inFrame(const std::string& fixed_frame) {
  Parameters parameters;
  parameters.fixed_frame = fixed_frame;
  return parameters;
}

/// A cart on a floor that is tilted.
constexpr char kCart[] = R"(<robot name="cart"><link name="floor"/>
  <link name="cart"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <joint name="drive" type="planar"><parent link="floor"/><child link="cart"/>
    <origin xyz="1 0 0" rpy="0.3 0 0"/><axis xyz="0 0 1"/></joint>
</robot>)";

/// A head that does not turn, beside an arm that does.
constexpr char kHead[] = R"(<robot name="head"><link name="base"/><link name="head"/>
  <link name="arm"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <joint name="neck" type="fixed"><parent link="base"/><child link="head"/>
    <origin xyz="0 0 1"/></joint>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/></joint>
</robot>)";

/// The arm may touch what it holds.
Parameters ignoring() {
  Parameters parameters = inFrame("map");
  parameters.ignore_pairs = {"arm held/*"};
  return parameters;
}

Parameters attaching() {
  Parameters parameters = inFrame("map");
  parameters.attached = {{"arm", {"held/*"}}};
  return parameters;
}

/// The request that a trajectory of these joints makes.
PathScene pathOf(const Scene& scene, const std::shared_ptr<const Model>& model, double now,
                 const std::set<std::string>& joints) {
  SceneCopy copy(pathRequest(), model);
  while (!copy.proceed(scene, ros::Time(now), std::chrono::seconds(1))) {
  }
  const auto past = copy.take();
  const auto goes_on = [] { return false; };
  PathTrees trees([](const auto&, const auto&) { return std::vector<LoadedTree>(); });
  trees.prepare(*past, goes_on);
  return pathScene(*past, joints, trees, {1000, goes_on});
}

/// The remedy is another than where the file is broken.
TEST(PathTrees, ALoadThatTheRequestCancelledIsToBeAskedForAgain) {
  Model model;
  model.mesh_uris["a.stl"] = meshLink("a", 1).shapes.front().points;
  PastScene scene(BoxRequest(), 0);
  scene.model = std::make_shared<const Model>(model);
  for (const bool is_cancelled : {true, false}) {
    LoadedTree tree{model.mesh_uris["a.stl"], nullptr, "why; call ~reload"};
    tree.is_cancelled = is_cancelled;
    PathTrees trees([&](const auto&, const auto&) { return std::vector<LoadedTree>{tree}; });
    trees.prepare(scene, [] { return false; });
    EXPECT_EQ(trees.problem(), is_cancelled
                                   ? "a.stl: its triangles were not loaded in time; ask again"
                                   : "why; call ~reload");
  }
}

/// Nothing is in tf.
struct QuietArm : MovingRobot {
  explicit QuietArm(const Parameters& parameters) : MovingRobot(kRobot, parameters) {
    put("post", boxIn("map"));
  }

  void put(const std::string& ns, ObjectContent content) {
    content.bounded.name = ns + "/1";
    scene().objects.put({ns, 1}, std::move(content), ros::Time(kStamp));
  }

  PathScene path(double now = kStamp) { return path(now, model()); }

  PathScene path(double now, const std::shared_ptr<const Model>& of_request) {
    return pathOf(scene(), of_request, now, {"turn"});
  }
};

struct Arm : QuietArm {
  explicit Arm(const Parameters& parameters) : QuietArm(parameters) { send(kStamp, {0, 0}); }
};

TEST(PathScene, AJointOfTheTrajectoryTurnsAboutTheAxisThatTfHas) {
  const double off = 0.0009;  // m, as of a robot that was calibrated
  Arm arm(inFrame("map"));
  arm.add("base", "arm", kStamp + 0.1, at(off, 0.7));
  const PathScene path = arm.path(kStamp + 0.1);
  for (const Joint& joint : path.robot.joints) {
    if (joint.name != "turn") continue;
    EXPECT_LT((joint.parent_from_joint.matrix() - at(off).matrix()).norm(), 1e-12);
    return;
  }
  FAIL() << "there is no such joint";
}

/// Where a body of one shape is on its link.
Eigen::Vector3d placeOf(const PathScene& path, const std::string& name) {
  const auto found = std::find(path.names.begin(), path.names.end(), name);
  const Body& body = path.bodies.at(static_cast<std::size_t>(found - path.names.begin())).body;
  return body.shapes.at(0).shape.link_from_shape.translation();
}

ObjectContent brokenIn(const std::string& frame) {
  ObjectContent content = boxIn(frame);
  content.bounded.missing = "broken";
  return content;
}

TEST(PathScene, ABodyThatIsAttachedIsIncompleteWithoutItsGeometry) {
  Arm arm(attaching());
  for (const char* frame : {"map", "arm", "nowhere", ""}) {
    arm.put("held", brokenIn(frame));
    EXPECT_EQ(arm.path().incomplete, Names{"held/1"}) << frame;
  }
}

TEST(PathScene, ABodyBelowAMovingLinkIsIncompleteWithoutItsGeometry) {
  Arm arm(ignoring());
  EXPECT_EQ(arm.path().incomplete, Names{});
  arm.put("held", brokenIn("arm"));
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"});
  arm.put("held", brokenIn("base"));
  EXPECT_EQ(arm.path().incomplete, Names{}) << "it rests, and the arm may touch it";
}

TEST(PathScene, ABodyWhoseMeshLoadsMovesWithItsLink) {
  Arm arm(ignoring());
  arm.put("held", boxIn("arm"));
  EXPECT_EQ(arm.path().incomplete, Names{});
  ObjectContent mesh = meshOf("package://a/b.stl");
  mesh.frame = "arm";
  arm.put("held", mesh);
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"}) << "the box that it had before is there";
}

TEST(PathScene, ABodyMayMoveIfItsLinkIsNotKnown) {
  Arm arm(ignoring());
  for (const ObjectContent& content : {brokenIn(""), brokenIn("nowhere"), boxIn("nowhere")}) {
    arm.put("held", content);
    EXPECT_EQ(arm.path().incomplete, Names{"held/1"}) << content.frame;
  }
}

constexpr char kTwoArms[] = R"(<robot name="arms">
  <link name="base"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <link name="arm"><visual><geometry><box size="0.7 0.1 0.1"/></geometry></visual></link>
  <link name="other"><visual><geometry><box size="0.7 0.1 0.1"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="turn_other" type="revolute"><parent link="base"/><child link="other"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
</robot>)";

TEST(PathScene, ABodyThatIsAttachedToAnotherArmThanItFollowsMayMoveWithEither) {
  for (const char* frame : {"arm", "other"}) {
    Parameters parameters = inFrame("base");
    parameters.attached = {{"arm", {"held/*"}}};
    parameters.ignore_pairs = {"other held/*", "arm held/*"};
    MovingRobot arms(kTwoArms, parameters);
    arms.add("base", "arm", kStamp, at(0, 1));
    arms.add("base", "other", kStamp, at(0, 2));
    ObjectContent held = boxIn(frame);
    held.bounded.name = "held/1";
    arms.scene().objects.put({"held", 1}, std::move(held), ros::Time(kStamp));
    ObjectContent post = boxIn("base");
    post.bounded.name = "post/1";
    arms.scene().objects.put({"post", 1}, std::move(post), ros::Time(kStamp));
    const bool is_of_arm = frame == std::string("arm");
    for (const char* joint : {"turn", "turn_other"}) {
      EXPECT_EQ(pathOf(arms.scene(), arms.model(), kStamp, {joint}).incomplete,
                is_of_arm ? Names{} : Names{"held/1"})
          << frame << ", " << joint;
    }
  }
}

TEST(PathScene, APlacedBodyMayStayBehindAFixedFrameThatTheTrajectoryMoves) {
  MovingRobot arms(kTwoArms, inFrame("arm"));
  arms.add("base", "arm", kStamp, at(0, 1));
  arms.add("base", "other", kStamp, at(0, 2));
  const auto incomplete = [&](const ObjectContent& content, const char* joint) {
    arms.scene().objects.put(kKey, content, ros::Time(kStamp));
    return pathOf(arms.scene(), arms.model(), kStamp, {joint}).incomplete;
  };
  EXPECT_EQ(incomplete(boxIn("base", kStamp), "turn"), Names{"scene/1"});
  EXPECT_EQ(incomplete(boxIn("base", kStamp), "turn_other"), Names{});
  EXPECT_EQ(incomplete(boxIn("base"), "turn"), Names{}) << "it follows its frame";
  EXPECT_EQ(incomplete(boxIn("arm", kStamp), "turn"), Names{"scene/1"});
  EXPECT_EQ(incomplete(boxIn("arm"), "turn"), Names{});
}

/// It may be on the arm, which may touch it.
TEST(PathScene, ABodyWithoutAPlaceIsNotKnownToRestInAFixedFrameThatTheTrajectoryMoves) {
  for (const char* fixed_frame : {"arm", "base"}) {
    Parameters parameters = inFrame(fixed_frame);
    parameters.ignore_pairs = {"arm held/*", "other held/*"};
    MovingRobot arms(kTwoArms, parameters);
    arms.add("base", "arm", kStamp, at(0, 1));
    arms.add("base", "other", kStamp, at(0, 2));
    for (const char* ns : {"held", "post"}) {
      ObjectContent content = ns == std::string("held") ? boxIn("nowhere", kStamp) : boxIn("base");
      content.bounded.name = std::string(ns) + "/1";
      arms.scene().objects.put({ns, 1}, content, ros::Time(kStamp));
    }
    const Names incomplete = pathOf(arms.scene(), arms.model(), kStamp, {"turn"}).incomplete;
    const bool is_named = std::count(incomplete.begin(), incomplete.end(), "held/1") > 0;
    EXPECT_EQ(is_named, fixed_frame == std::string("arm"));
  }
}

/// Where it was placed in base, it stood while the arm turned.
TEST(PathScene, ABodyThatWasPlacedInAnotherFixedFrameIsNotKnownToBeOnALink) {
  for (const bool is_attached : {false, true}) {
    Parameters parameters = inFrame("base");
    if (is_attached) parameters.attached = {{"arm", {"scene/*"}}};
    MovingRobot arms(kTwoArms, parameters);
    const auto send = [&arms](double stamp, double turn) {
      arms.add("base", "arm", stamp, at(0, turn));
      arms.add("base", "other", stamp, at(0, 2));
      arms.scene().update(ros::Time(kStamp));
    };
    send(kStamp - 1, 1);
    arms.scene().objects.put(kKey, boxIn("arm", kStamp - 1), ros::Time(kStamp));
    send(kStamp, 1.5);
    parameters.fixed_frame = "arm";
    RobotLoader loader([](const MeshFile&) { return TriangleMesh(); });
    const auto model = std::make_shared<const Model>(makeModel(kTwoArms, parameters, loader, {}));
    arms.scene().adopt(model, ros::Time(kStamp));
    arms.scene().update(ros::Time(kStamp));
    EXPECT_EQ(pathOf(arms.scene(), model, kStamp, {"turn"}).incomplete, Names{"scene/1"})
        << is_attached;
  }
}

/// The base has driven on since its frame was sent.
TEST(PathScene, WhatTfTellsSeldomIsWhereItWasInTheFixedFrame) {
  Arm arm(inFrame("map"));
  arm.add("map", "table", kStamp, at(2));
  arm.put("held", boxIn("table"));
  for (int i = 0; i <= 50; ++i)
    arm.send(kStamp + 0.01 * i, {0, 0}, at(0.03 * i));
  const PathScene path = arm.path(kStamp + 0.5);
  EXPECT_EQ(path.incomplete, Names{});
  EXPECT_LT((placeOf(path, "held/1") - Eigen::Vector3d(0.5, 0, 0)).norm(), kTolerance);
}

/// All places of a body of one shape, each on its link.
std::vector<double> placesOf(const PathScene& path, const std::string& name) {
  std::vector<double> places;
  for (std::size_t i = 0; i < path.names.size(); ++i) {
    if (path.names[i] != name) continue;
    places.push_back(path.bodies[i].body.shapes.at(0).shape.link_from_shape.translation().x());
  }
  return places;
}

/// The base has driven on since its camera saw something, or since tf told of a mount: SAFE holds
/// for both. What is attached to the base, or static on a link of it, rides along.
TEST(PathScene, WhatMovesOnABaseThatDrivesIsWhereItWasAndOnTheBase) {
  for (const bool is_attached : {false, true}) {
    Parameters parameters = inFrame("map");
    if (is_attached) parameters.attached = {{"base", {"held/*"}}};
    Arm arm(parameters);
    arm.send(kStamp, {0, 0}, at(0));
    arm.add("base", "seen", kStamp, at(2));
    arm.put("held", boxIn("seen"));
    for (int i = 0; i <= 50; ++i)
      arm.send(kStamp + 0.01 * i, {0, 0}, at(0.03 * i));
    const PathScene path = arm.path(kStamp + 0.5);
    EXPECT_EQ(path.incomplete, Names{});
    const std::vector<double> places = placesOf(path, "held/1");
    ASSERT_EQ(places.size(), is_attached ? 1u : 2u);
    EXPECT_NEAR(places.front(), is_attached ? 2 : 0.5, kTolerance);
    EXPECT_NEAR(places.back(), 2, kTolerance);
    if (is_attached) continue;  // to the link beside the arm: no pair
    arm.put("held", brokenIn("seen"));
    EXPECT_EQ(arm.path(kStamp + 0.5).incomplete, Names{"held/1"}) << "once";
  }
}

/// Of a link that tf tells less often than the base, as static_transform_publisher of tf does.
TEST(PathScene, WhatIsMountedOnALinkThatRestsRidesAlong) {
  for (const char* const frame : {"head", "plate"}) {
    MovingRobot robot(kHead, inFrame("map"));
    ObjectContent mounted = boxIn(frame);
    mounted.bounded.name = "held/1";
    robot.scene().objects.put({"held", 1}, mounted, ros::Time(kStamp));
    robot.send(kStamp, {0, 0}, at(0));
    robot.add("head", "plate", kStamp, at(0.5), true);
    for (int i = 0; i <= 50; ++i) {
      robot.add("map", "base", kStamp + 0.01 * i, at(0.03 * i));
      robot.add("base", "arm", kStamp + 0.01 * i, at(0));
    }
    robot.scene().update(ros::Time(kStamp));
    const PathScene path = pathOf(robot.scene(), robot.model(), kStamp + 0.5, {"turn"});
    EXPECT_EQ(path.incomplete, Names{}) << frame;
    const Eigen::Vector3d expected(frame == std::string("plate") ? 0.5 : 0, 0, 0);
    EXPECT_LT((placeOf(path, "held/1") - expected).norm(), kTolerance) << frame;
  }
}

// A camera of few frames per second, which does not move as seen from the arm or from its wrist.
TEST(PathScene, WhatFollowsASlowFrameIsOnItsLinkAtOneTime) {
  for (const char* parent : {"arm", "wrist"}) {
    Arm arm(ignoring());
    arm.add(parent, "camera", kStamp, at(0));
    ObjectContent held = boxIn("camera");
    held.bounded.shapes.front().link_from_shape.translation().x() = 2;
    arm.put("held", held);
    for (int i = 0; i <= 50; ++i) {
      arm.add("arm", "wrist", kStamp + 0.01 * i, at(0, 0.02 * i));
      arm.send(kStamp + 0.01 * i, {0.01 * i, 0});
    }
    const PathScene path = arm.path(kStamp + 0.5);
    EXPECT_EQ(path.incomplete, Names{}) << parent;
    EXPECT_LT((placeOf(path, "held/1") - Eigen::Vector3d(2, 0, 0)).norm(), kTolerance) << parent;
  }
}

TEST(PathScene, AHeldBodyIsWhereItWasOnItsLink) {
  Arm arm(attaching());
  ObjectContent held = boxIn("map", kStamp);
  held.bounded.shapes.front().link_from_shape.translation().x() = 2;
  arm.put("held", held);
  arm.send(kStamp + 1, {1, 0});
  const PathScene path = arm.path(kStamp + 1);
  EXPECT_EQ(path.incomplete, Names{});
  EXPECT_LT((placeOf(path, "held/1") - Eigen::Vector3d(2, 0, 0)).norm(), kTolerance);
}

ObjectContent neighbourIn(const std::string& frame, std::int64_t stamp) {
  ObjectContent content = frame.empty() ? brokenIn(frame) : boxIn(frame);
  content.is_neighbour = true;
  content.stamp = stamp;
  return content;
}

TEST(PathScene, ANeighboursBoxIsHeldWhereItsStampHasIt) {
  Arm arm(attaching());
  arm.put("held", neighbourIn("map", static_cast<std::int64_t>(kStamp * 1e9)));
  EXPECT_EQ(arm.path().incomplete, Names{});
}

TEST(PathScene, ANeighboursBoxOnALinkMovesWithIt) {
  for (const bool is_attached : {false, true}) {
    Arm arm(is_attached ? attaching() : ignoring());
    ObjectContent held = neighbourIn("arm", static_cast<std::int64_t>(kStamp * 1e9));
    held.bounded.shapes.front().link_from_shape.translation().x() = 2;
    arm.put("held", held);
    arm.send(kStamp + 0.1, {1, 0});
    const PathScene path = arm.path(kStamp + 0.1);
    EXPECT_EQ(path.incomplete, Names{});
    const auto linkOf = [&path](const std::string& name) {
      const auto found = std::find(path.names.begin(), path.names.end(), name);
      return path.bodies.at(static_cast<std::size_t>(found - path.names.begin())).link;
    };
    EXPECT_EQ(linkOf("held/1"), linkOf("arm"));
    EXPECT_LT((placeOf(path, "held/1") - Eigen::Vector3d(2, 0, 0)).norm(), kTolerance);
  }
}

TEST(PathScene, ANeighboursNameWithoutABoxRests) {
  Arm arm(ignoring());
  for (const char* const frame : {"", "nowhere"}) {
    ObjectContent held = neighbourIn(frame, 0);
    held.bounded.missing = "it is incomplete at its node";
    held.bounded.shapes.clear();
    arm.put("held", held);
    EXPECT_EQ(arm.path().incomplete, Names{}) << frame << ": the arm may touch it";
  }
}

/// As that of a gripper whose node has ended.
TEST(PathScene, ANeighboursNameWithoutABoxMovesWithTheLinkAboveItsFrame) {
  Arm arm(ignoring());
  ObjectContent held = neighbourIn("arm", static_cast<std::int64_t>(kStamp * 1e9));
  held.bounded.missing = "it is incomplete at its node";
  held.bounded.shapes.clear();
  arm.put("held", held);
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"});
}

TEST(PathScene, AfterAJumpBackTheStampOfAHeldBodyIsOfNoUse) {
  for (const double jump : {kStamp / 2, 0.0}) {
    Arm arm(attaching());
    arm.put("held", boxIn("map", kStamp));
    arm.tf().clear();
    arm.scene().restart(ros::Time(jump));
    arm.send(kStamp / 2, {1, 0});
    EXPECT_EQ(arm.path(kStamp / 2).incomplete, Names{"held/1"}) << jump;
  }
}

// Who repeats it may know nothing of the jump.
TEST(PathScene, AfterAJumpBackAHeldBodyNeedsANewStamp) {
  Arm arm(attaching());
  arm.put("held", boxIn("map", kStamp));
  arm.tf().clear();
  arm.scene().restart(ros::Time(kStamp / 2));
  arm.send(kStamp, {1, 0});
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"});
  arm.put("held", boxIn("map", kStamp));
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"}) << "it may be of the old time";
  ObjectContent larger = boxIn("map", kStamp);
  larger.bounded.shapes[0].size *= 2;
  arm.put("held", larger);
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"}) << "its stamp still is";
  arm.send(kStamp + 0.1, {1, 0});
  arm.put("held", boxIn("map", kStamp + 0.1));
  EXPECT_EQ(arm.path(kStamp + 0.1).incomplete, Names{});
}

// The node noticed the jump a little after the clock had made it. A late transform of the new time
// has the stamp of the old one.
TEST(PathScene, AfterAJumpBackAStampThatTheNewTimeHasTooIsOfNoUse) {
  Arm arm(attaching());
  const ObjectContent held = boxIn("map", kStamp);
  arm.put("held", held);
  EXPECT_EQ(arm.path().incomplete, Names{});
  arm.scene().update(ros::Time(kStamp + 0.3));
  arm.tf().clear();
  arm.scene().restart(ros::Time(kStamp + 0.05));
  arm.send(kStamp - 0.01, {1, 0});
  arm.send(kStamp + 0.1, {1, 0});
  EXPECT_EQ(arm.path(kStamp + 0.1).incomplete, Names{"held/1"});
  arm.put("held", held);
  EXPECT_EQ(arm.path(kStamp + 0.1).incomplete, Names{"held/1"}) << "it may be of the old time";
  ObjectContent larger = held;
  larger.bounded.shapes[0].size *= 2;
  arm.put("held", larger);
  EXPECT_EQ(arm.path(kStamp + 0.1).incomplete, Names{"held/1"}) << "its stamp still is";
  arm.scene().objects.remove({"held", 1});
  arm.put("held", held);
  EXPECT_EQ(arm.path(kStamp + 0.1).incomplete, Names{"held/1"}) << "as it is of a new one";
}

TEST(PathScene, AHeldBodyStaysOnItsLinkWhenTheClockStarts) {
  Arm arm(attaching());
  arm.put("held", boxIn("map", kStamp));
  arm.scene().startClock(ros::Time(kStamp + 0.05));
  EXPECT_EQ(arm.path().incomplete, Names{});
}

TEST(PathScene, AHeldBodyWithAStampAheadOfTheStartOfTheClockIsSentAgain) {
  Arm arm(attaching());
  arm.put("held", boxIn("map", kStamp));
  arm.scene().startClock(ros::Time(kStamp - 0.05));
  EXPECT_EQ(arm.path().incomplete, Names{"held/1"});
  arm.put("held", boxIn("map", kStamp));
  EXPECT_EQ(arm.path().incomplete, Names{});
}

// The base drives on. The object is carried over by where the base is now, but was placed before.
TEST(PathScene, InAnotherFixedFrameTheStampOfAHeldBodyIsOfNoUse) {
  Parameters parameters = attaching();
  parameters.fixed_frame = "base";
  Arm arm(parameters);
  arm.put("held", boxIn("base", kStamp));
  arm.send(kStamp + 1, {0, 0}, at(5));
  Arm other(attaching());
  arm.scene().adopt(other.model(), ros::Time(kStamp + 1));
  EXPECT_EQ(arm.path(kStamp + 1, other.model()).incomplete, Names{"held/1"});
}

TEST(PathScene, APlanarJointOfTheTrajectoryMustFitItsTransform) {
  const auto check = [](const Eigen::Isometry3d& moved) {
    MovingRobot cart(kCart, inFrame("floor"));
    cart.add("floor", "cart", kStamp, cart.robot().joints.at(0).parent_from_joint * moved);
    pathOf(cart.scene(), cart.model(), kStamp, {"drive.x", "drive.y", "drive.yaw"});
  };
  Eigen::Isometry3d moved = at(2, 3);
  moved.translation().y() = -7;
  EXPECT_NO_THROW(check(moved));
  moved.translation().z() = 2e-3;
  EXPECT_THROW(check(moved), std::runtime_error);
  moved.translation().z() = 0;
  EXPECT_THROW(check(moved * Eigen::AngleAxisd(2e-3, Eigen::Vector3d::UnitX())),
               std::runtime_error);
}

double flangeOf(const PathScene& path) {
  const auto& joints = path.robot.joints;
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [](const Joint& joint) { return joint.name == "flange"; });
  return found->parent_from_joint.translation().x();
}

TEST(PathScene, AFixedJointIsWhereTfHasItWhateverIsAboveIt) {
  QuietArm arm(ignoring());
  EXPECT_EQ(flangeOf(arm.path()), 1) << "as the URDF has it";
  const auto moved = edge("arm", "tool", kStamp, Eigen::Quaterniond::Identity(), {2, 0, 0});
  arm.tf().add({moved}, true, ros::Time(kStamp));
  EXPECT_EQ(flangeOf(arm.path()), 2) << "tf does not know where the arm is";
  arm.add("map", "base", kStamp, at(0));
  arm.add("base", "arm", kStamp, at(0));
  EXPECT_EQ(flangeOf(arm.path(kStamp + 100)), 2) << "the arm is stale";
}

}  // namespace
}  // namespace link_bounds
