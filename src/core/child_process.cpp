// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// posix_spawn, poll and waitpid.
#include "child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

namespace link_bounds {
namespace {

constexpr int kPollMilliseconds = 20;
constexpr std::chrono::milliseconds kExitPoll(1);
constexpr int kPipeBytes = 1 << 20;

/// A process group of its own keeps the terminal's Ctrl-C away from the child; ours ends it.
class SpawnOptions {
 public:
  explicit SpawnOptions(int standard_output) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, standard_output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    sigset_t all;
    sigset_t none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnOptions() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
};

[[noreturn]] void throwSystemError(int error) {
  throw std::system_error(error, std::system_category());
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

std::size_t Pipe::read(void* out, std::size_t wanted, const CheckPatience& check_patience) {
  std::size_t count = 0;
  while (count < wanted && !has_ended_) {
    check_patience();
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
  const SpawnOptions options(standard_output);
  std::vector<char*> argv;
  for (std::string& argument : arguments)
    argv.push_back(argument.data());
  argv.push_back(nullptr);
  const int error =
      posix_spawn(&pid_, argv[0], &options.files, &options.attributes, argv.data(), environ);
  if (error != 0) throwSystemError(error);
}

ChildProcess::~ChildProcess() {
  if (pid_ == 0) return;
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

int ChildProcess::waitForSignal(const CheckPatience& check_patience) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(pid_, &status, WNOHANG)) == 0) {
    check_patience();
    std::this_thread::sleep_for(kExitPoll);
  }
  pid_ = 0;
  return ended > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace link_bounds
