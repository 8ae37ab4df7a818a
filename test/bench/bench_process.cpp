// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The processes that the scripts start: bench_process NAME WORD ... Without the peers of the
// program bench, which would take memory in each of them.
#include <ros/init.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <sstream>

#include "bench/common/processes.h"

namespace link_bounds::bench {
namespace {

struct Process {
  const char* name;
  const char* words;  ///< their names; if the first is in brackets, any number
  void (*run)(const Words& words);
  bool is_node = false;
};

constexpr Process kProcesses[] = {
    {"relay", "[BOXES [TOPIC BYTES HZ] ...]", runRelay, true},
    {"stopwatch", "NAMESPACE PID boxes|markers LINKS DEPTH HZ SECONDS", runStopwatch, true},
    {"usual_tf2", "boxes|markers", runUsualTf2, true},
    {"service_client", "LINKS DEPTH HZ REPETITIONS CALLS", runServiceClient, true},
    {"empty_service", "", runEmptyService, true},
    {"bag_made", "BAG LINKS SECONDS", makeBag},
    {"pairs_sampled", "FILE.urdf POSES visual|collision", samplePairs},
    {"rows_posed", "FILE.urdf VALUES BOXES DISTANCES LIMIT", poseRows}};

bool fits(const Process& process, const Words& words) {
  if (process.words[0] == '[') return true;
  std::istringstream names(process.words);
  const std::istream_iterator<std::string> begin(names), end;
  return static_cast<std::size_t>(std::distance(begin, end)) == words.size();
}

void printUsage() {
  for (const Process& process : kProcesses)
    std::cout << "usage: bench_process " << process.name << " " << process.words << "\n";
}

/// ROS takes its own arguments out.
int run(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "--help";
  const auto process =
      std::find_if(std::begin(kProcesses), std::end(kProcesses),
                   [&](const Process& candidate) { return candidate.name == name; });
  if (process != std::end(kProcesses)) {
    if (process->is_node) ros::init(argc, argv, name, ros::init_options::AnonymousName);
    const Words words(argv + 2, argv + argc);
    if (fits(*process, words)) {
      process->run(words);
      return 0;
    }
  }
  printUsage();
  return name == "--help" ? 0 : 1;
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  return link_bounds::bench::run(argc, argv);
} catch (const std::exception& error) {
  std::cerr << "bench_process " << argv[1] << ": " << error.what() << "\n";
  return 1;
}
