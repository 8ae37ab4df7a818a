// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread: reads the parameters, waits for the robot description, loads the robot,
// answers ~reload.
#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "node/interface/parameter_text.h"
#include "node/interface/read_parameters.h"
#include "node/interface/topics.h"
#include "node/loading/hand_over.h"
#include "node/loading/robot_description.h"
#include "node/threads/worker.h"
#include "world/log/log_text.h"

namespace link_bounds {

/// The response of a ~reload that succeeded: one line, with the first few warnings.
inline std::string reloadedText(const std::vector<std::string>& warnings) {
  constexpr std::size_t kMaxAnsweredWarnings = 4;
  if (warnings.empty()) return "reloaded";
  std::string text = "reloaded, with " + std::to_string(warnings.size()) + " warning" +
                     (warnings.size() > 1 ? "s" : "");
  for (std::size_t i = 0; i < std::min(warnings.size(), kMaxAnsweredWarnings); ++i)
    text += (i == 0 ? ": " : "; ") + warnings[i];
  return logText(text + (warnings.size() > kMaxAnsweredWarnings ? "; see the log for all" : ""));
}

/// Makes an immutable object from a robot description and parameters. Until a robot has been
/// loaded, the thread polls for the description. `Made` has lists `problems` and `warnings`, which
/// are logged.
template <class Made, class Parameters>
class RobotLoading {
 public:
  using MadePtr = std::shared_ptr<const Made>;

  struct Loaded {
    MadePtr made;         ///< null if `is_stopping` returned true
    std::string summary;  ///< one line for the log
  };

  struct Handlers {
    /// Reads the parameters. Called at the start and for each ~reload.
    std::function<ReadParameters<Parameters>(const ParameterServer& server)> read;
    std::function<Loaded(const std::string& urdf, const Parameters& parameters,
                         const std::function<bool()>& is_stopping)>
        load;
    /// Makes the object that is used while there is no usable description; null if there is none.
    std::function<MadePtr(const Parameters& parameters)> load_nothing = [](auto&) {
      return nullptr;
    };
    /// Called on the thread that serves the queue. If it throws, the error becomes the response of
    /// ~reload, and `adopt` is called again with the object that was in use.
    std::function<void(MadePtr)> adopt;
    /// Called if the first load failed permanently, after that was logged.
    std::function<void()> on_failure;
  };

  /// All handlers except `adopt` run on the loader thread. Throws std::runtime_error if that thread
  /// cannot be started.
  RobotLoading(const TopicName& reload, const ros::NodeHandle& node,
               const ros::NodeHandle& private_node, ros::CallbackQueueInterface& queue,
               Handlers handlers)
      : handlers_(std::move(handlers)),
        server_([this] { return worker_.isStopping(); }),
        description_(server_, node),
        hand_over_(worker_, queue, handlers_.adopt),
        worker_({"loader", false, [this] { return onTick(); }, std::chrono::milliseconds(200)}) {
    ros::NodeHandle loader_node(private_node);
    loader_node.setCallbackQueue(&worker_);
    reload_service_ =
        loader_node.advertiseService(privateName(reload), &RobotLoading::onReload, this);
  }
  ~RobotLoading() { worker_.stop(); }
  RobotLoading(const RobotLoading&) = delete;
  RobotLoading& operator=(const RobotLoading&) = delete;

  bool waitsForDescription() const { return waits_for_description_; }
  std::string descriptionName() const { return description_.name(); }

  /// True if the first load failed permanently.
  bool hasFailed() const { return has_failed_; }

  /// The reason why nothing can be loaded; "" before the first failure and after the first success.
  std::string failure() const {
    const std::lock_guard<std::mutex> lock(failure_mutex_);
    return failure_;
  }

  /// The loader thread, also for other work that takes long.
  Worker& worker() { return worker_; }

 private:
  bool onTick() {
    if (has_loaded_ || has_failed_) return false;
    try {
      if (!parameters_) readParameters();
      firstLoad();
    } catch (const std::exception& error) {
      if (worker_.isStopping()) return false;
      setFailure(logText(error.what()));
      ROS_FATAL("%s", logText(error.what()).c_str());
      has_failed_ = true;
      handlers_.on_failure();
    }
    return !has_loaded_;
  }

