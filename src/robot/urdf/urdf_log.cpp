// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A console_bridge handler that belongs to one thread.
#include "robot/urdf/urdf_log.h"

namespace link_bounds {
namespace {

/// As it is written, or as a character reference, of which any may be one.
bool mayContainPercent(const std::string& urdf) {
  return urdf.find('%') != std::string::npos || urdf.find("&#") != std::string::npos;
}

std::recursive_mutex& turns() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

UrdfLog::UrdfLog(const std::string& urdf)
    : turn_(turns()),
      owner_(std::this_thread::get_id()),
      others_(console_bridge::getOutputHandler()),
      is_deaf_(mayContainPercent(urdf)) {
  console_bridge::useOutputHandler(is_deaf_ ? nullptr : this);
}

UrdfLog::~UrdfLog() {
  // Somebody else may have set another one meanwhile, which is then to stay.
  const console_bridge::OutputHandler* const own = is_deaf_ ? nullptr : this;
  if (console_bridge::getOutputHandler() == own) console_bridge::useOutputHandler(others_);
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
  if (is_deaf_)
    return "urdfdom's reason is not to be had for a text with % or &#; write it without";
  std::string result;
  for (const std::string& message : messages_) {
    if (message.find(part) == std::string::npos) continue;
    result += (result.empty() ? "" : "; ") + message;
  }
  return result;
}

}  // namespace link_bounds
