// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A program that runs for us: started without a shell, read through a pipe, never left behind.
#pragma once

#include <sys/types.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace link_bounds {

/// Throws when it is time to give up.
using CheckPatience = std::function<void()>;

/// From the standard output of a child process to us.
class Pipe {
 public:
  /// Throws std::system_error.
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writingEnd() const { return end_[1]; }
  void closeWritingEnd();

  /// Fills `out` and returns how many bytes came, fewer than `wanted` only at the end. Asks
  /// `check_patience` every 20 ms.
  std::size_t read(void* out, std::size_t wanted, const CheckPatience& check_patience);

  /// True once everybody has closed the writing end and all has been read.
  bool hasEnded() const { return has_ended_; }

 private:
  std::array<int, 2> end_{-1, -1};
  bool has_ended_ = false;
};

class ChildProcess {
 public:
  /// The first argument is the absolute path of the program. Its standard output goes to the given
  /// descriptor, its standard input and error nowhere; it takes no signal of our terminal. Throws
  /// std::system_error.
  ChildProcess(std::vector<std::string> arguments, int standard_output);

  ~ChildProcess() { end(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for its end, and ends what it has started; the signal that ended it, or 0.
  int waitForSignal(const CheckPatience& check_patience);

  /// Kills it, if it still runs, and what it has started. False if it does not end for seconds, as
  /// while it waits for a file system that does not answer: it is then waited for when the next one
  /// starts.
  bool end();

 private:
  pid_t pid_ = 0;  ///< 0 once it has ended or is given up
};

}  // namespace link_bounds