  void firstLoad() {
    try {
      const XmlRpc::XmlRpcValue description = description_.read();
      if (!refused_.valid() || !(refused_ == description)) load(description);
    } catch (const NoDescription& reason) {
      refused_.clear();
      waits_for_description_ = true;
      description_.warnOfWaiting(reason.what());
      if (!goes_on_) goOn();
    } catch (const std::exception& error) {
      if (!goes_on_) throw;
      waits_for_description_ = true;
      ROS_ERROR("%s; waiting for another robot_description", logText(error.what()).c_str());
    }
  }

  /// Continues without a robot. False if the handlers do not support that.
  bool goOn() {
    const MadePtr nothing = handlers_.load_nothing(*parameters_);
    if (nothing) goes_on_ = hand_over_.give(nothing);
    return nothing != nullptr;
  }

  /// Returns the warnings, which were logged.
  std::vector<std::string> readParameters() {
    ReadParameters<Parameters> read = handlers_.read(server_);
    warn(read.warnings);
    parameters_ = std::move(read.parameters);
    return std::move(read.warnings);
  }

  /// Throws RobotError, and what the handlers throw. Null if the loader is stopping.
  MadePtr load(XmlRpc::XmlRpcValue description) {
    refused_ = description;
    if (description.getType() != XmlRpc::XmlRpcValue::TypeString) {
      throw RobotError("parameter " + description_.name() + " is " + valueText(description) +
                       ", not a string; load the text of the URDF there");
    }
    waits_for_description_ = false;
    const auto [made, summary] =
        handlers_.load(static_cast<std::string&>(description), *parameters_,
                       [this] { return worker_.isStopping(); });
    if (!made) return nullptr;
    for (const std::string& problem : made->problems)
      ROS_ERROR("%s", logText(problem).c_str());
    warn(made->warnings);
    ROS_INFO("%s", summary.c_str());
    has_loaded_ = hand_over_.give(made) || has_loaded_;
    refused_.clear();
    setFailure("");
    return made;
  }

  void setFailure(const std::string& reason) {
    const std::lock_guard<std::mutex> lock(failure_mutex_);
    failure_ = reason;
  }

  static void warn(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
      ROS_WARN("%s", logText(warning).c_str());
  }

  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const std::optional<Parameters> old_parameters = parameters_;
    const XmlRpc::XmlRpcValue old_refused = refused_;
    try {
      response.message = reloadedText(reload());
      response.success = true;
    } catch (const std::exception& error) {
      const std::string reason = logText(error.what());
      if (!has_loaded_) setFailure(reason);
      parameters_ = old_parameters;
      refused_ = old_refused;
      waits_for_description_ = !has_loaded_;
      ROS_ERROR("reload failed, everything stays as it was: %s", reason.c_str());
      response.success = false;
      response.message = reason;
    }
    return true;
  }

  /// Returns the warnings and problems that were logged for the parameters and the robot.
  std::vector<std::string> reload() {
    std::vector<std::string> lines = readParameters();
    try {
      if (const MadePtr made = load(description_.read())) {
        lines.insert(lines.end(), made->problems.begin(), made->problems.end());
        lines.insert(lines.end(), made->warnings.begin(), made->warnings.end());
      }
    } catch (const NoDescription&) {
      if (has_loaded_ || !goOn()) throw;
    }
    return lines;
  }

  Handlers handlers_;
  ParameterServer server_;
  RobotDescription description_;
  std::optional<Parameters> parameters_;
  bool has_loaded_ = false;      ///< a robot has been loaded
  bool goes_on_ = false;         ///< continues without a robot, until one is loaded
  XmlRpc::XmlRpcValue refused_;  ///< unusable description, which firstLoad() does not retry
  std::atomic<bool> waits_for_description_{false};
  std::atomic<bool> has_failed_{false};
  mutable std::mutex failure_mutex_;
  std::string failure_;
  HandOver<Made> hand_over_;
  Worker worker_;  ///< last: its thread uses the members above
  ros::ServiceServer reload_service_;
};

}  // namespace link_bounds
