// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether this is a build with a sanitizer: slow, and it claims more addresses than a limit allows.
#pragma once

namespace link_bounds {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// How often a long random test repeats: builds with a sanitizer are about ten times slower.
constexpr int repetitions(int count) {
  return kIsSanitized ? count / 10 : count;
}

}  // namespace link_bounds
