# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds that report faults of memory or threads, and how to collect the reports; to be sourced
# after common.sh.

# with_reports FOLDER COMMAND ...: sanitizers write a file for each process with a fault, because
# rostest does not see the exit code of a node. In a build with ASan, UBSan cannot write a file. It
# aborts, as a failed assertion does, and ASan reports the abort.
with_reports() {
  local log=log_path=$1/report
  shift
  LSAN_OPTIONS=suppressions=$REPO/scripts/lsan.supp:print_suppressions=0 \
    ASAN_OPTIONS=$log:handle_abort=1 \
    UBSAN_OPTIONS=$log:print_stacktrace=1:halt_on_error=1:abort_on_error=1 \
    TSAN_OPTIONS=$log:handle_abort=1:suppressions=$REPO/scripts/tsan.supp "$@"
}

# configure_sanitized FOLDER KIND FLAGS: with our assertions, Eigen's and the standard library's, by
# clang, which takes two thirds of g++'s time. KIND is ADDRESS or THREAD; g++ itself defines the macro
# of that name. Only the tested code is checked for undefined behaviour; checking the tests, too, would
# double the time that they take to compile. As no program runs on after a report, the compiler need not
# prepare for that, which saves a quarter of its time.
configure_sanitized() {
  install_what_exists fuzz
  configure "$1" -DCATKIN_ENABLE_TESTING=ON -DCMAKE_BUILD_TYPE=None -DLINK_BOUNDS_WERROR=ON \
    -DCMAKE_CXX_COMPILER=clang++ -DLINK_BOUNDS_FUZZERS=ON \
    -DCMAKE_CXX_FLAGS="-O1 -g1 -D_GLIBCXX_ASSERTIONS -D__SANITIZE_$2__ -fno-omit-frame-pointer $3 \
      -fno-sanitize-recover=all" \
    -DLINK_BOUNDS_TEST_FLAGS=-fno-sanitize=undefined,float-cast-overflow
}

# The build for memory and undefined behaviour, also of the fuzzers.
configure_memory() {
  configure_sanitized "$BUILD/sanitized" ADDRESS \
    -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow
}
