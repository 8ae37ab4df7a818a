// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which thread frees a model, and which model is in use after one could not be adopted.
#include "node/loading/hand_over.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/time.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

#include "node/threads/queued_function.h"
#include "world/model/model.h"

namespace link_bounds {
namespace {

using ModelPtr = HandOver<Model>::MadePtr;

constexpr int kModels = 5000;

/// The worker is the loader thread; another thread serves the queue.
class HandOverTest : public testing::Test {
 protected:
  HandOverTest() { ros::Time::init(); }  // for the log
  ~HandOverTest() override {
    ends_ = true;
    update_thread_.join();
    worker_.stop();
  }

  /// Counts models that another thread than the loader frees.
  ModelPtr makeModel(const std::string& fixed_frame) {
    auto* model = new Model;
    model->fixed_frame = fixed_frame;
    return ModelPtr(model, [this](const Model* freed) {
      if (std::this_thread::get_id() != loader_) ++freed_elsewhere_;
      delete freed;
    });
  }

  /// On the loader thread. Throws what giving throws.
  bool give(const std::string& fixed_frame) {
    std::promise<bool> answer;
    worker_.post("give", [&] {
      loader_ = std::this_thread::get_id();
      try {
        answer.set_value(hand_over_.give(makeModel(fixed_frame)));
      } catch (...) {
        answer.set_exception(std::current_exception());
      }
    });
    return answer.get_future().get();
  }

  void adopt(ModelPtr model) {
    model_ = std::move(model);
    if (model_->fixed_frame == "bad") throw std::runtime_error("it is bad");
  }

  void serve() {
    while (!ends_)
      queue_.callAvailable(ros::WallDuration(1e-3));
  }

  static Worker::Options options() {
    Worker::Options options;
    options.name = "loader";
    return options;
  }

  std::atomic<std::thread::id> loader_;
  std::atomic<int> freed_elsewhere_{0};
  std::atomic<bool> ends_{false};
  ros::CallbackQueue queue_;
  ModelPtr model_;  ///< of the update thread
  Worker worker_{options()};
  HandOver<Model> hand_over_{worker_, queue_, [this](ModelPtr model) { adopt(std::move(model)); }};
  std::thread update_thread_{[this] { serve(); }};
};

TEST_F(HandOverTest, TheUpdateThreadFreesNoModel) {
  for (int i = 0; i < kModels; ++i)
    ASSERT_TRUE(give("good"));
  EXPECT_EQ(freed_elsewhere_, 0);
}

TEST_F(HandOverTest, AModelThatCannotBeAdoptedLeavesTheOldOne) {
  ASSERT_TRUE(give("good"));
  for (int i = 0; i < kModels; ++i) {
    try {
      give("bad");
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "it is bad");
    }
    ASSERT_EQ(model_->fixed_frame, "good");
  }
  EXPECT_EQ(freed_elsewhere_, 0);
}

TEST_F(HandOverTest, TheFirstModelThatCannotBeAdoptedIsReported) {
  EXPECT_THROW(give("bad"), std::runtime_error);
  EXPECT_TRUE(give("good"));
}

TEST_F(HandOverTest, AModelThatIsNotTakenBeforeTheLoaderStopsIsNotTakenLater) {
  ASSERT_TRUE(give("good"));
  std::promise<void> goes_on;
  enqueue(queue_, [goes_on = goes_on.get_future().share()] { goes_on.wait(); });
  std::promise<void> begins;
  std::atomic<bool> is_given{true};
  worker_.post("give", [&] {
    begins.set_value();
    is_given = hand_over_.give(makeModel("late"));
  });
  begins.get_future().wait();
  worker_.stop();
  EXPECT_FALSE(is_given);
  std::promise<void> is_done;
  enqueue(queue_, [&] { is_done.set_value(); });
  goes_on.set_value();
  is_done.get_future().wait();
  EXPECT_EQ(model_->fixed_frame, "good");
}

}  // namespace
}  // namespace link_bounds
