// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What one piece of a copy costs the thread of the scene, whatever a stranger asks for; what
// happens between two pieces; objects that are refused.
#include "world/history/scene_copy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testing/live_objects_testing.h"
#include "testing/replaced_new.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr int kStrangers = repetitions(1000000);
constexpr std::size_t kMaxBytes = 4096;  // in one request for memory
constexpr long kMaxAllocations = 50;     // a name is copied by at most 3
constexpr std::chrono::nanoseconds kStep(0);
const ros::Time kNow(1);

/// The names of a request, none of which is known. Half of them may be objects.
std::vector<std::string> strangers() {
  std::vector<std::string> names;
  for (int i = 0; i < kStrangers; ++i)
    names.push_back((i % 2 ? "a name of a stranger, which is not short/" : "no link ") +
                    std::to_string(i));
  return names;
}

TEST(SceneCopy, APieceIsSmallForAMillionUnknownNames) {
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("map", {meshLink("base", 1)}), kNow);
  BoxRequest request;
  request.names = strangers();
  SceneCopy copy(request, scene.links.sharedModel());
  int pieces = 0;
  long most = 0;
  for (bool is_complete = false; !is_complete; ++pieces) {
    long count = 0;
    replaced_new::limit = kMaxBytes;
    replaced_new::counter = &count;
    try {
      is_complete = copy.proceed(scene, kNow, kStep);
    } catch (const std::bad_alloc&) {
      is_complete = true;
      ADD_FAILURE() << "piece " << pieces << " moves more than " << kMaxBytes << " bytes";
    }
    replaced_new::counter = nullptr;
    replaced_new::limit = replaced_new::kNoLimit;
    most = std::max(most, count);
  }
  EXPECT_LE(most, kMaxAllocations);
  EXPECT_GT(pieces, kStrangers / 2 / 10);
  EXPECT_EQ(copy.take()->unknown_names.size(), request.names.size());
}

/// Pieces, until the copy is complete.
std::unique_ptr<PastScene> finish(SceneCopy& copy, const Scene& scene, ros::Time now) {
  while (!copy.proceed(scene, now, kStep)) {
  }
  return copy.take();
}

TEST(SceneCopy, AnObjectWhoseNameIsTakenHasNoPlace) {
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("map", {}), kNow);
  ObjectContent content = boxIn("map");
  content.refused_name = "taken";
  scene.objects.put(kKey, content, kNow);
  SceneCopy copy({}, scene.links.sharedModel());
  const PastBody body = finish(copy, scene, kNow)->bodies.at(0);
  EXPECT_TRUE(body.incomplete);
  EXPECT_EQ(body.reason, "taken");
  EXPECT_FALSE(body.frame);
}

// The arm is five samples ahead of the base. Where both are stale, the copy has only two of them.
TEST(SceneCopy, AfterAJumpBackNothingIsAsOldAsBefore) {
  constexpr double kBefore = 100;
  constexpr double kAfter = 5;
  TransformBuffer tf;
  Scene scene(tf);
  const auto hear = [&](const char* parent, const char* child, double stamp, double now) {
    const auto transform = edge(parent, child, stamp, Eigen::Quaterniond::Identity(), {1, 0, 0});
    tf.add({transform}, false, ros::Time(now));
    scene.update(ros::Time(now));
  };
  const auto base = modelOf("map", {meshLink("base", 1), meshLink("arm", 2)});
  auto model = std::make_shared<Model>(*base);
  model->parameters.timeout = 2;
  scene.adopt(model, ros::Time(kBefore));
  hear("map", "base", kBefore, kBefore);
  hear("base", "arm", kBefore, kBefore);
  SceneCopy copy({}, model);
  EXPECT_FALSE(copy.proceed(scene, ros::Time(kBefore), kStep));
  tf.clear();
  scene.restart(ros::Time(kAfter));
  hear("map", "base", kAfter, kAfter);
  for (int i = 0; i <= 5; ++i)
    hear("base", "arm", kAfter + 0.1 * i, kAfter);
  const auto past = finish(copy, scene, ros::Time(kAfter));
  EXPECT_EQ(past->now, ros::Time(kAfter));
  FrameTracker tracker(past->excerpt.buffer());
  tracker.setTarget(past->target, 2, past->now);
  EXPECT_EQ(tracker.keep(*past->bodies.at(1).frame).problem, TransformProblem::kNone);
}

}  // namespace
}  // namespace link_bounds
