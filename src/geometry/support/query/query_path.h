// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which instructions the queries use.
#pragma once

namespace link_bounds {

/// The best one of this processor is chosen at the first query.
enum class QueryPath { kPlain, kSse2, kAvx2, kNeon };
constexpr QueryPath kQueryPaths[] = {QueryPath::kPlain, QueryPath::kSse2, QueryPath::kAvx2,
                                     QueryPath::kNeon};

bool isSupported(QueryPath path);
QueryPath queryPath();

/// For tests and benchmarks; `path` must be supported.
void useQueryPath(QueryPath path);

}  // namespace link_bounds
