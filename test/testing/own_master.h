// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A ROS master for one test executable, which becomes a node.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <ros/ros.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include "testing/patience.h"

namespace link_bounds {

class OwnMaster {
 public:
  /// Starts the master and the node. Callbacks are called by whoever serves the global queue.
  explicit OwnMaster(const std::string& node_name) {
    const std::string port = std::to_string(freePort());
    process_ = fork();
    if (process_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // also if the test crashes
      const int null = open("/dev/null", O_WRONLY);
      dup2(null, STDOUT_FILENO);
      dup2(null, STDERR_FILENO);
      execlp("rosmaster", "rosmaster", "--core", "-p", port.c_str(), nullptr);
      _exit(127);
    }
    ros::init(ros::M_string{{"__master", "http://localhost:" + port}, {"__hostname", "localhost"}},
              node_name, ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!ros::master::check()) {
      if (std::chrono::steady_clock::now() > deadline)
        throw std::runtime_error("the master does not answer");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ros::start();
  }
  ~OwnMaster() {
    ros::shutdown();
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  OwnMaster(const OwnMaster&) = delete;
  OwnMaster& operator=(const OwnMaster&) = delete;

 private:
  /// On which nobody listens. Linux gives ports from 32768 on to whoever asks for any, also between
  /// the choice and the start.
  static int freePort() {
    std::uniform_int_distribution<int> ports(20000, 31999);
    for (std::random_device random;;) {
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      address.sin_port = htons(static_cast<std::uint16_t>(ports(random)));
      const int probe = socket(AF_INET, SOCK_STREAM, 0);
      const bool is_free = bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
      close(probe);
      if (is_free) return ntohs(address.sin_port);
    }
  }

  pid_t process_ = 0;
};

/// Serves callbacks of the global queue until then, or until the deadline.
template <class Condition>
bool isServed(const Condition& condition) {
  return becomesTrue([&] {
    ros::spinOnce();
    return condition();
  });
}

}  // namespace link_bounds
