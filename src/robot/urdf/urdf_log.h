// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Collects the messages of urdfdom instead of printing them.
#pragma once

#include <console_bridge/console.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace link_bounds {

/// urdfdom gives its reasons to console_bridge only. While a UrdfLog lives, it collects the
/// messages of its thread and passes on those of other threads. If `urdf` contains a per cent sign,
/// messages are switched off: urdfdom passes pieces of the text to printf as the format, where "%n"
/// ends the process. console_bridge has one handler, so the constructor waits until no other thread
/// has a UrdfLog. One thread may nest them.
class UrdfLog : public console_bridge::OutputHandler {
 public:
  explicit UrdfLog(const std::string& urdf);
  ~UrdfLog() override;
  UrdfLog(const UrdfLog&) = delete;
  UrdfLog& operator=(const UrdfLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file,
           int line) override;

  bool isOff() const { return is_off_; }

  /// The messages so far that contain `part`, joined by "; ". If messages are switched off, says
  /// so.
  std::string messages(const std::string& part = "") const;

 private:
  std::unique_lock<std::recursive_mutex> lock_;  ///< the first member, so that it is held longest
  std::thread::id owner_;
  console_bridge::OutputHandler* previous_handler_;
  bool is_off_;
  std::vector<std::string> messages_;
};

}  // namespace link_bounds
