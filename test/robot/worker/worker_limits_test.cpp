// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each limit is tried out in a child process, which must not survive or must not succeed.
#include "robot/worker/worker_limits.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <functional>
#include <system_error>

#include "testing/emulated.h"
#include "testing/ordinary_user.h"
#include "testing/sanitized.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t(1) << 30;
constexpr int kDeadlineMilliseconds = 20000;

/// How a child ends that limits itself and then does this; its exit code is the answer.
int statusOf(const std::function<bool()>& body, long cpu_seconds = 100) {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    limitThisProcess({kMemory, kMemory}, cpu_seconds, parent);
    _exit(body() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST(WorkerLimits, MemoryEnds) {
  if (kIsSanitized) GTEST_SKIP() << "skipped: no such limit under a sanitizer";
  if (!limitsMemory()) GTEST_SKIP() << "skipped: this emulator ignores limits of memory";
  EXPECT_EQ(statusOf([] {
              return mmap(nullptr, kMemory, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) ==
                     MAP_FAILED;
            }),
            0);
}

TEST(WorkerLimits, AFileThatDoublesGetsMoreMemory) {
  EXPECT_GT(memoryLimit(2000000), memoryLimit(1000000));
  EXPECT_LT(memoryLimit(0), std::uint64_t(1) << 30);
  EXPECT_GT(memoryLimit(~std::uint64_t(0)), std::uint64_t(1) << 63);
}

/// Whether a process can take so much memory.
bool canTake(std::uint64_t bytes) {
  return mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
}

TEST(WorkerLimits, TheMemoryLimitRisesToItsMaxAndNeverFalls) {
  if (kIsSanitized) GTEST_SKIP() << "skipped: no such limit under a sanitizer";
  if (!limitsMemory()) GTEST_SKIP() << "skipped: this emulator ignores limits of memory";
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    limitThisProcess({kMemory, 3 * kMemory}, 100, parent);
    if (canTake(kMemory)) _exit(1);
    raiseMemoryLimit(2 * kMemory);
    raiseMemoryLimit(kMemory);
    if (!canTake(kMemory)) _exit(2);
    raiseMemoryLimit(100 * kMemory);
    _exit(canTake(3 * kMemory) ? 3 : 0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(WIFEXITED(status));
}

TEST(WorkerLimits, TimeOfTheProcessorEnds) {
  const int status = statusOf(
      [] {
        for (volatile int i = 0;; i = i + 1) {
        }
        return false;
      },
      1);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGXCPU);
}

TEST(WorkerLimits, NoFileIsWritten) {
  if (kIsSanitized) GTEST_SKIP() << "skipped: no such limit under a sanitizer";
  const TemporaryFolder folder;
  const std::string path = folder / "file";
  EXPECT_EQ(statusOf([&path] {
              signal(SIGXFSZ, SIG_IGN);
              const int file = open(path.c_str(), O_CREAT | O_WRONLY, 0600);
              return file >= 0 && write(file, "x", 1) < 0;
            }),
            0);
}

TEST(WorkerLimits, InheritedFilesAreClosed) {
  const int inherited = open("/dev/null", O_RDONLY);
  ASSERT_GT(inherited, STDERR_FILENO);
  EXPECT_EQ(statusOf([inherited] {
              return fcntl(inherited, F_GETFD) < 0 && fcntl(STDOUT_FILENO, F_GETFD) >= 0;
            }),
            0);
  close(inherited);
}

TEST(WorkerLimits, ManyFilesAtOnceAreRefused) {
  EXPECT_EQ(statusOf([] {
              for (int i = 0; i < 100; ++i) {
                if (open("/dev/null", O_RDONLY) < 0) return i > 5;
              }
              return false;
            }),
            0);
}

TEST(WorkerLimits, NoPrivilegesAreGained) {
  EXPECT_EQ(statusOf([] { return prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1; }), 0);
}

TEST(WorkerLimits, NoProcessIsStarted) {
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    if (!becomeOrdinaryUser()) _exit(2);
    limitThisProcess({kMemory, kMemory}, 100, parent);
    const pid_t grandchild = fork();
    _exit(grandchild < 0 && errno == EAGAIN ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

/// From now on the kernel refuses this system call; false if it does not take orders.
bool forbid(unsigned call) {
  std::array<sock_filter, 4> filter{{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                                     BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1),
                                     BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
                                     BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog program{filter.size(), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
}

TEST(WorkerLimits, ALimitThatTheKernelRefusesIsAnError) {
  enum Outcome { kUnlimited, kError, kNoFilter };
  for (const unsigned call : {unsigned{SYS_prlimit64}, unsigned{SYS_prctl}}) {
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
      if (!forbid(call)) _exit(kNoFilter);
      try {
        limitThisProcess({kMemory, kMemory}, 100, parent);
        _exit(kUnlimited);
      } catch (const std::system_error& error) {
        _exit(error.code().value() == EPERM ? kError : kUnlimited);
      }
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kNoFilter) GTEST_SKIP() << "skipped: no filter of system calls";
    EXPECT_EQ(WEXITSTATUS(status), kError) << call;
  }
}

TEST(WorkerLimits, NoOrphanStarts) {
  const pid_t child = fork();
  if (child == 0) {
    limitThisProcess({kMemory, kMemory}, 100, getpid());  // which is not its parent
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(WorkerLimits, ItEndsWithItsParent) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t middle = fork();
  if (middle == 0) {
    const pid_t self = getpid();
    if (fork() == 0) {
      dup2(pipe_ends[1], STDOUT_FILENO);
      limitThisProcess({kMemory, kMemory}, 100, self);
      const ssize_t written = write(STDOUT_FILENO, "x", 1);
      for (;;)
        pause();
      _exit(static_cast<int>(written));
    }
    for (;;)
      pause();
  }
  close(pipe_ends[1]);
  char ready = 0;
  ASSERT_EQ(::read(pipe_ends[0], &ready, 1), 1);
  kill(middle, SIGKILL);
  waitpid(middle, nullptr, 0);
  pollfd end{pipe_ends[0], POLLIN, 0};
  EXPECT_EQ(poll(&end, 1, kDeadlineMilliseconds), 1) << "the orphan lives on";
  close(pipe_ends[0]);
}

}  // namespace
}  // namespace link_bounds
