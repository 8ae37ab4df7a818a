// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines with the name of the program, and a bar of plain characters.
#include "tools/command_line/terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include "tools/command_line/outcome.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::size_t kBarWidth = 30;

/// Opens closed standard descriptors on /dev/null. Otherwise the next file that is opened would get
/// the number of standard error, and warnings would be written into that file. Standard output is
/// opened read-only, so that writing to it still fails.
void holdStandardDescriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) == -1)
      open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void drawMeshes(std::size_t done, std::size_t total) {
  drawBar(done, total, "meshes");
  if (done == total) eraseBar();
}

}  // namespace

void say(const std::string& text) {
  std::cerr << program_invocation_short_name << ": " << printable(text) << '\n';
}

void warn(const std::string& text) {
  say("warning: " + text);
}

void drawBar(std::size_t done, std::size_t total, const std::string& unit) {
  const std::size_t filled = kBarWidth * done / total;
  std::cerr << "\r[" << std::string(filled, '#') << std::string(kBarWidth - filled, ' ') << "] "
            << done << '/' << total << ' ' << unit << std::flush;
}

void eraseBar() {
  std::cerr << "\r\033[K" << std::flush;
}

bool hasTerminal() {
  return isatty(STDERR_FILENO) != 0;
}

LoadProgress progressBar() {
  return hasTerminal() ? drawMeshes : LoadProgress();
}

int runProgram(const std::function<int()>& program) {
  holdStandardDescriptors();
  // With these signals ignored, writing to a closed pipe, or beyond the largest file that `ulimit
  // -f` allows, is an error, which is reported.
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal(signal, SIG_IGN);
  try {
    return program();
  } catch (const std::bad_alloc&) {
    say("error: out of memory");
  } catch (const std::exception& error) {
    say(std::string("error: ") + error.what() + "; see " + program_invocation_short_name +
        " --help");
  }
  return kUnusable;
}

bool finishOutput() {
  if (std::cout.flush()) return true;
  say("error: cannot write to standard output");
  return false;
}

}  // namespace link_bounds
