// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What one piece of a copy costs the thread of the scene, whatever a stranger asks for.
#include "world/history/scene_copy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testing/live_boxes_testing.h"
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

}  // namespace
}  // namespace link_bounds
