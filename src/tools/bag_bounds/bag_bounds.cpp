// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From recorded transforms to extremes, entries and distances on standard output.
#include <ros/console.h>

#include <iostream>

#include "tools/bag_bounds/bag_run.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {

namespace {

/// What the node would log becomes a line of this program.
void printLog(void*, ros::console::Level level, const char* text, const char*, const char*, int) {
  if (level >= ros::console::levels::Warn) warn(text);
}

int run(const BagBoundsOptions& options) {
  ros::console::initialize();
  ros::console::backend::function_print = printLog;
  catchInterrupts();
  BagRun run(options);
  run.read();
  const BagReport report = run.report();
  write(report, options.format, std::cout);
  const int code = exitCode(run.outcome(report), options.demand);
  return finishOutput() ? code : kUnusable;
}

int runWith(int argc, char** argv) {
  const BagBoundsOptions options = parseOptions(argc, argv);
  if (!options.help && !options.version) return run(options);
  std::cout << (options.help ? kUsage : "bag_bounds " LINK_BOUNDS_VERSION "\n");
  return finishOutput() ? 0 : kUnusable;
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::runProgram([&] { return link_bounds::runWith(argc, argv); });
}
