// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts a thread, or says why it cannot be started.
#pragma once

#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace link_bounds {

/// Throws std::runtime_error with the name of the thread and a remedy.
template <class Body>
std::thread startThread(const std::string& name, Body&& body) {
  try {
    return std::thread(std::forward<Body>(body));
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot start the " + name + " thread: " + error.what() +
                             "; raise the limit of processes and threads");
  }
}

}  // namespace link_bounds
