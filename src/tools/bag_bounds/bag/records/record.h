// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One record of a bag: http://wiki.ros.org/Bags/Format/2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "tools/bag_bounds/bag/records/bytes.h"

namespace link_bounds {

enum class RecordOp : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

/// The fields of a record's header. Fields that its kind does not have are 0 or empty. Texts are
/// views, valid until the next call of Bytes::at().
struct Record {
  RecordOp op{};
  std::uint32_t connection = 0;
  std::int64_t time = 0;        ///< [ns]
  std::int64_t start_time = 0;  ///< the earliest time in the chunk of a chunk info [ns]
  std::uint64_t index_position = 0;
  std::uint32_t chunk_count = 0;
  std::uint32_t count = 0;  ///< entries of an index or of a chunk info
  std::string_view topic;
  std::string_view compression;
  std::string_view encryptor;
  std::uint64_t data = 0;  ///< where the data begins
  std::uint32_t data_size = 0;

  std::uint64_t end() const { return data + data_size; }
};

enum class RecordState {
  kGood,
  kCut,      ///< the bytes end within the record
  kDamaged,  ///< no such record exists
};

/// Reads the header of the record at `offset`. A good record is complete, except that the data of a
/// chunk may be cut.
RecordState readRecord(Bytes& bytes, std::uint64_t offset, Record& record);

/// The position of the first good record from `offset` on; the size of the bytes if there is none.
/// Records inside of chunks count only if chunks are not compressed: parts of compressed data look
/// like records. If it is interrupted, returns the position reached.
std::uint64_t findRecord(Bytes& bytes, std::uint64_t offset, bool is_compressed,
                         const IsInterrupted& is_interrupted);

/// The connection in an entry of a chunk info; `data` is the data of that record.
std::uint32_t connectionOfEntry(const std::uint8_t* data, std::uint32_t entry);

/// The header of a connection, which is the data of its record.
struct ConnectionHeader {
  std::string_view type;
  std::string_view publisher;
};

/// False if it is damaged.
bool readConnectionHeader(const std::uint8_t* data, std::uint32_t size, ConnectionHeader& header);

}  // namespace link_bounds
