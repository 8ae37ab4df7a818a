// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A limit on processes means nothing to root.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <system_error>
#include <thread>

namespace link_bounds {

/// For the rest of this process's life, which should be that of a fork.
inline bool becomeOrdinaryUser() {
  constexpr uid_t kNobody = 65534;
  return getuid() != 0 || setuid(kNobody) == 0;
}

/// The same; false if threads start nevertheless.
inline bool forbidThreads() {
  const rlimit none{0, 0};
  if (!becomeOrdinaryUser() || setrlimit(RLIMIT_NPROC, &none) != 0) return false;
  try {
    std::thread([] {}).join();
    return false;
  } catch (const std::system_error&) {
    return true;
  }
}

/// Whether it is true in a fork in which no thread can start.
template <class Function>
bool isTrueWithoutThreads(const Function& is_true) {
  const pid_t child = fork();
  if (child == 0) _exit(forbidThreads() && is_true() ? 0 : 1);
  int status = -1;
  return waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace link_bounds
