// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/records/record.h"

#include <algorithm>
#include <cstring>

namespace link_bounds {
namespace {

constexpr std::uint32_t kMaxHeaderSize = 64 << 10;  // bytes; rosbag writes less than 1 kB
constexpr int kMaxFields = 16;                      // rosbag writes up to 6
constexpr std::uint32_t kNanoseconds = 1000000000;
constexpr std::uint64_t kChunkInfoEntrySize = 8;  // a connection and how many messages it has

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "bags are little-endian, but roscpp sends numbers as they are in memory");

template <class Number>
Number numberAt(const char* bytes) {  // as written by a little-endian machine
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

std::uint32_t sizeAt(const std::uint8_t* bytes) {
  return numberAt<std::uint32_t>(reinterpret_cast<const char*>(bytes));
}

// Calls handle(name, value) for each field until it returns false. True if all fields are
// well-formed and handle() has always returned true.
template <class Handler>
bool forEachField(const std::uint8_t* data, std::uint32_t size, Handler handle) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  for (int i = 0; i < kMaxFields && !rest.empty(); ++i) {
    if (rest.size() < sizeof(std::uint32_t)) return false;
    const auto length = numberAt<std::uint32_t>(rest.data());
    rest.remove_prefix(sizeof length);
    if (length > rest.size()) return false;
    const std::string_view field = rest.substr(0, length);
    const std::size_t name_size = field.find('=');
    if (name_size == std::string_view::npos) return false;
    if (!handle(field.substr(0, name_size), field.substr(name_size + 1))) return false;
    rest.remove_prefix(length);
  }
  return rest.empty();
}

template <class Number>
bool isNumber(std::string_view value, Number& number) {
  if (value.size() != sizeof number) return false;
  number = numberAt<Number>(value.data());
  return true;
}

bool isText(std::string_view value, std::string_view& text) {
  text = value;
  return !value.empty();
}

bool isTime(std::string_view value, std::int64_t& time) {
  if (value.size() != 8) return false;
  const auto seconds = numberAt<std::uint32_t>(value.data());
  const auto nanoseconds = numberAt<std::uint32_t>(value.data() + 4);
  time = std::int64_t{seconds} * kNanoseconds + nanoseconds;
  return nanoseconds < kNanoseconds;
}

// One bit for each field that has been seen in a header.
enum Field : unsigned {
  kOp = 1,
  kConn = 2,
  kTime = 4,
  kTopic = 8,
  kCompression = 16,
  kSize = 32,
  kVersion = 64,
  kCount = 128,
  kIndexPosition = 256,
  kChunkCount = 512
};

unsigned needed(RecordOp op) {
  switch (op) {
    case RecordOp::kMessage:
      return kOp | kConn | kTime;
    case RecordOp::kBagHeader:
      return kOp | kIndexPosition | kChunkCount;
    case RecordOp::kIndex:
      return kOp | kVersion | kConn | kCount;
    case RecordOp::kChunk:
      return kOp | kCompression | kSize;
    case RecordOp::kChunkInfo:
      return kOp | kVersion | kCount;
    case RecordOp::kConnection:
      return kOp | kConn | kTopic;
  }
  return ~0U;
}

// Fields of other names are allowed, as the format says.
bool takeField(std::string_view name, std::string_view value, Record& record, unsigned& seen) {
  std::uint32_t ignored = 0;
  const auto take = [&seen](Field field, bool is_good) {
    seen |= field;
    return is_good;
  };
  if (name == "op") return take(kOp, isNumber(value, record.op));
  if (name == "conn") return take(kConn, isNumber(value, record.connection));
  if (name == "time") return take(kTime, isTime(value, record.time));
  if (name == "start_time") return isTime(value, record.start_time);
  if (name == "size") return take(kSize, isNumber(value, ignored));
  if (name == "ver") return take(kVersion, isNumber(value, ignored));
  if (name == "count") return take(kCount, isNumber(value, record.count));
  if (name == "chunk_count") return take(kChunkCount, isNumber(value, record.chunk_count));
  if (name == "index_pos") return take(kIndexPosition, isNumber(value, record.index_position));
  if (name == "topic") return take(kTopic, isText(value, record.topic));
  if (name == "compression") return take(kCompression, isText(value, record.compression));
  if (name == "encryptor") record.encryptor = value;
  return true;
}

bool fitsCount(const Record& record) {
  constexpr std::uint64_t kIndexEntrySize = 12;  // a time and where the message is in the chunk
  if (record.op == RecordOp::kIndex) return record.data_size == record.count * kIndexEntrySize;
  if (record.op == RecordOp::kChunkInfo)
    return record.data_size == record.count * kChunkInfoEntrySize;
  return true;
}

bool isOutsideOfChunks(RecordOp op) {
  return op == RecordOp::kChunk || op == RecordOp::kIndex || op == RecordOp::kChunkInfo;
}

}  // namespace

