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

# configure_sanitized FOLDER FLAGS [CMAKE_OPTION ...]: with our assertions, Eigen's and the standard
# library's. Only the tested code is checked for undefined behaviour; checking the tests, too, would
# double the time that they take to compile. As no program runs on after a report, the compiler need not
# prepare for that, which saves a quarter of its time. Nobody edits and compiles again here, so more
# sources are compiled together, and messages are generated for C++ and Python only.
configure_sanitized() {
  local folder=$1 flags=$2
  shift 2
  ROS_LANG_DISABLE=genlisp:geneus:gennodejs configure "$folder" -DCATKIN_ENABLE_TESTING=ON \
    -DCMAKE_BUILD_TYPE=None -DLINK_BOUNDS_WERROR=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 \
    -DCMAKE_CXX_FLAGS="-O1 -g1 -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer $flags \
      -fno-sanitize-recover=all" \
    -DLINK_BOUNDS_TEST_FLAGS=-fno-sanitize=undefined,float-cast-overflow "$@"
}

# The build for memory and undefined behaviour, also of the fuzzers, by clang, which takes two thirds of
# g++'s time. Only the geometry library is optimised more: what is checked is larger, so clang would call
# each of Eigen's small functions; with a higher limit the grids of a cloud filter take a third of the
# time. Everything else would take half as much time again to compile. The module for Python is left out,
# because no test loads it below a sanitizer; the coverage of the tests, because no fuzzer links them. g++
# itself defines the macro.
configure_memory() {
  install_what_exists fuzz
  configure_sanitized "$BUILD/sanitized" \
    "-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -D__SANITIZE_ADDRESS__" \
    -DLINK_BOUNDS_TEST_FLAGS=-fno-sanitize=undefined,float-cast-overflow,fuzzer-no-link \
    -DLINK_BOUNDS_GEOMETRY_FLAGS="-O2;SHELL:-mllvm -inline-threshold=1000" -DPYBIND11_INCLUDE=OFF \
    -DCMAKE_CXX_COMPILER="$(command -v clang++)" -DLINK_BOUNDS_FUZZERS=ON
}

# The build for threads, by g++: for what clang reports of roscpp, tsan.supp has no lines. It is the
# node that is tested, not the programs that call it.
configure_threads() {
  configure_sanitized "$BUILD/threads" -fsanitize=thread -DLINK_BOUNDS_LOAD_FLAGS=-fno-sanitize=thread
}
