// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// posix_spawn, poll, and waitpid with a timeout.
#include "robot/worker/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace link_bounds {
namespace {

constexpr int kPollMilliseconds = 20;              // how late an interrupt is noticed
constexpr std::chrono::milliseconds kExitPoll(1);  // a reader ends within some milliseconds
constexpr std::chrono::seconds kKillTimeout(2);  // only a process in an uninterruptible call takes
                                                 // longer
constexpr int kPipeBytes = 1 << 20;  // what Linux allows any user, see /proc/sys/fs/pipe-max-size

[[noreturn]] void throwSystemError(int error) {
  throw std::system_error(error, std::system_category());
}

/// Checks the result of functions that return the error number.
void check(int error) {
  if (error != 0) throwSystemError(error);
}

/// The child gets a process group of its own, so that Ctrl-C in the terminal does not reach it.
class SpawnOptions {
 public:
  explicit SpawnOptions(int standard_output) {
    check(posix_spawn_file_actions_init(&files));
    check(posix_spawnattr_init(&attributes));
    try {
      fill(standard_output);
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~SpawnOptions() { destroy(); }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

 private:
  void fill(int standard_output) {
    check(posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0));
    check(posix_spawn_file_actions_adddup2(&files, standard_output, STDOUT_FILENO));
    check(posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0));
    sigset_t all;
    sigset_t none;
    sigfillset(&all);
    sigemptyset(&none);
    check(posix_spawnattr_setsigdefault(&attributes, &all));
    check(posix_spawnattr_setsigmask(&attributes, &none));
    check(posix_spawnattr_setpgroup(&attributes, 0));
    check(posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP));
  }

  void destroy() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

/// Children that did not end when they were killed, and must be waited for later.
class UnkillableChildren {
 public:
  void add(pid_t child) {
    const std::lock_guard<std::mutex> lock(mutex_);
    children_.push_back(child);
  }

  /// Waits for those that have ended meanwhile.
  void reap() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto has_ended = [](pid_t child) { return waitpid(child, nullptr, WNOHANG) != 0; };
    children_.erase(std::remove_if(children_.begin(), children_.end(), has_ended), children_.end());
  }

 private:
  std::mutex mutex_;
  std::vector<pid_t> children_;
};

UnkillableChildren& unkillableChildren() {
  static UnkillableChildren children;
  return children;
}

}  // namespace

Pipe::Pipe() {
  if (pipe2(end_.data(), O_CLOEXEC) != 0) throwSystemError(errno);
  fcntl(end_[0], F_SETPIPE_SZ, kPipeBytes);
}

Pipe::~Pipe() {
  closeWritingEnd();
  close(end_[0]);
}

void Pipe::closeWritingEnd() {
  if (end_[1] >= 0) close(end_[1]);
  end_[1] = -1;
}

std::size_t Pipe::read(void* out, std::size_t wanted, const CheckInterrupt& check_interrupt) {
  std::size_t count = 0;
  while (count < wanted && !has_ended_) {
    check_interrupt();
    pollfd waiting{end_[0], POLLIN, 0};
    if (poll(&waiting, 1, kPollMilliseconds) <= 0) continue;
    const ssize_t got = ::read(end_[0], static_cast<char*>(out) + count, wanted - count);
    if (got > 0) count += static_cast<std::size_t>(got);
    if (got == 0) has_ended_ = true;
    if (got < 0 && errno != EINTR && errno != EAGAIN) throwSystemError(errno);
  }
  return count;
}

ChildProcess::ChildProcess(std::vector<std::string> arguments, int standard_output) {
  unkillableChildren().reap();
  const SpawnOptions options(standard_output);
  std::vector<char*> argv;
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  errno = 0;
  const int error =
      posix_spawn(&pid_, argv[0], &options.files, &options.attributes, argv.data(), environ);
  // glibc 2.31 returns 1 = EPERM where no process can be made; errno then holds the true reason.
  check(error == EPERM && errno != 0 ? errno : error);
}

bool ChildProcess::end() {
  if (pid_ == 0) return true;
  // No other process gets its pid, which is also that of its group, before waitpid.
  kill(-pid_, SIGKILL);
  const auto deadline = std::chrono::steady_clock::now() + kKillTimeout;
  const pid_t child = std::exchange(pid_, 0);
  while (waitpid(child, nullptr, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      unkillableChildren().add(child);
      return false;
    }
    std::this_thread::sleep_for(kExitPoll);
  }
  return true;
}

int ChildProcess::waitForSignal(const CheckInterrupt& check_interrupt) {
  siginfo_t info{};
  while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == 0) {
    check_interrupt();
    std::this_thread::sleep_for(kExitPoll);
  }
  end();
  return info.si_pid != 0 && info.si_code != CLD_EXITED ? info.si_status : 0;
}

}  // namespace link_bounds
