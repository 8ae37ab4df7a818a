// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The data of a compressed chunk.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tools/bag_bounds/bag/records/bytes.h"

namespace link_bounds {

enum class ChunkState {
  kGood,
  kCut,       ///< the input ends too early; what comes before that is in the output
  kDamaged,   ///< the output is empty
  kTooLarge,  ///< the output would be larger than a limit, and is empty
  kUnknownCompression,
  kInterrupted,  ///< the output is empty
};

struct ChunkData {
  ChunkState state;
  std::uint64_t consumed;  ///< bytes of the input; if damaged, all that were read
};

/// A chunk, and a single message, may have this many bytes; a larger one is not read. rosbag closes
/// a chunk with the first message after 768 kB.
constexpr std::uint32_t kMaxChunkSize = 256U << 20;

/// Decompresses the data at `begin` up to the end that it marks itself. Takes memory as the output
/// grows, not by the size in the header of the chunk. Calls `is_interrupted` for each piece.
ChunkData decompress(std::string_view compression, Bytes& bytes, std::uint64_t begin,
                     std::vector<std::uint8_t>& output, const IsInterrupted& is_interrupted);

}  // namespace link_bounds
