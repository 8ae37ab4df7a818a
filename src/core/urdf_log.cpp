// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A console_bridge handler that belongs to one thread.
#include "urdf_log.h"

namespace link_bounds {

UrdfLog::UrdfLog()
    : owner_(std::this_thread::get_id()), others_(console_bridge::getOutputHandler()) {
  console_bridge::useOutputHandler(this);
}

UrdfLog::~UrdfLog() {
  console_bridge::useOutputHandler(others_);
}

void UrdfLog::log(const std::string& text, console_bridge::LogLevel level, const char* file,
                  int line) {
  if (std::this_thread::get_id() != owner_) {
    if (others_) others_->log(text, level, file, line);
  } else if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
    messages_.push_back(text);
  }
}

std::string UrdfLog::messages(const std::string& part) const {
  std::string result;
  for (const std::string& message : messages_) {
    if (message.find(part) == std::string::npos) continue;
    result += (result.empty() ? "" : "; ") + message;
  }
  return result;
}

}  // namespace link_bounds
