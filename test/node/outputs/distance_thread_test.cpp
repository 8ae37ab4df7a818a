// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the thread publishes, when it computes again, and when it forgets.
#include "node/outputs/distance_thread.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "testing/distance_bodies.h"
#include "testing/live_boxes_testing.h"
#include "testing/patience.h"

namespace link_bounds {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Two boxes of triangles whose hulls and triangles are `gap` apart, in a model of their own.
MomentPtr madeMoment(double gap) {
  std::vector<BoundedLink> links;
  for (const char* name : {"a", "b"}) {
    Shape shape;
    shape.points = std::make_shared<const PointSet>(boxMesh({1, 1, 1}).vertices);
    links.push_back({name, {shape}, 0, ""});
  }
  auto model = std::make_shared<Model>(*modelOf("map", links));
  model->parameters.distance_limit = 10;
  model->parameters.adjacent_joints = 0;
  for (const BoundedLink& link : links)
    model->mesh_uris[link.name] = link.shapes.front().points;
  auto moment = std::make_shared<Moment>();
  moment->model = model;
  for (std::size_t i = 0; i < 2; ++i) {
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    pose.translation().x() = static_cast<double>(i) * (1 + gap);
    moment->bodies.push_back({i, nullptr, 0, linkBox(links[i], pose).value(), pose});
  }
  return moment;
}

class DistanceThreadTest : public testing::Test {
 protected:
  /// Waits until something published satisfies the condition.
  template <class Condition>
  bool wait(const Condition& condition) {
    std::unique_lock<std::mutex> lock(mutex_);
    return published_.wait_for(
        lock, deadline(), [&] { return std::any_of(results_.begin(), results_.end(), condition); });
  }

  bool waitForGap(double gap) {
    return wait([gap](const ComputedDistances& computed) {
      return std::abs(computed.nearest.distance - gap) < 1e-3;
    });
  }

  /// Throws once when it is copied, as where memory is short.
  struct Copied {
    explicit Copied(std::atomic<bool>& fails) : fails_(fails) {}
    Copied(const Copied& other) : fails_(other.fails_) {
      if (fails_.exchange(false)) throw std::bad_alloc();
    }
    std::atomic<bool>& fails_;
  };

  TreeRequests requests() {
    return {[this, copied = Copied(cannot_copy_)](const std::string&, const auto& points) {
              ++requested_;
              if (fails_.exchange(false)) throw std::bad_alloc();
              if (has_trees_) {
                thread_->give({points, triangleTree(boxMesh({1, 1, 1})), ""});
              } else {
                thread_->give({points, nullptr, "why"});
              }
            },
            [](const auto&) {}};
  }

  void start(milliseconds keep) {
    thread_ = std::make_unique<DistanceThread>(
        requests(), pairs_,
        DistanceThread::Callbacks{[this](const ComputedDistances& computed) {
                                    if (cannot_publish_.exchange(false)) throw std::bad_alloc();
                                    const std::lock_guard<std::mutex> lock(mutex_);
                                    results_.push_back(computed);
                                    published_.notify_all();
                                  },
                                  [] {}, [this] { return is_wanted_.load(); }},
        keep);
  }

