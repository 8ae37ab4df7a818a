// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the scripts start as processes of their own: nodes beside ours, what computes the same as a
// program of ours, and the maker of bags.
#pragma once

#include <string>
#include <vector>

namespace link_bounds::bench {

/// The words after the name of the process.
using Words = std::vector<std::string>;

void runRelay(const Words& words);
void runStopwatch(const Words& words);
void runUsualTf2(const Words& words);
void runServiceClient(const Words& words);
void runEmptyService(const Words& words);

void makeBag(const Words& words);
void samplePairs(const Words& words);
void poseRows(const Words& words);

}  // namespace link_bounds::bench
