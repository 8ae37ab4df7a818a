// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/run/record_order.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace link_bounds {
namespace {

/// Several publishers may write their messages on one topic out of order, by less than this [ns].
constexpr std::int64_t kMinStepBack = 100'000'000;

/// The first frame or joint of a message; "" of other types.
std::string_view subjectOf(const BagMessage& message) {
  std::size_t at = 0;
  const auto skip = [&](std::size_t bytes) {
    at = std::min<std::size_t>(message.size, at + bytes);
  };
  const auto number = [&] {
    std::uint32_t result = 0;
    if (message.size - at >= sizeof(result))
      std::memcpy(&result, message.data + at, sizeof(result));
    skip(sizeof(result));
    return result;
  };
  const auto text = [&] {
    const std::uint32_t length = number();
    const std::size_t begin = at;
    skip(length);
    return std::string_view(reinterpret_cast<const char*>(message.data) + begin, at - begin);
  };
  constexpr std::size_t kHeader = 12;  // bytes of a header before its frame
  if (*message.type == "sensor_msgs/JointState") {
    skip(kHeader);
    text();
    return number() > 0 ? text() : std::string_view();
  }
  const bool is_tf = *message.type == "tf2_msgs/TFMessage" || *message.type == "tf/tfMessage";
  if (!is_tf || number() == 0) return {};
  skip(kHeader);
  text();
  return text();
}

}  // namespace

void RecordOrder::watch(const BagMessage& message, bool is_jump_back) {
  key_.assign(*message.topic).append(1, '\n').append(*message.publisher).append(1, '\n');
  key_.append(subjectOf(message));
  Newest& newest = newest_[key_];
  const bool goes_back = newest.time > message.time + kMinStepBack;
  // A publisher that has sent since the step, and goes back now, says nothing about that step.
  if (may_be_jump_ && goes_back && !is_jump_back && newest.steps_back < all_steps_back_) {
    steps_back_.pop_back();
    may_be_jump_ = false;
  }
  if (is_jump_back || message.time >= before_step_) may_be_jump_ = false;
  if (is_jump_back && !goes_back) {
    steps_back_.push_back(message.time);
    before_step_ = last_;
    may_be_jump_ = true;
    ++all_steps_back_;
  }
  last_ = is_jump_back ? message.time : std::max(last_, message.time);
  newest = {goes_back ? message.time : std::max(newest.time, message.time), all_steps_back_};
}

}  // namespace link_bounds
