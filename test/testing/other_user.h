// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests often run as root, which may read everything.
#pragma once

#include <unistd.h>

namespace link_bounds {

/// While it lives, a process of root has the rights of nobody, and another process its own.
class OtherUser {
 public:
  OtherUser() : is_root_(geteuid() == 0 && seteuid(kNobody) == 0) {}
  OtherUser(const OtherUser&) = delete;
  OtherUser& operator=(const OtherUser&) = delete;
  ~OtherUser() {
    if (is_root_ && seteuid(0) != 0) _exit(1);
  }

 private:
  static constexpr uid_t kNobody = 65534;

  bool is_root_;
};

}  // namespace link_bounds
