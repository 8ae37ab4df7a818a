// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names of links in tf, and the members of groups.
#include "world/model/model.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

constexpr char kUrdf[] = R"(<robot name="r">
  <link name="base"><visual><geometry><box size="1 2 3"/></geometry></visual></link>
  <link name="bare"/>
  <link name="arm"><visual><geometry><sphere radius="1"/></geometry></visual></link>
  <joint name="j1" type="fixed"><parent link="base"/><child link="bare"/></joint>
  <joint name="j2" type="fixed"><parent link="bare"/><child link="arm"/></joint>
</robot>)";

/// Link "bare" has collision geometry.
std::string urdfWithCollision() {
  std::string urdf = kUrdf;
  const std::string bare = "<link name=\"bare\"/>";
  return urdf.replace(urdf.find(bare), bare.size(),
                      "<link name=\"bare\"><collision><geometry><sphere radius=\"1\"/></geometry>"
                      "</collision></link>");
}

Model modelWith(const Parameters& parameters, const std::string& urdf = kUrdf) {
  RobotLoader loader([](const MeshFile&) -> TriangleMesh { throw MeshError("not asked for"); });
  return makeModel(urdf, parameters, loader, meshSource(parameters));
}

TEST(TfName, JoinsWithOneSlash) {
  EXPECT_EQ(tfName("", "base"), "base");
  EXPECT_EQ(tfName("left", "base"), "left/base");
  EXPECT_EQ(tfName("/left//", "base"), "left/base");
  EXPECT_EQ(tfName("/", "base"), "base");
}

TEST(TfName, ALeadingSlashOnlyGoes) {
  EXPECT_EQ(tfName("left", "/base"), "base");
  EXPECT_EQ(tfName("", "/base"), "base");
}

TEST(Model, FixedFrameIsThePrefixedRootUnlessGiven) {
  Parameters parameters;
  parameters.tf_prefix = "left";
  EXPECT_EQ(modelWith(parameters).fixed_frame, "left/base");
  parameters.fixed_frame = "map";
  EXPECT_EQ(modelWith(parameters).fixed_frame, "map");
}

TEST(Model, TellsWhatHasGeometryOfTheOtherKindOnly) {
  const std::string urdf = urdfWithCollision();
  Parameters parameters;
  EXPECT_EQ(modelWith(parameters).left_out, "");
  EXPECT_EQ(modelWith(parameters, urdf).left_out,
            "left out are links with collision geometry only: \"bare\"");
  parameters.ignore_links = {"bare"};
  EXPECT_EQ(modelWith(parameters, urdf).left_out, "") << "it is not asked for";
  parameters.ignore_links = {};
  parameters.geometry = "collision";
  EXPECT_EQ(modelWith(parameters, urdf).left_out,
            "left out are links with visual geometry only: \"base\", \"arm\"");
  parameters.geometry = "both";
  EXPECT_EQ(modelWith(parameters, urdf).left_out, "");
}

TEST(Model, GroupsFollowTheRobotInAlphabeticalOrder) {
  Parameters parameters;
  parameters.groups = {{"tool", {"arm", "bare"}}, {"all", {"base", "arm"}}};
  const Model model = modelWith(parameters);
  ASSERT_EQ(model.groups.size(), 3u);
  EXPECT_EQ(model.groups[0].name, "robot");
  EXPECT_EQ(model.groups[0].members, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(model.groups[1].name, "all");
  EXPECT_EQ(model.groups[2].members, std::vector<std::size_t>{1});
  EXPECT_FALSE(model.groups[2].lacks_members) << "a link without geometry is not missing";
}

/// Its box does not hold a link that was named.
TEST(Model, AMemberWithGeometryOfTheOtherKindIsWarnedOf) {
  const std::string urdf = urdfWithCollision();
  Parameters parameters;
  parameters.groups = {{"tool", {"arm", "bare"}}, {"whole", {"arm", "base"}}};
  EXPECT_TRUE(modelWith(parameters).warnings.empty()) << "it has no geometry at all";
  const Model model = modelWith(parameters, urdf);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(model.warnings[0].find("box \"tool\" of ~groups does not cover \"bare\","), 0u)
      << model.warnings[0];
  parameters.geometry = "both";
  EXPECT_TRUE(modelWith(parameters, urdf).warnings.empty());
  parameters.groups["none"];
  ASSERT_EQ(modelWith(parameters, urdf).warnings.size(), 1u);
  EXPECT_EQ(modelWith(parameters, urdf).warnings[0].find("box \"none\" of ~groups has no members"),
            0u);
}

TEST(Model, ASpanThatTfDoesNotRememberIsWarnedOf) {
  Parameters parameters;
  for (const double span : {0.0, 9.9, 10.0, 1e5}) {
    parameters.swept_span = span;
    EXPECT_EQ(modelWith(parameters).warnings.size(), span < 10 ? 0u : 1u) << span;
  }
}

TEST(Model, LinksThatAreNamedLikeObjectsAreWarnedOf) {
  std::string urdf = kUrdf;
  for (std::size_t at = urdf.find("\"arm\""); at != std::string::npos; at = urdf.find("\"arm\""))
    urdf.replace(at, 5, "\"scene/1\"");
  const Model model = modelWith({}, urdf);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("NS/ID: \"scene/1\""), std::string::npos) << model.warnings[0];
}

