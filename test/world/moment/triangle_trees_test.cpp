// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Trees are requested once, when they are needed, and die with their points.
#include "world/moment/triangle_trees.h"

#include <gtest/gtest.h>

#include "testing/distance_bodies.h"

namespace link_bounds {
namespace {

using std::chrono::milliseconds;

class TriangleTreesTest : public testing::Test {
 protected:
  std::shared_ptr<const PointSet> points() const {
    return std::make_shared<const PointSet>(mesh_.vertices);
  }

  std::shared_ptr<const ObjectContent> list() const {
    auto content = std::make_shared<ObjectContent>();
    content->bounded.shapes = {{points()}};
    return content;
  }

  const TriangleMesh mesh_ = boxMesh({1, 1, 1});
  const TriangleTrees::Tree tree_ = triangleTree(mesh_);
  TriangleTrees::Time now_{};
  std::vector<std::string> meshes_;
  std::size_t lists_ = 0;
  bool is_memory_short_ = false;  // for the next request
  TriangleTrees trees_{{[this](const std::string& uri, const auto&) {
                          if (std::exchange(is_memory_short_, false)) throw std::bad_alloc();
                          meshes_.push_back(uri);
                        },
                        [this](const auto&) {
                          if (std::exchange(is_memory_short_, false)) throw std::bad_alloc();
                          ++lists_;
                        }}};
};

TEST_F(TriangleTreesTest, aMeshIsRequestedOnce) {
  const auto mesh = points();
  EXPECT_EQ(trees_.ofMesh("a", mesh), nullptr);
  EXPECT_EQ(trees_.ofMesh("a", mesh), nullptr);
  EXPECT_EQ(meshes_, std::vector<std::string>{"a"});
  const std::uint64_t version = trees_.version();
  trees_.add({mesh, tree_, ""});
  EXPECT_NE(trees_.version(), version);
  EXPECT_EQ(trees_.ofMesh("a", mesh), tree_);
}

TEST_F(TriangleTreesTest, aRequestThatFailedIsMadeAgain) {
  const auto mesh = points();
  is_memory_short_ = true;
  EXPECT_THROW(trees_.ofMesh("a", mesh), std::bad_alloc);
  trees_.ofMesh("a", mesh);
  EXPECT_EQ(meshes_.size(), 1U);
  const auto content = list();
  trees_.ofList(content, now_);
  is_memory_short_ = true;
  EXPECT_THROW(trees_.requestSettled(now_ + milliseconds(500)), std::bad_alloc);
  trees_.requestSettled(now_ + milliseconds(500));
  EXPECT_EQ(lists_, 1U);
}

TEST_F(TriangleTreesTest, aTreeOfOtherPointsIsNotTaken) {
  const auto mesh = points();
  const auto other = points();
  trees_.ofMesh("a", mesh);
  trees_.add({other, tree_, ""});
  trees_.add({std::weak_ptr<const PointSet>(), tree_, ""});
  EXPECT_EQ(trees_.ofMesh("a", mesh), nullptr);
}

TEST_F(TriangleTreesTest, anEntryDiesWithItsPoints) {
  auto mesh = points();
  trees_.ofMesh("a", mesh);
  trees_.add({mesh, tree_, ""});
  const long others = tree_.use_count();
  mesh.reset();
  trees_.forgetUnused();
  EXPECT_EQ(tree_.use_count(), others - 1);
}

TEST_F(TriangleTreesTest, anErrorIsKeptUntilItIsForgotten) {
  const auto mesh = points();
  trees_.ofMesh("a", mesh);
  trees_.add({mesh, nullptr, "too large"});
  trees_.ofMesh("a", mesh);
  EXPECT_EQ(meshes_.size(), 1U);
  EXPECT_EQ(trees_.errors(), std::vector<std::string>{"too large"});
  trees_.forgetErrors();
  trees_.ofMesh("a", mesh);
  EXPECT_EQ(meshes_.size(), 2U);
  EXPECT_TRUE(trees_.errors().empty());
}

TEST_F(TriangleTreesTest, aListIsRequestedWhenItHasNotChangedForAWhile) {
  const auto content = list();
  EXPECT_EQ(trees_.ofList(content, now_), nullptr);
  trees_.requestSettled(now_ + milliseconds(499));
  EXPECT_EQ(lists_, 0U);
  trees_.ofList(content, now_ + milliseconds(499));
  trees_.requestSettled(now_ + milliseconds(500));
  trees_.requestSettled(now_ + milliseconds(1500));
  EXPECT_EQ(lists_, 1U);
  trees_.add({content->bounded.shapes.front().points, tree_, ""});
  EXPECT_EQ(trees_.ofList(content, now_), tree_);
}

TEST_F(TriangleTreesTest, aListThatDeformsAllTheTimeIsNeverRequested) {
  for (int i = 0; i < 200; ++i, now_ += milliseconds(100)) {
    trees_.ofList(list(), now_);
    trees_.requestSettled(now_);
    trees_.forgetUnused();
  }
  EXPECT_EQ(lists_, 0U);
}

}  // namespace
}  // namespace link_bounds
