// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a process holds: children, descriptors, memory.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace link_bounds {

/// Also true of children that have ended and that nobody has waited for.
inline bool hasChildren() {
  siginfo_t ignored;
  return waitid(P_ALL, 0, &ignored, WEXITED | WNOHANG | WNOWAIT) == 0 || errno != ECHILD;
}

/// False of one that has ended and that nobody has waited for.
inline bool isRunning(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  if (!std::getline(stat, text)) return false;
  return text.compare(text.rfind(')') + 2, 1, "Z") != 0;
}

inline long openDescriptors() {
  const std::filesystem::directory_iterator entries("/proc/self/fd");
  return std::distance(begin(entries), end(entries));
}

/// In RAM. Throws if the process has ended.
inline long residentBytes(pid_t process = getpid()) {
  long total_pages = 0;
  long resident_pages = 0;
  std::ifstream("/proc/" + std::to_string(process) + "/statm") >> total_pages >> resident_pages;
  if (resident_pages == 0) throw std::runtime_error("the process has ended");
  return resident_pages * sysconf(_SC_PAGESIZE);
}

}  // namespace link_bounds
