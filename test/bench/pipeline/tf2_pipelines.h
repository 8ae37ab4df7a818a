// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The node's computation on tf2's storage: the least that a node would do that keeps transforms
// as tf2 does, composes poses once per edge as ours, and computes our boxes. It does not look for
// late transforms, other parents or stale edges.
#pragma once

#include <memory>

#include "bench/pipeline/pipelines.h"

namespace link_bounds::bench {

/// tf2::BufferCore: fed and asked for each edge by the names of its frames.
std::unique_ptr<Pipeline> makeBufferCorePipeline(const TfRobot& robot, const Model& model);

/// tf2::TimeCache per edge, fed from our reading of the message with our numbers of frames.
std::unique_ptr<Pipeline> makeTimeCachePipeline(const TfRobot& robot, const Model& model);

}  // namespace link_bounds::bench
