// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What urdfdom has to say about a description, caught instead of printed.
#pragma once

#include <console_bridge/console.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace link_bounds {

/// While it lives, keeps the messages that this thread sends to console_bridge (urdfdom's only
/// channel for reasons) and passes on those of other threads. If `urdf` contains a per cent sign,
/// nobody hears anything: urdfdom hands pieces of the text to printf as its format, and "%n" there
/// ends the process. console_bridge has one handler, so one thread at a time may have such logs,
/// one inside another; other threads wait for their turn.
class UrdfLog : public console_bridge::OutputHandler {
 public:
  explicit UrdfLog(const std::string& urdf);
  ~UrdfLog() override;
  UrdfLog(const UrdfLog&) = delete;
  UrdfLog& operator=(const UrdfLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file,
           int line) override;

  /// The messages so far that contain `part`, joined by "; "; why there are none if nobody listens.
  std::string messages(const std::string& part = "") const;

 private:
  std::unique_lock<std::recursive_mutex> turn_;  ///< taken first, given back last
  std::thread::id owner_;
  console_bridge::OutputHandler* others_;
  bool is_deaf_;
  std::vector<std::string> messages_;
};

}  // namespace link_bounds
