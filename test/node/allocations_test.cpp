// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From parsed transforms to filled messages, our code takes no memory from the heap.
#include <dlfcn.h>
#include <execinfo.h>
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>

#include "box_message.h"
#include "live_boxes_testing.h"
#include "overlap_message.h"
#include "part_boxes.h"

namespace link_bounds {
namespace {

constexpr int kLinks = 50;
constexpr int kPeriod = 50;  // of updates, in which the chain swings to and fro
constexpr int kWarmUp = 200;
constexpr int kUpdates = 1000;

/// Who asked for memory, by the first library on the stack that is not the language's own. The
/// message code of roscpp is in headers, so the test says when it runs.
struct Counts {
  long ours = 0;
  long tf2 = 0;
  long roscpp = 0;
};

Counts counts;
bool is_counting = false;
bool is_roscpp = false;

bool isTf2(void* const* frames, int count) {
  for (int i = 2; i < count; ++i) {
    Dl_info info;
    if (!dladdr(frames[i], &info) || std::strstr(info.dli_fname, "libstdc++")) continue;
    return std::strstr(info.dli_fname, "libtf2");
  }
  return false;
}

void count() {
  if (!is_counting) return;
  is_counting = false;
  if (is_roscpp) {
    ++counts.roscpp;
  } else {
    void* frames[8];
    ++(isTf2(frames, backtrace(frames, 8)) ? counts.tf2 : counts.ours);
  }
  is_counting = true;
}

}  // namespace
}  // namespace link_bounds

// Not inlined, or GCC takes new and delete for a mismatched pair.
__attribute__((noinline)) void* operator new(std::size_t size) {
  link_bounds::count();
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

__attribute__((noinline)) void operator delete(void* memory) noexcept {
  std::free(memory);
}

__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace link_bounds {
namespace {

/// A chain of links with long names, each turned a little differently at each update.
class Chain {
 public:
  Chain() {
    std::vector<BoundedLink> links;
    for (int i = 0; i < kLinks; ++i)
      links.push_back(meshLink(name(i), static_cast<std::uint64_t>(i)));
    auto model = std::make_shared<Model>(*modelOf("the_frame_that_is_fixed", links));
    model->parameters.parts_per_link = 2;
    for (const BoundedLink& link : links)
      model->parts.push_back({link, link});
    scene_.links.adopt(model, tf_, ros::Time(1));
    parts_.adopt(*model);
  }

  /// What arrives from the network.
  ros::SerializedMessage message(int update) const {
    tf2_msgs::TFMessage message;
    const double angle = 0.5 + 0.5 * std::sin(2 * M_PI * update / kPeriod);
    for (int i = 0; i < kLinks; ++i) {
      const std::string parent = i == 0 ? "the_frame_that_is_fixed" : name(i - 1);
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
      message.transforms.push_back(edge(parent, name(i), 1 + 0.01 * update, turn, {0.1, 0.2, 0.3}));
    }
    return ros::serialization::serializeMessage(message);
  }

  void update(const ros::SerializedMessage& received, int update) {
    ros::serialization::deserializeMessage(received, message_);
    const ros::Time now(1 + 0.01 * update);
    tf_.add(message_.transforms, false, now);
    ASSERT_TRUE(scene_.links.update(tf_, now));
    fillBoxes(scene_, boxes_);
    fillGroups(scene_, groups_);
    parts_.fill(scene_.links, parts_message_);
    scene_overlaps_.fill(scene_, overlaps_);
    is_roscpp = true;
    ros::serialization::serializeMessage(boxes_);
    ros::serialization::serializeMessage(groups_);
    ros::serialization::serializeMessage(parts_message_);
    ros::serialization::serializeMessage(overlaps_);
    is_roscpp = false;
  }

  std::size_t boxCount() const { return boxes_.boxes.size(); }
  std::size_t partCount() const { return parts_message_.boxes.size(); }
  std::size_t overlapCount() const { return overlaps_.overlaps.size(); }

 private:
  static std::string name(int i) { return "a_link_whose_name_is_long_" + std::to_string(i); }

  TfMessage message_;
  TransformSource tf_;
  Scene scene_;
  AxisAlignedBoxArray boxes_;
  AxisAlignedBoxArray groups_;
  PartBoxes parts_;
  AxisAlignedBoxArray parts_message_;
  SceneOverlaps scene_overlaps_;
  BoxOverlapArray overlaps_;
};

TEST(Allocations, NoneOfOursInAThousandUpdates) {
  Chain chain;
  for (int i = 0; i < kWarmUp + kUpdates; ++i) {
    const ros::SerializedMessage received = chain.message(i);
    is_counting = i >= kWarmUp;
    chain.update(received, i);
    is_counting = false;
  }
  EXPECT_EQ(chain.boxCount(), static_cast<std::size_t>(kLinks));
  EXPECT_EQ(chain.partCount(), static_cast<std::size_t>(2 * kLinks));
  EXPECT_GT(chain.overlapCount(), 0u);
  EXPECT_EQ(counts.ours, 0);
  EXPECT_GT(counts.tf2, 0);
  EXPECT_GT(counts.roscpp, 0);
  std::cout << "allocations in " << kUpdates << " updates of " << kLinks << " links: ours "
            << counts.ours << ", tf2 " << counts.tf2 << ", roscpp's messages " << counts.roscpp
            << "\n";
}

TEST(Allocations, AreSeenWhereThereAreSome) {
  counts = Counts();
  is_counting = true;
  const std::string text(100, 'x');
  is_counting = false;
  EXPECT_EQ(counts.ours, 1) << text;
}

}  // namespace
}  // namespace link_bounds
