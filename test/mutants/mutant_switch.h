// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// mutants.py includes this in the sources that it changes.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>

/// LINK_BOUNDS_MUTANT is the number of the mutant that is on. LINK_BOUNDS_MUTANT_LOG is a file with
/// a byte for each mutant, which is set once a process reaches it. All processes of a test map the
/// same file, so that neither _exit, nor a signal, nor the limits of the mesh worker lose a mark.
class MutantSwitch {
 public:
  static constexpr std::size_t kMutants = 4096;

  static MutantSwitch& instance() {
    static MutantSwitch the_switch;
    return the_switch;
  }

  bool isOn(int mutant) {
    if (!marks_[mutant]) marks_[mutant] = 1;
    return mutant == on_;
  }

 private:
  MutantSwitch() {
    if (const char* number = std::getenv("LINK_BOUNDS_MUTANT")) on_ = std::atoi(number);
    const char* name = std::getenv("LINK_BOUNDS_MUTANT_LOG");
    const int file = name ? open(name, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) return;
    void* marks = mmap(nullptr, kMutants, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (marks != MAP_FAILED) marks_ = static_cast<char*>(marks);
    close(file);
  }

  int on_ = 0;
  char unshared_[kMutants] = {};
  volatile char* marks_ = unshared_;
};

/// Maps the file before main, while the process may still open files.
inline const MutantSwitch* const mutant_switch = &MutantSwitch::instance();

inline bool mutantOn(int mutant) {
  return MutantSwitch::instance().isOn(mutant);
}
