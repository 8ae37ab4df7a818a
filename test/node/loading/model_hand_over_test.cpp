// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which thread frees a model, and which model is in use after one could not be adopted.
#include "node/loading/model_hand_over.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/time.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

#include "node/threads/queued_function.h"

namespace link_bounds {
namespace {

using ModelPtr = ModelHandOver::ModelPtr;

constexpr int kModels = 5000;

/// The test is the loader thread; another thread serves the queue.
class ModelHandOverTest : public testing::Test {
 protected:
  ModelHandOverTest() { ros::Time::init(); }  // for the log
  ~ModelHandOverTest() override {
    ends_ = true;
    update_thread_.join();
  }

  /// Counts models that another thread than this one frees.
  ModelPtr makeModel(const std::string& fixed_frame) {
    auto* model = new Model;
    model->fixed_frame = fixed_frame;
    return ModelPtr(model, [this, loader = std::this_thread::get_id()](const Model* freed) {
      if (std::this_thread::get_id() != loader) ++freed_elsewhere_;
      delete freed;
    });
  }

  bool give(ModelPtr model) {
    return hand_over_.give(std::move(model), [] { return false; });
  }

  void adopt(ModelPtr model) {
    model_ = std::move(model);
    if (model_->fixed_frame == "bad") throw std::runtime_error("it is bad");
  }

  void serve() {
    while (!ends_)
      queue_.callAvailable(ros::WallDuration(1e-3));
  }

  std::atomic<int> freed_elsewhere_{0};
  std::atomic<bool> ends_{false};
  ros::CallbackQueue queue_;
  ModelPtr model_;  ///< of the update thread
  ModelHandOver hand_over_{queue_, [this](ModelPtr model) { adopt(std::move(model)); }};
  std::thread update_thread_{[this] { serve(); }};
};

TEST_F(ModelHandOverTest, TheUpdateThreadFreesNoModel) {
  for (int i = 0; i < kModels; ++i)
    ASSERT_TRUE(give(makeModel("good")));
  EXPECT_EQ(freed_elsewhere_, 0);
}

TEST_F(ModelHandOverTest, AModelThatCannotBeAdoptedLeavesTheOldOne) {
  ASSERT_TRUE(give(makeModel("good")));
  for (int i = 0; i < kModels; ++i) {
    try {
      give(makeModel("bad"));
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "it is bad");
    }
    ASSERT_EQ(model_->fixed_frame, "good");
  }
  EXPECT_EQ(freed_elsewhere_, 0);
}

TEST_F(ModelHandOverTest, TheFirstModelThatCannotBeAdoptedIsReported) {
  EXPECT_THROW(give(makeModel("bad")), std::runtime_error);
  EXPECT_TRUE(give(makeModel("good")));
}

TEST_F(ModelHandOverTest, AModelThatIsTakenAfterAllIsNotFreedThereEither) {
  ASSERT_TRUE(give(makeModel("good")));
  std::promise<void> goes_on;
  enqueue(queue_, [goes_on = goes_on.get_future().share()] { goes_on.wait(); });
  EXPECT_FALSE(hand_over_.give(makeModel("late"), [] { return true; }));
  EXPECT_FALSE(hand_over_.give(makeModel("later"), [] { return true; }));
  std::promise<void> is_done;
  enqueue(queue_, [&] { is_done.set_value(); });
  goes_on.set_value();
  is_done.get_future().wait();
  EXPECT_EQ(model_->fixed_frame, "late");
  EXPECT_EQ(freed_elsewhere_, 0);
}

}  // namespace
}  // namespace link_bounds
