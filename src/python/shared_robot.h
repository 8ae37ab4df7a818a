// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot of the module: immutable, shared by threads, which borrow posed robots from it.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "python/interruptible.h"
#include "robot/posed/posed_robot.h"

namespace link_bounds {

struct RobotRequest {
  std::string text;         ///< URDF
  std::string base_folder;  ///< of relative mesh names
  Selection selection;
  std::map<std::string, std::string> packages;  ///< folders; others are found as rospack does
  bool allow_incomplete = false;
};

/// Any number of threads may use it.
class SharedRobot {
 public:
  /// Throws JointError, and RobotError, for losses with a line per lost element. Losses are only
  /// accepted if the request allows them and `stop` is not set.
  SharedRobot(const RobotRequest& request, const StopFlag& stop);

  SharedRobot(const SharedRobot&) = delete;
  SharedRobot& operator=(const SharedRobot&) = delete;

  const Robot& described() const { return robot_; }

  /// With simple joints.
  const Robot& robot() const { return simple_; }
  const BoundedRobot& bounded() const { return bounded_; }
  bool allowsIncomplete() const { return allow_incomplete_; }

  /// Emits one RuntimeWarning about links that have only geometry of the other kind. If Python
  /// makes it an exception, the next call emits it again. Call it with the GIL.
  void warnOfLeftOut() const;

  /// Indices of the joints that can be set: they move, and mimic no other one.
  const std::vector<std::size_t>& joints() const { return joints_; }

  /// Warnings about the description, and about its elements that could not be loaded.
  std::vector<std::string> warnings() const;

  /// Loads objects around the robot, with bodies. Meshes and losses are treated as those of the
  /// robot.
  BoundedRobot loadObjects(const Robot& objects, const std::string& base_folder,
                           const StopFlag& stop) const;

  struct GiveBack {
    SharedRobot* owner;

    void operator()(PosedRobot* posed) const;
  };
  using Borrowed = std::unique_ptr<PosedRobot, GiveBack>;

  /// A robot that nobody else uses until its end, where it is given back.
  Borrowed borrow();

 private:
  Robot robot_;
  Robot simple_;
  std::vector<std::size_t> joints_;
  bool allow_incomplete_;
  std::string left_out_;
  mutable bool said_left_out_ = false;  ///< guarded by the GIL
  std::map<std::string, std::string> packages_;
  BoundedRobot bounded_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PosedRobot>> idle_;  ///< guarded by mutex_
};

}  // namespace link_bounds
