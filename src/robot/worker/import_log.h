// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What assimp says against a file while it reads it, which it may accept all the same.
#pragma once

#include <string>
#include <vector>

namespace link_bounds {

/// While it lives, collects the errors that assimp logs on this thread. Not to be nested.
class ImportLog {
 public:
  ImportLog();
  ~ImportLog();
  ImportLog(const ImportLog&) = delete;
  ImportLog& operator=(const ImportLog&) = delete;

  /// The first error that contains `part`, or "".
  std::string errorWith(const std::string& part) const;

 private:
  std::vector<std::string> errors_;
};

}  // namespace link_bounds
