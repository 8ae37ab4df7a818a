// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A child process, started without a shell and read through a pipe.
#pragma once

#include <sys/types.h>

#include <array>
#include <string>
#include <vector>

#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

/// A pipe from the standard output of a child process to this process.
class Pipe {
 public:
  /// Throws std::system_error.
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writingEnd() const { return end_[1]; }
  void closeWritingEnd();

  /// Fills `out` and returns the number of bytes, fewer than `wanted` only at the end. Calls
  /// `check_interrupt` at least every 20 ms.
  std::size_t read(void* out, std::size_t wanted, const CheckInterrupt& check_interrupt);

  /// True once the writing end is closed in all processes and everything has been read.
  bool hasEnded() const { return has_ended_; }

 private:
  std::array<int, 2> end_{-1, -1};
  bool has_ended_ = false;
};

class ChildProcess {
 public:
  /// The first argument is the absolute path of the program. Its standard output goes to the given
  /// descriptor; its standard input and error are /dev/null. Signals of the terminal do not reach
  /// it. Throws std::system_error.
  ChildProcess(std::vector<std::string> arguments, int standard_output);

  ~ChildProcess() { end(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits until the process ends, and kills those that it has started. Returns the signal that
  /// ended it, or 0.
  int waitForSignal(const CheckInterrupt& check_interrupt);

  /// Kills the process and those that it has started. Returns false if it does not end within 2 s,
  /// for example because it waits for a file system that does not answer. A later ChildProcess
  /// waits for it when it starts.
  bool end();

 private:
  pid_t pid_ = 0;  ///< 0 once it has ended or could not be killed
};

}  // namespace link_bounds