TEST(Model, UnknownMembersMakeAGroupIncomplete) {
  Parameters parameters;
  parameters.groups = {{"a", {"base", "typo"}}, {"b", {"base", "scene/*"}}, {"c", {"scene/1"}}};
  const Model model = modelWith(parameters);
  EXPECT_TRUE(model.groups[1].lacks_members);
  EXPECT_FALSE(model.groups[2].lacks_members) << "a pattern that matches nothing is not missing";
  EXPECT_FALSE(model.groups[3].lacks_members) << "an object may still appear";
}

TEST(Model, EachUnknownLinkIsWarnedAboutOnce) {
  Parameters parameters;
  parameters.ignore_links = {"typo"};
  parameters.link_padding = {{"typo", 0.1}, {"other", 0.1}};
  const Model model = modelWith(parameters);
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_NE(model.warnings[0].find("\"other\""), std::string::npos);
  EXPECT_NE(model.warnings[1].find("\"typo\""), std::string::npos);
}

/// Other nodes take their boxes for those of a neighbour of this one.
TEST(Model, LinksWithTheNameOfANeighboursBoxAreWarnedAbout) {
  std::string urdf = kUrdf;
  for (std::size_t at = urdf.find("\"arm\""); at != std::string::npos; at = urdf.find("\"arm\""))
    urdf.replace(at, 5, "\"/left/arm\"");
  const Model model = modelWith({}, urdf);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find(": \"/left/arm\"; give these links other names"),
            std::string::npos)
      << model.warnings[0];
}

TEST(Model, BodiesAreThoseOfTheBoundedLinks) {
  const Model model = modelWith({});
  ASSERT_EQ(model.bodies.of_links.size(), 2u);
  EXPECT_TRUE(areJoined(model.bodies, 0, 1)) << "by fixed joints across a link without geometry";
}

TEST(Model, IgnoredPairsAreWarnedAboutOnlyWhereALinkIsUnknown) {
  Parameters parameters;
  parameters.ignore_pairs = {"arm base", "bare typo", "arm scene/1", "a* held/*", "b* no_such*"};
  const Model model = modelWith(parameters);
  EXPECT_TRUE(model.ignored_pairs.contains("base", "arm"));
  EXPECT_TRUE(model.ignored_pairs.contains("scene/1", "arm"));
  EXPECT_FALSE(model.ignored_pairs.contains("base", "scene/1"));
  EXPECT_TRUE(model.ignored_pairs.contains("held/7", "arm"));
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_NE(model.warnings[0].find("\"no_such*\""), std::string::npos) << model.warnings[0];
  EXPECT_NE(model.warnings[1].find("\"typo\""), std::string::npos) << model.warnings[1];
}

TEST(Model, AttachedObjectsArePartOfTheBodyOfALink) {
  Parameters parameters;
  parameters.attached = {{"bare", {"held/7", "tray/*"}}, {"typo", {"held/7"}}};
  const Model model = modelWith(parameters);
  const auto bodyOfObject = [&](const std::string& name) { return bodyOf(model, {&name, {}}); };
  EXPECT_EQ(bodyOfObject("held/7"), bodyOf(model, {&model.links[0].name, 0}))
      << "a link without geometry has a body";
  EXPECT_TRUE(bodyOfObject("tray/3"));
  EXPECT_FALSE(bodyOfObject("held/8"));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("~attached names link \"typo\""), std::string::npos);
}

TEST(Model, MoreThanTwoWordsMustBeNames) {
  Parameters parameters;
  parameters.ignore_pairs = {"arm the scene/1"};
  EXPECT_TRUE(modelWith(parameters).ignored_pairs.contains("arm", "the scene/1"));
  parameters.ignore_pairs = {"arm bare base"};
  EXPECT_THROW(modelWith(parameters), ParameterError);
}

}  // namespace
}  // namespace link_bounds
