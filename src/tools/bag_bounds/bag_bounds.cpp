// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads recorded transforms and prints extremes, entries into zones and distances.
#include <ros/console.h>

#include <iostream>
#include <optional>
#include <utility>

#include "tools/bag_bounds/lines/each_bag.h"
#include "tools/bag_bounds/run/bag_run.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {

namespace {

/// Prints what the node would log as a warning of this program, unless it is below WARN.
void printLog(void*, ros::console::Level level, const char* text, const char*, const char*, int) {
  if (level >= ros::console::levels::Warn) warn(text);
}

/// A bar that is drawn only when its percentage changes, and erased at the end.
BagRun::OnProgress drawnProgress() {
  if (!hasTerminal()) return [](double) {};
  return [shown = std::optional<std::size_t>()](double share) mutable {
    if (share >= 1) {
      if (std::exchange(shown, std::nullopt)) eraseBar();
      return;
    }
    const auto percent = static_cast<std::size_t>(100 * share);
    if (std::exchange(shown, percent) != percent) drawBar(percent, 100, "% of the bags");
  };
}

int runOne(const BagBoundsOptions& options, BagQuestion& question) {
  BagRun run(options, question, drawnProgress());
  run.read();
  BagReport report = run.report();
  const Outcome outcome = run.outcome(report);
  report.open = outcome.open;
  write(report, options.format, std::cout);
  return exitCode(outcome, options.demand);
}

int run(const BagBoundsOptions& options) {
  ros::console::initialize();
  ros::console::backend::function_print = printLog;
  catchInterrupts();
  if (options.merge) return writeMerged(options, std::cout);
  BagQuestion question(options);
  return options.each ? runEach(options, question) : runOne(options, question);
}

int runWith(int argc, char** argv) {
  const BagBoundsOptions options = parseOptions(argc, argv);
  int code = 0;
  if (options.help || options.version) {
    std::cout << (options.help ? kUsage : "bag_bounds " LINK_BOUNDS_VERSION "\n");
  } else {
    code = run(options);
  }
  return finishOutput() ? code : kUnusable;
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::runProgram([&] { return link_bounds::runWith(argc, argv); });
}
