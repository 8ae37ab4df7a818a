// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Has a fault that an assertion, ASan or UBSan must report: memory_faults
// vector|eigen|heap|overflow|none
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace {

volatile int three = 3;  // unknown to the compiler

/// Beyond the last number, but within the capacity: only the assertion of std::vector reports it.
int readVector() {
  std::vector<int> numbers{1, 2, 3};
  numbers.reserve(8);
  return numbers[static_cast<std::size_t>(three)];
}

/// Inside the matrix, but outside the block.
int readEigen() {
  const Eigen::Matrix4i numbers = Eigen::Matrix4i::Identity();
  return numbers.topRows<3>()(three, 0);
}

int readHeap() {
  const std::vector<int> numbers{1, 2, 3};
  return numbers.data()[three];
}

int overflow() {
  return std::numeric_limits<int>::max() - 2 + three;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "";
  volatile int result = 0;
  if (fault == "vector") result = readVector();
  if (fault == "eigen") result = readEigen();
  if (fault == "heap") result = readHeap();
  if (fault == "overflow") result = overflow();
  static_cast<void>(result);
  return 0;
}
