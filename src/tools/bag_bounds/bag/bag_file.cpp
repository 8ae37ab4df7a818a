// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/bag_file.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tools/bag_bounds/bag/records/record_bytes.h"

namespace link_bounds {
namespace {

constexpr std::string_view kVersionLine = kBagVersionLine;
constexpr std::uint64_t kStepsPerGlance = 256;       // between two checks for an interrupt
constexpr int kMaxLosses = 20;                       // lines for one file
constexpr std::uint64_t kNextHeaderSize = 512;       // bytes, typical
constexpr std::uint64_t kMaxSizeAtOnce = 64 << 10;   // bytes, as in record.cpp
constexpr std::uint64_t kMaxReadInVain = 256 << 20;  // bytes, in addition to twice the file
constexpr std::int64_t kMinJumpBack = 500'000'000;   // ns; messages that come late go back by less
const char* const kCopyAgain = "; copy it again from where it was recorded";

std::string bytesText(std::uint64_t begin, std::uint64_t end) {
  return "bytes " + std::to_string(begin) + " to " + std::to_string(end);
}

// Whether another record can begin after this one. If not, its length may be wrong.
bool canFollow(Bytes& bytes, const Record& record) {
  // Loads both records at once, unless they are large: a file has only one block in memory.
  const std::uint64_t size =
      std::min(record.data_size + kNextHeaderSize, bytes.size() - record.data);
  if (size <= kMaxSizeAtOnce) bytes.at(record.data, size);
  Record next;
  return record.end() == bytes.size() ||
         readRecord(bytes, record.end(), next) != RecordState::kDamaged;
}

// What is wrong with a chunk.
std::string textOf(ChunkState state) {
  switch (state) {
    case ChunkState::kTooLarge:
      return "are a chunk that is too large";
    case ChunkState::kUnknownCompression:
      return "are a chunk of an unknown compression";
    default:
      return "are a chunk with damaged data";
  }
}

}  // namespace

BagFile::BagFile(const std::string& name, std::unique_ptr<Bytes> bytes,
                 const std::set<std::string>& topics, std::vector<std::string>& losses,
                 ChunkThreads& threads, std::function<bool()> is_interrupted)
    : name_(name),
      bytes_(std::move(bytes)),
      losses_(losses),
      is_interrupted_(std::move(is_interrupted)),
      ahead_(threads),
      connections_(topics) {
  readVersion();
  readBagHeader();
}

void BagFile::readVersion() {
  if (bytes_->size() == 0) throw std::runtime_error(name_ + ": is empty; record it again");
  const std::size_t size = std::min<std::uint64_t>(kVersionLine.size(), bytes_->size());
  const std::uint8_t* const begin = bytes_->at(0, size);
  if (!begin) throw std::runtime_error(name_ + ": cannot be read");
  const std::string_view line(reinterpret_cast<const char*>(begin), size);
  if (line.substr(0, 9) == "#ROSBAG V" && line != kVersionLine && size == kVersionLine.size())
    throw std::runtime_error(name_ + ": is a bag of version " + std::string(line.substr(9, 3)) +
                             ", not 2.0; convert it: rosbag filter OLD.bag NEW.bag True");
  if (line != kVersionLine)
    throw std::runtime_error(name_ + ": is not a bag: its first line is not #ROSBAG V2.0");
  position_ = size;
}

void BagFile::readBagHeader() {
  Record record;
  if (readRecord(*bytes_, position_, record) != RecordState::kGood ||
      record.op != RecordOp::kBagHeader) {
    return;
  }
  if (!record.encryptor.empty() && record.encryptor != "rosbag/NoEncryptor")
    throw std::runtime_error(name_ + ": is encrypted; decrypt it: rosbag decrypt FILE.bag");
  has_header_ = true;
  index_position_ = record.index_position;
  chunk_count_ = record.chunk_count;
  position_ = record.end();
}

bool BagFile::next(BagMessage& message) {
  while (!is_at_end_ && !was_interrupted_) {
    if (step(message)) return true;
    if (++steps_ % kStepsPerGlance == 0) isInterrupted(position_);
  }
  return false;
}

/// After a backward jump of the clock, forgets later times, which say nothing about the end.
void BagFile::noteTime(const Record& record) {
  std::int64_t& last = last_times_.try_emplace(record.connection, record.time).first->second;
  const bool jumps_back = last > record.time + kMinJumpBack;
  last = record.time;
  for (auto known = last_times_.begin(); jumps_back && known != last_times_.end();)
    known = known->second > record.time ? last_times_.erase(known) : std::next(known);
}

std::int64_t BagFile::lastTime() const {
  std::int64_t last = std::numeric_limits<std::int64_t>::min();
  for (const auto& [connection, time] : last_times_)
    last = std::max(last, time);
  return last;
}

// The index does not cover the rest of this chunk, so its messages are read. The first message
// behind it is in the next chunk, which the index covers.
bool BagFile::goesBackTo(std::int64_t time) {
  const std::uint32_t chunk = chunks_;
  const bool is_later = isLaterByIndex(time, chunk);
  for (BagMessage message{}; (!is_later || chunks_ == chunk) && next(message);) {
    if (message.time <= time) return true;
  }
  return false;
}

// Whether the index shows that all wanted messages after the first `chunk` chunks are later than
// `time`: it has all chunks, and none of these has a wanted topic and a message of that time or
// earlier.
bool BagFile::isLaterByIndex(std::int64_t time, std::uint32_t chunk) {
  std::uint32_t infos = 0;
  Record record;
  for (std::uint64_t position = index_position_;
       position != 0 && readRecord(*bytes_, position, record) == RecordState::kGood;
       position = record.end()) {
    if (record.op == RecordOp::kConnection) connections_.add(*bytes_, record);
    if (record.op != RecordOp::kChunkInfo) continue;
    if (++infos > chunk && record.start_time <= time && hasWanted(record)) return false;
  }
  return infos == chunk_count_ && infos > 0;
}

// Whether a chunk may have wanted messages. `info` is its record in the index. A connection that is
// not announced may be wanted.
bool BagFile::hasWanted(const Record& info) {
  const std::uint8_t* const data =
      info.data_size > kMaxChunkSize ? nullptr : bytes_->at(info.data, info.data_size);
  for (std::uint32_t i = 0; data && i < info.count; ++i) {
    const Connection* const connection = connections_.find(connectionOfEntry(data, i));
    if (!connection || connection->is_wanted) return true;
  }
  return !data;
}

// Remains true once it was true.
bool BagFile::isInterrupted(std::uint64_t position) {
  looked_at_ = position;
  was_interrupted_ |= is_interrupted_();
  return was_interrupted_;
}

// Reads one record. Returns whether it is a wanted message.
bool BagFile::step(BagMessage& message) {
  const bool in_chunk = !chunk_.data.empty();
  Bytes& bytes = in_chunk ? static_cast<Bytes&>(chunk_) : *bytes_;
  std::uint64_t& position = in_chunk ? chunk_position_ : position_;
  Record record;
  bool is_message = false;
  if (position >= bytes.size()) {
    if (in_chunk) {
      chunk_.data.clear();
    } else {
      endOfFile();
    }
  } else {
    const RecordState state = readRecord(bytes, position, record);
    if (state != RecordState::kGood || !handle(bytes, record, message, is_message))
      in_chunk ? leaveDamagedChunk()
               : skipDamage("are damaged", state == RecordState::kCut, position + 1);
  }
  return is_message;
}

// Goes on to the next record. False if this one is damaged.
bool BagFile::handle(Bytes& bytes, const Record& record, BagMessage& message, bool& is_message) {
  const bool in_chunk = &bytes == &chunk_;
  if (record.op == RecordOp::kChunk) {
    if (in_chunk) return false;
    openChunk(record);
    return true;
  }
  if (record.op == RecordOp::kConnection && !connections_.add(bytes, record)) return false;
  if (!canFollow(bytes, record)) return false;  // invalidates the texts of the record
  if (record.op == RecordOp::kMessage && !handleMessage(bytes, record, message, is_message))
    return false;
  (in_chunk ? chunk_position_ : position_) = record.end();
  return true;
}

bool BagFile::handleMessage(Bytes& bytes, const Record& record, BagMessage& message,
                            bool& is_message) {
  const Connection* const connection = findConnection(record.connection);
  if (!connection) ++unannounced_;
  noteTime(record);
  if (!connection || !connection->is_wanted) return true;
  if (record.data_size > kMaxChunkSize) {
    lose(bytesText(position_, record.end()) + " are one message that is too large to be read");
    return true;
  }
  message.data = bytes.at(record.data, record.data_size);
  if (!message.data) return false;
  message.size = record.data_size;
  message.time = record.time;
  message.topic = &connection->topic;
  message.type = &connection->type;
  message.publisher = &connection->publisher;
  is_message = true;
  return true;
}

// The index at the end of the file announces all connections again.
const Connection* BagFile::findConnection(std::uint32_t number) {
  const Connection* const found = connections_.find(number);
  if (found || has_read_index_ || index_position_ == 0) return found;
  has_read_index_ = true;
  Record record;
  for (std::uint64_t position = index_position_;
       readRecord(*bytes_, position, record) == RecordState::kGood &&
       record.op == RecordOp::kConnection && connections_.add(*bytes_, record);) {
    position = record.end();
  }
  return connections_.find(number);
}

// The lengths in the header of the chunk are not trusted: the recorder writes them last. Compressed
// data shows its own end.
void BagFile::openChunk(const Record& record) {
  ++chunks_;
  if (record.compression == "none") {
    is_compressed_ = false;
    position_ = record.data;
    return;
  }
  const ChunkData chunk = unpack(std::string(record.compression), record.data, record.end());
  if (was_interrupted_) return;
  const std::uint64_t end = record.data + chunk.consumed;
  chunk_position_ = 0;
  is_chunk_cut_ = false;
  if (chunk.state != ChunkState::kUnknownCompression) is_compressed_ = true;
  if (chunk.state == ChunkState::kGood) {
    position_ = end;
    return;
  }
  // The data may contain further chunks, so they are searched there, but not without limit.
  read_in_vain_ += chunk.consumed;
  const bool again = read_in_vain_ < kMaxReadInVain + 2 * bytes_->size();
  skipDamage(textOf(chunk.state), chunk.state == ChunkState::kCut, again ? position_ + 1 : end);
  is_chunk_cut_ = chunk.state == ChunkState::kCut && position_ == bytes_->size();
  if (!is_chunk_cut_) chunk_.data.clear();
}

// `next`: where the record ends, if its length is right.
ChunkData BagFile::unpack(const std::string& compression, std::uint64_t begin, std::uint64_t next) {
  ahead_.plan(*bytes_, next);
  ChunkData chunk{ChunkState::kGood, 0};
  const auto waits = [this, begin] { return isInterrupted(begin); };
  if (ahead_.take(compression, begin, chunk_.data, chunk.consumed, waits) || was_interrupted_)
    return chunk;
  return decompress(compression, *bytes_, begin, chunk_.data,
                    [this](auto position) { return isInterrupted(position); });
}

void BagFile::leaveDamagedChunk() {
  chunk_.data.clear();
  if (!is_chunk_cut_)
    lose("the chunk before byte " + std::to_string(position_) +
         " is damaged: messages are missing" + kCopyAgain);
}

// A record that seems to be cut has only a wrong length if another record comes after it.
void BagFile::skipDamage(const std::string& what, bool is_cut, std::uint64_t next) {
  const std::uint64_t begin = position_;
  position_ = findRecord(*bytes_, next, is_compressed_,
                         [this](auto position) { return isInterrupted(position); });
  if (was_interrupted_) return;
  if (is_cut && position_ == bytes_->size()) {
    loseRest(begin);
  } else {
    lose(bytesText(begin, position_) + " " + what + ": messages are missing" + kCopyAgain);
  }
}

// A cut within the index is no loss, because no message is missing.
void BagFile::loseRest(std::uint64_t begin) {
  position_ = bytes_->size();
  if (index_position_ == 0 || begin < index_position_) loseEnd();
}

void BagFile::loseEnd() {
  if (has_header_ && index_position_ == 0)
    lose(
        "was not closed by its recorder: its last messages may be missing; end rosbag record with "
        "Ctrl-C and wait for it");
  else
    lose("was cut at byte " + std::to_string(bytes_->size()) + ": messages are missing" +
         kCopyAgain);
}

void BagFile::endOfFile() {
  is_at_end_ = true;
  if (unannounced_ > 0)
    lose(std::to_string(unannounced_) + " messages have no topic, because its record is lost" +
         kCopyAgain);
  if (loss_count_ > 0) return;
  if (!has_header_ || index_position_ == 0 || index_position_ > bytes_->size()) {
    loseEnd();
  } else if (chunks_ < chunk_count_) {
    lose("has " + std::to_string(chunks_) + " of its " + std::to_string(chunk_count_) +
         " chunks: messages are missing" + kCopyAgain);
  }
}

void BagFile::lose(const std::string& what) {
  if (++loss_count_ <= kMaxLosses) losses_.push_back(name_ + ": " + what);
  if (loss_count_ == kMaxLosses + 1) losses_.push_back(name_ + ": has more damage; not listed");
}

}  // namespace link_bounds
