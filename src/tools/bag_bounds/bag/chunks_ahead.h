// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Unpacks compressed chunks on other threads before they are read.
//
// The reader takes only good chunks from here: they give the same bytes on any thread. It unpacks
// damaged, cut or very large ones itself and reports what is wrong with them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tools/bag_bounds/bag/records/bytes.h"
#include "tools/bag_bounds/bag/records/chunk.h"

namespace link_bounds {

/// The threads of one reader. All functions are called by the reader's own thread.
class ChunkThreads {
 public:
  struct Chunk {
    std::string compression;
    MemoryBytes input;
    std::vector<std::uint8_t> output;
    ChunkData data{ChunkState::kInterrupted, 0};
    std::size_t counted = 0;   ///< bytes of the output that output_size_ includes
    bool is_done = false;      ///< the members above then belong to the reader
    bool is_released = false;  ///< release() was called; guarded by mutex_, as is_done
  };
  using ChunkPtr = std::shared_ptr<Chunk>;

  /// The threads start with the first chunk. With fewer than two, no chunk is unpacked ahead.
  explicit ChunkThreads(unsigned threads) : wanted_(threads < 2 ? 0 : threads) {}
  ~ChunkThreads();
  ChunkThreads(const ChunkThreads&) = delete;
  ChunkThreads& operator=(const ChunkThreads&) = delete;

  /// Whether there is room for another chunk of a file that already has `chunks_of_file`.
  bool hasRoom(std::size_t chunks_of_file) const;

  /// Begins to unpack a chunk. Null if no thread could be started.
  ChunkPtr start(std::string_view compression, const std::uint8_t* data, std::size_t size);

  /// Waits until the chunk is done. False if `is_interrupted`, which is called regularly, is true.
  bool wait(const Chunk& chunk, const std::function<bool()>& is_interrupted);

  /// Call it once for each chunk that was started.
  void release(const ChunkPtr& chunk);

 private:
  void run();
  void unpack(Chunk& chunk);

  const unsigned wanted_;
  std::vector<std::thread> threads_;
  std::size_t chunks_ = 0;      ///< started and not released
  std::size_t input_size_ = 0;  ///< of these [bytes]
  std::atomic<std::size_t> output_size_{0};
  std::atomic<bool> is_over_{false};
  std::mutex mutex_;
  std::condition_variable is_waiting_;  ///< a chunk is in the queue
  std::condition_variable is_done_;
  std::deque<ChunkPtr> queue_;
};

/// The next chunks of one file.
class ChunksAhead {
 public:
  explicit ChunksAhead(ChunkThreads& threads) : threads_(threads) {}
  ~ChunksAhead();
  ChunksAhead(const ChunksAhead&) = delete;
  ChunksAhead& operator=(const ChunksAhead&) = delete;

  /// Begins to unpack chunks whose records begin at `position` or later.
  void plan(Bytes& bytes, std::uint64_t position);

  /// Gives the chunk whose data begins at `begin`, as decompress() does. False if it was not
  /// unpacked ahead, if it is not good, or if it was interrupted.
  bool take(std::string_view compression, std::uint64_t begin, std::vector<std::uint8_t>& output,
            std::uint64_t& consumed, const std::function<bool()>& is_interrupted);

 private:
  struct Planned {
    std::uint64_t begin;  ///< of the data, in the file
    ChunkThreads::ChunkPtr chunk;
  };

  ChunkThreads& threads_;
  std::deque<Planned> planned_;  ///< in the order of the file
  std::uint64_t position_ = 0;   ///< where to look for the next one
};

}  // namespace link_bounds
