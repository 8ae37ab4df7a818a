// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The messages of one bag, read from its begin to its end.
//
// In uncompressed chunks, only the records inside are read: the header of the chunk is not needed,
// so one that was never completed does no harm. A compressed chunk is decompressed into memory.
// After damage, reading goes on at the next record.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "tools/bag_bounds/bag/bag_reader.h"
#include "tools/bag_bounds/bag/chunks_ahead.h"
#include "tools/bag_bounds/bag/connections.h"
#include "tools/bag_bounds/bag/records/bytes.h"
#include "tools/bag_bounds/bag/records/record.h"

namespace link_bounds {

class BagFile {
 public:
  /// `name` is for messages. Throws std::runtime_error if `bytes` are no bag that can be read. All
  /// references must outlive this.
  BagFile(
      const std::string& name, std::unique_ptr<Bytes> bytes, const std::set<std::string>& topics,
      std::vector<std::string>& losses, ChunkThreads& threads,
      std::function<bool()> is_interrupted = [] { return false; });

  /// The next message; false after the last one, or if interrupted.
  bool next(BagMessage& message);

  /// The latest of the last times of all connections [ns], without times before a backward jump.
  std::int64_t lastTime() const;

  /// Whether a later message has this time or an earlier one. Uses the index if there is one, and
  /// reads as far as necessary: next() must not be called any more.
  bool goesBackTo(std::int64_t time);

  /// How far the file has been read [bytes], also within a compressed chunk.
  std::uint64_t position() const { return std::max(position_, looked_at_); }
  std::uint64_t size() const { return bytes_->size(); }

 private:
  bool isInterrupted(std::uint64_t position);
  void readVersion();
  void readBagHeader();
  bool step(BagMessage& message);
  bool handle(Bytes& bytes, const Record& record, BagMessage& message, bool& is_message);
  bool handleMessage(Bytes& bytes, const Record& record, BagMessage& message, bool& is_message);
  void noteTime(const Record& record);
  const Connection* findConnection(std::uint32_t number);
  void openChunk(const Record& record);
  ChunkData unpack(const std::string& compression, std::uint64_t begin, std::uint64_t next);
  void leaveDamagedChunk();
  void skipDamage(const std::string& what, bool is_cut, std::uint64_t next);
  void loseRest(std::uint64_t begin);
  void loseEnd();
  void endOfFile();
  bool isLaterByIndex(std::int64_t time, std::uint32_t chunk);
  bool hasWanted(const Record& info);
  void lose(const std::string& what);

  std::string name_;
  std::unique_ptr<Bytes> bytes_;
  std::vector<std::string>& losses_;
  std::function<bool()> is_interrupted_;
  bool was_interrupted_ = false;
  std::uint64_t looked_at_ = 0;  ///< position in the file at the last check for an interrupt
  std::uint64_t steps_ = 0;
  int loss_count_ = 0;
  std::uint64_t position_ = 0;  ///< in the file
  bool is_at_end_ = false;
  ChunksAhead ahead_;
  MemoryBytes chunk_;  ///< the current one, decompressed; empty if there is none
  std::uint64_t chunk_position_ = 0;
  bool is_chunk_cut_ = false;
  std::uint64_t read_in_vain_ = 0;  ///< compressed data that was damaged [bytes]
  bool is_compressed_ = true;       ///< the last chunk was, or there was none yet
  Connections connections_;
  std::unordered_map<std::uint32_t, std::int64_t> last_times_;  ///< by connection
  std::uint64_t unannounced_ = 0;     ///< messages of connections that the bag does not announce
  bool has_header_ = false;           ///< the next two are known
  std::uint64_t index_position_ = 0;  ///< 0: the recorder did not close the file
  std::uint32_t chunk_count_ = 0;
  std::uint32_t chunks_ = 0;  ///< read so far
  bool has_read_index_ = false;
};

}  // namespace link_bounds
