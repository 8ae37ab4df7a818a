// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Keeps a worker busy.
#pragma once

#include <future>

#include "node/threads/worker.h"
#include "testing/patience.h"

namespace link_bounds {

/// Keeps a worker busy until open() or the end of the test.
class Gate {
 public:
  explicit Gate(Worker& worker) {
    std::promise<void> begun;
    worker.post("gate", [this, &begun] {
      begun.set_value();
      opened_.get_future().wait_for(deadline());
    });
    valueOf(begun.get_future());
  }
  void open() { opened_.set_value(); }

 private:
  std::promise<void> opened_;
};

}  // namespace link_bounds
