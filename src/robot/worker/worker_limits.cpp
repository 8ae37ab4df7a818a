// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// setrlimit, prctl, and a loop over the open descriptors.
#include "robot/worker/worker_limits.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace link_bounds {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

constexpr std::uint64_t kMinMemory = std::uint64_t(512) << 20;
constexpr std::uint64_t kMemoryPerByte = 32;
constexpr rlim_t kOpenFiles = 32;

/// Checks the result of functions that return -1 and set errno.
void checkCall(int result) {
  if (result != 0) throw std::system_error(errno, std::system_category());
}

void limit(decltype(RLIMIT_AS) resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  checkCall(getrlimit(resource, &now));
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  checkCall(setrlimit(resource, &wanted));
}

/// Otherwise sockets of the node would stay open in its children.
void closeInheritedFiles() {
  std::vector<int> inherited;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::stoi(entry.path().filename().string());
    if (descriptor > STDERR_FILENO) inherited.push_back(descriptor);
  }
  for (const int descriptor : inherited)
    close(descriptor);
}

}  // namespace

std::uint64_t memoryLimit(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMaxBytes =
      (std::numeric_limits<std::uint64_t>::max() - kMinMemory) / kMemoryPerByte;
  return kMinMemory + kMemoryPerByte * std::min(file_bytes, kMaxBytes);
}

void limitThisProcess(const MemoryLimits& memory, long cpu_seconds, pid_t parent) {
  checkCall(prctl(PR_SET_PDEATHSIG, SIGKILL));
  if (getppid() != parent) _exit(1);
  checkCall(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0));
  closeInheritedFiles();
  const auto cpu = static_cast<rlim_t>(cpu_seconds);
  limit(RLIMIT_CPU, cpu, cpu + 1);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_NOFILE, kOpenFiles, kOpenFiles);
  limit(RLIMIT_NPROC, 0, 0);
  if (kIsSanitized) return;
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_AS, memory.now, memory.max);
}

void raiseMemoryLimit(std::uint64_t bytes) {
  rlimit now{};
  checkCall(getrlimit(RLIMIT_AS, &now));
  if (bytes > now.rlim_cur) limit(RLIMIT_AS, bytes, now.rlim_max);
}

}  // namespace link_bounds
