// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One logger for the process that sorts messages by thread.
#include "robot/worker/import_log.h"

#include <assimp/DefaultLogger.hpp>

namespace link_bounds {
namespace {

thread_local std::vector<std::string>* errors_of_this_thread = nullptr;

/// The names of the pure functions differ between versions of assimp (the last two, and
/// OnVerboseDebug), so none is marked as overriding.
class ThreadLogger : public Assimp::Logger {
 public:
  void OnDebug(const char*) {}
  void OnVerboseDebug(const char*) {}
  void OnInfo(const char*) {}
  void OnWarn(const char*) {}
  void OnError(const char* message) {
    if (errors_of_this_thread) errors_of_this_thread->push_back(message);
  }
  bool attachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detachStream(Assimp::LogStream*, unsigned int) { return false; }
  bool detatchStream(Assimp::LogStream*, unsigned int) { return false; }
};

/// assimp owns the logger from here on.
void installLogger() {
  static const bool installed = [] {
    Assimp::DefaultLogger::set(new ThreadLogger);
    return true;
  }();
  static_cast<void>(installed);
}

}  // namespace

ImportLog::ImportLog() {
  installLogger();
  errors_of_this_thread = &errors_;
}

ImportLog::~ImportLog() {
  errors_of_this_thread = nullptr;
}

std::string ImportLog::errorWith(const std::string& part) const {
  for (const std::string& error : errors_) {
    if (error.find(part) != std::string::npos) return error;
  }
  return "";
}

}  // namespace link_bounds