  MomentPairs pairs_;
  std::mutex mutex_;
  std::condition_variable published_;
  std::vector<ComputedDistances> results_;  ///< guarded by mutex_
  std::atomic<bool> is_wanted_{true};
  std::atomic<bool> fails_{false};
  std::atomic<bool> cannot_publish_{false};  ///< once
  std::atomic<bool> cannot_copy_{false};     ///< once
  std::atomic<bool> has_trees_{true};
  std::atomic<int> requested_{0};
  std::unique_ptr<DistanceThread> thread_;  ///< last: it ends first
};

TEST_F(DistanceThreadTest, ComputesEachNewMomentAndTree) {
  start(seconds(10));
  thread_->give(madeMoment(0.5));
  ASSERT_TRUE(waitForGap(0.5));
  thread_->give(madeMoment(0.25));
  ASSERT_TRUE(waitForGap(0.25));
  EXPECT_EQ(requested_, 4);
  EXPECT_GE(thread_->takeTimes().count, 2U);
}

TEST_F(DistanceThreadTest, IsBehindWhileAMomentWaits) {
  start(seconds(10));
  EXPECT_EQ(thread_->behind(), 0);
  {
    const std::lock_guard<std::mutex> lock(mutex_);  // nothing can be published
    thread_->give(madeMoment(0.5));
    EXPECT_TRUE(becomesTrue([this] { return thread_->behind() > 0.2; }));
    thread_->give(madeMoment(0.25));
    EXPECT_GT(thread_->behind(), 0.2) << "since the first one";
  }
  ASSERT_TRUE(waitForGap(0.25));
  EXPECT_TRUE(becomesTrue([this] { return thread_->behind() == 0; }));
}

TEST_F(DistanceThreadTest, AFailureLeavesNothingBehind) {
  start(seconds(10));
  const auto moment = madeMoment(0.5);
  fails_ = true;
  thread_->give(moment);
  ASSERT_TRUE(becomesTrue([this] { return !fails_; }));
  thread_->give(moment);
  ASSERT_TRUE(waitForGap(0.5));
  EXPECT_EQ(requested_, 3) << "the request that failed is repeated";
}

/// A scene that rests gives no other one.
TEST_F(DistanceThreadTest, AMomentWhoseComputationFailedIsComputedAgain) {
  start(seconds(10));
  fails_ = true;
  thread_->give(madeMoment(0.5));
  ASSERT_TRUE(waitForGap(0.5));
  EXPECT_FALSE(fails_);
}

TEST_F(DistanceThreadTest, AFailureLeavesNothingBehindWhereForgettingFailsToo) {
  start(seconds(10));
  const auto moment = madeMoment(0.5);
  cannot_copy_ = fails_ = true;
  thread_->give(moment);
  ASSERT_TRUE(becomesTrue([this] { return !fails_ && !cannot_copy_; }));
  thread_->give(moment);
  ASSERT_TRUE(waitForGap(0.5));
  EXPECT_EQ(requested_, 3) << "the request that failed is repeated";
}

TEST_F(DistanceThreadTest, AMomentWhoseComputationFailedDoesNotWait) {
  start(seconds(10));
  cannot_publish_ = true;
  thread_->give(madeMoment(0.5));
  ASSERT_TRUE(becomesTrue([this] { return !cannot_publish_; }));
  EXPECT_TRUE(becomesTrue([this] { return thread_->behind() == 0; }));
}

TEST_F(DistanceThreadTest, ForgetsWhyThereAreNoTrianglesWhenNobodyWantsThem) {
  start(milliseconds(100));
  has_trees_ = false;
  thread_->give(madeMoment(0.5));
  ASSERT_TRUE(becomesTrue([this] { return !thread_->errors().empty(); }));
  is_wanted_ = false;
  EXPECT_TRUE(becomesTrue([this] { return thread_->errors().empty(); }));
}

TEST_F(DistanceThreadTest, ForgetsEverythingWhenNobodyWantsIt) {
  start(milliseconds(100));
  auto moment = madeMoment(0.5);
  const std::weak_ptr<const Model> model = moment->model;
  const std::weak_ptr<const PointSet> points = model.lock()->links[0].shapes[0].points;
  thread_->give(std::move(moment));
  ASSERT_TRUE(waitForGap(0.5));
  EXPECT_FALSE(points.expired());
  is_wanted_ = false;
  EXPECT_TRUE(becomesTrue([&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    results_.clear();  // they hold the moment
    return model.expired() && points.expired();
  }));
}

TEST_F(DistanceThreadTest, IgnoresWhatIsGivenAfterTheEnd) {
  start(seconds(10));
  thread_->stop();
  thread_->give(madeMoment(0.5));
  thread_->give(MadeTree());
  thread_->stop();
  EXPECT_TRUE(results_.empty());
}

}  // namespace
}  // namespace link_bounds
