// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A console_bridge handler for the messages of one thread.
#include "robot/urdf/urdf_log.h"

namespace link_bounds {
namespace {

/// Any character reference may stand for a per cent sign.
bool mayContainPercent(const std::string& urdf) {
  return urdf.find('%') != std::string::npos || urdf.find("&#") != std::string::npos;
}

std::recursive_mutex& handlerMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

UrdfLog::UrdfLog(const std::string& urdf)
    : lock_(handlerMutex()),
      owner_(std::this_thread::get_id()),
      previous_handler_(console_bridge::getOutputHandler()),
      is_off_(mayContainPercent(urdf)) {
  console_bridge::useOutputHandler(is_off_ ? nullptr : this);
}

UrdfLog::~UrdfLog() {
  // Keeps a handler that others have set meanwhile.
  const console_bridge::OutputHandler* const own = is_off_ ? nullptr : this;
  if (console_bridge::getOutputHandler() == own)
    console_bridge::useOutputHandler(previous_handler_);
}

void UrdfLog::log(const std::string& text, console_bridge::LogLevel level, const char* file,
                  int line) {
  if (std::this_thread::get_id() != owner_) {
    if (previous_handler_) previous_handler_->log(text, level, file, line);
  } else if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
    messages_.push_back(text);
  }
}

std::string UrdfLog::messages(const std::string& part) const {
  if (is_off_)
    return "urdfdom's reason is not available for a text with % or &#; write it without them";
  std::string result;
  for (const std::string& message : messages_) {
    if (message.find(part) == std::string::npos) continue;
    result += (result.empty() ? "" : "; ") + message;
  }
  return result;
}

}  // namespace link_bounds