std::uint32_t connectionOfEntry(const std::uint8_t* data, std::uint32_t entry) {
  return sizeAt(data + entry * kChunkInfoEntrySize);
}

RecordState readRecord(Bytes& bytes, std::uint64_t offset, Record& record) {
  const std::uint8_t* const length = bytes.at(offset, 4);
  if (!length) return RecordState::kCut;
  const std::uint32_t header_size = sizeAt(length);
  if (header_size > kMaxHeaderSize) return RecordState::kDamaged;
  const std::uint8_t* const header = bytes.at(offset + 4, header_size + 4);
  if (!header) return RecordState::kCut;
  record = Record();
  unsigned seen = 0;
  const bool is_good = forEachField(header, header_size, [&](auto name, auto value) {
    return takeField(name, value, record, seen);
  });
  const unsigned all = needed(record.op);
  if (!is_good || (seen & all) != all) return RecordState::kDamaged;
  record.data_size = sizeAt(header + header_size);
  record.data = offset + 4 + header_size + 4;
  if (!fitsCount(record)) return RecordState::kDamaged;
  const bool is_there = record.op == RecordOp::kChunk || record.end() <= bytes.size();
  return is_there ? RecordState::kGood : RecordState::kCut;
}

// Each header has the field op, which rosbag writes among the first ones.
std::uint64_t findRecord(Bytes& bytes, std::uint64_t offset, bool is_compressed,
                         const IsInterrupted& is_interrupted) {
  constexpr char kOpField[] = "\x04\0\0\0op=";
  constexpr std::size_t kFieldSize = sizeof kOpField - 1;
  constexpr std::size_t kPieceSize = 64 << 10;
  constexpr std::uint64_t kMaxFieldsBefore = 64;  // bytes
  Record record;
  std::uint64_t position = offset;
  while (position + kFieldSize <= bytes.size()) {
    if (is_interrupted(position)) return position;
    const std::size_t size = std::min<std::uint64_t>(kPieceSize, bytes.size() - position);
    const std::uint8_t* const block = bytes.at(position, size);
    if (!block) break;
    const void* const found = memmem(block, size, kOpField, kFieldSize);
    if (!found) {
      position += size - std::min(size, kFieldSize - 1);
      if (size < kPieceSize) break;
      continue;
    }
    position += static_cast<std::uint64_t>(static_cast<const std::uint8_t*>(found) - block);
    for (std::uint64_t before = 4; before <= kMaxFieldsBefore; ++before) {
      if (position < offset + before) break;
      if (readRecord(bytes, position - before, record) == RecordState::kGood &&
          (!is_compressed || isOutsideOfChunks(record.op)))
        return position - before;
    }
    ++position;
  }
  return bytes.size();
}

bool readConnectionHeader(const std::uint8_t* data, std::uint32_t size, ConnectionHeader& header) {
  return forEachField(data, size, [&](auto name, auto value) {
    if (name == "type") header.type = value;
    if (name == "callerid") header.publisher = value;
    return true;
  });
}

}  // namespace link_bounds
