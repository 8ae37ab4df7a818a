// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Proofs over joint ranges.
#pragma once

#include <pybind11/numpy.h>

#include "python/shared_robot.h"
#include "robot/pairs/pair_proofs.h"
#include "robot/reach/reach.h"

namespace link_bounds {

/// What a user gives for both proofs.
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

/// In the order of the links. A thread per `jobs`; 0: one per core.
std::vector<NamedProof> pairsOfRobot(const SharedRobot& shared, const ProofRequest& request,
                                     double clearance, double touching, bool adjacent,
                                     unsigned jobs);

/// Of a reach: [2, 3], in metres.
pybind11::array boxOf(const Reach& reach);
pybind11::array gapOf(const Reach& reach);

}  // namespace link_bounds
