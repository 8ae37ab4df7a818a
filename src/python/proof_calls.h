// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Proofs over joint ranges, and about the motion between way points.
#pragma once

#include <pybind11/numpy.h>

#include <map>
#include <string>
#include <vector>

#include "python/shared_robot.h"
#include "robot/pairs/pair_proofs.h"
#include "robot/posed/path_prover.h"
#include "robot/reach/reach.h"

namespace link_bounds {

/// Arguments that reach() and pairs() have in common.
struct ProofRequest {
  pybind11::object ranges;  ///< see givenRanges
  double accuracy;          ///< m
  double budget;            ///< s
  bool fixed_base;          ///< floating and planar joints of the root stay at 0
};

/// A dict from names of links to Reach.
pybind11::dict reachOfRobot(const SharedRobot& shared, const ProofRequest& request);

struct NamedProof {
  std::string first;
  std::string second;
  PairProof proof;
};

/// Pairs in the order of the links. `jobs` threads; 0: one per core.
std::vector<NamedProof> pairsOfRobot(const SharedRobot& shared, const ProofRequest& request,
                                     double clearance, double touching, bool adjacent,
                                     unsigned jobs);

/// An array [2, 3] of the box of a reach, and of its gaps [m].
pybind11::array boxOf(const Reach& reach);
pybind11::array gapOf(const Reach& reach);

/// Arguments of check_path().
struct PathRequest {
  pybind11::object poses;
  pybind11::object velocities;     ///< or None, as the next four
  pybind11::object accelerations;  ///< in the same forms as poses
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
