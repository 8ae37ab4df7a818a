# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# How a build is made in which faults of memory or threads show, and how they are seen; to be sourced
# after common.sh.

# with_reports FOLDER COMMAND ...: rostest does not see the exit code of a node, so sanitizers write a
# file for each process with a fault. Beside ASan, libubsan cannot write one. It aborts, as a failed
# assertion does, and the other sanitizer reports that.
with_reports() {
  local log=log_path=$1/report
  shift
  LSAN_OPTIONS=suppressions=$REPO/scripts/lsan.supp:print_suppressions=0 \
    ASAN_OPTIONS=$log:handle_abort=1 \
    UBSAN_OPTIONS=$log:print_stacktrace=1:halt_on_error=1:abort_on_error=1 \
    TSAN_OPTIONS=$log:handle_abort=1:suppressions=$REPO/scripts/tsan.supp "$@"
}

# configure_sanitized FOLDER FLAGS. Assertions are on, those of Eigen and of the standard library, too.
# Undefined behaviour is looked for in what is tested; in the tests themselves that would double the
# time of compiling them.
configure_sanitized() {
  configure "$1" -DCATKIN_ENABLE_TESTING=ON -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="-O1 -g1 -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer $2" \
    -DLINK_BOUNDS_TEST_FLAGS=-fno-sanitize=undefined,float-cast-overflow
}
