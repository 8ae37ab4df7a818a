// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// System calls that qemu-user, which runs programs of another processor, ignores. Tests that need
// them are skipped there, and nowhere else.
#pragma once

#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace link_bounds {

/// Whether a process gets no more memory than its limit allows.
inline bool limitsMemory() {
  constexpr std::size_t kBytes = std::size_t(1) << 30;
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{kBytes, kBytes};
    const bool is_set = setrlimit(RLIMIT_AS, &limit) == 0;
    const void* memory = mmap(nullptr, kBytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    _exit(is_set && memory != MAP_FAILED ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return !WIFEXITED(status) || WEXITSTATUS(status) != 1;
}

/// Whether posix_spawn fails for a program that does not exist.
inline bool missesPrograms() {
  char name[] = "/nowhere/program";
  char* const arguments[] = {name, nullptr};
  pid_t child = 0;
  if (posix_spawn(&child, name, nullptr, nullptr, arguments, environ) != 0) return true;
  waitpid(child, nullptr, 0);
  return false;
}

}  // namespace link_bounds
