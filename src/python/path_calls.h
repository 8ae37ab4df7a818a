// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Proofs about the motion between way points.
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <vector>

#include "python/shared_robot.h"
#include "robot/posed/path_prover.h"

namespace link_bounds {

/// What a user gives.
struct PathRequest {
  pybind11::object poses;
  pybind11::object velocities;     ///< or None, as the next four
  pybind11::object accelerations;  ///< as poses
  pybind11::object times;          ///< s
  pybind11::object objects;        ///< path of a file, see parseObjects()
  pybind11::object srdf;           ///< path of a file
  double clearance;                ///< m
  double budget;                   ///< s
  unsigned jobs;                   ///< threads; 0: one per core
};

struct Segment {
  std::size_t start;  ///< way point, from 0
  SegmentProof proof;
  std::string first;
  std::string second;
  std::map<std::string, double> pose;
};

/// One per way point but the last.
std::vector<Segment> checkPath(const SharedRobot& shared, const PathRequest& request);

}  // namespace link_bounds
