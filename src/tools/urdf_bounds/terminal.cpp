// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines with the name of the program, and a bar of plain characters.
#include "tools/urdf_bounds/terminal.h"

#include <unistd.h>

#include <iostream>

#include "tools/text/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::size_t kBarWidth = 30;

void drawBar(std::size_t done, std::size_t total) {
  const std::size_t filled = kBarWidth * done / total;
  std::cerr << "\r[" << std::string(filled, '#') << std::string(kBarWidth - filled, ' ') << "] "
            << done << '/' << total << " meshes";
  if (done == total) std::cerr << "\r\033[K";
  std::cerr << std::flush;
}

}  // namespace

void say(const std::string& text) {
  std::cerr << "urdf_bounds: " << printable(text) << '\n';
}

void warn(const std::string& text) {
  say("warning: " + text);
}

LoadProgress progressBar() {
  return isatty(STDERR_FILENO) ? drawBar : LoadProgress();
}

}  // namespace link_bounds
