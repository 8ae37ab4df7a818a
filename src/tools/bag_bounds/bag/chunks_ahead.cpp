// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/chunks_ahead.h"

#include <chrono>
#include <exception>
#include <system_error>

#include "tools/bag_bounds/bag/records/record.h"

namespace link_bounds {
namespace {

constexpr std::size_t kPerThread = 2;           // chunks, so that no thread waits for the reader
constexpr std::size_t kMaxInput = 64U << 20;    // bytes of all chunks
constexpr std::size_t kMaxOutput = 256U << 20;  // bytes of all chunks
constexpr std::size_t kMaxChunkInput = 16U << 20;
constexpr int kRecordsAtOnce = 10'000;            // read by one plan(), chunks and others
constexpr std::chrono::milliseconds kGlance{20};  // between two checks for an interrupt

}  // namespace

ChunkThreads::~ChunkThreads() {
  is_over_ = true;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.clear();
  }
  is_waiting_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

/// Always allows one chunk per file, so that a file that waits does not stop the others.
bool ChunkThreads::hasRoom(std::size_t chunks_of_file) const {
  const bool is_full = chunks_ >= kPerThread * wanted_ || input_size_ >= kMaxInput;
  return wanted_ > 0 && (chunks_of_file == 0 || !is_full);
}

ChunkThreads::ChunkPtr ChunkThreads::start(std::string_view compression, const std::uint8_t* data,
                                           std::size_t size) {
  try {
    while (threads_.size() < wanted_)
      threads_.emplace_back([this] { run(); });
  } catch (const std::system_error&) {  // the system allows no more threads
    if (threads_.empty()) return nullptr;
  }
  auto chunk = std::make_shared<Chunk>();
  chunk->compression = compression;
  chunk->input.data.assign(data, data + size);
  ++chunks_;
  input_size_ += size;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.push_back(chunk);
  }
  is_waiting_.notify_one();
  return chunk;
}

bool ChunkThreads::wait(const Chunk& chunk, const std::function<bool()>& is_interrupted) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_done_.wait_for(lock, kGlance, [&chunk] { return chunk.is_done; })) {
    lock.unlock();
    if (is_interrupted()) return false;
    lock.lock();
  }
  return true;
}

/// The output of a chunk counts until it is done, even if it is released before.
void ChunkThreads::release(const ChunkPtr& chunk) {
  --chunks_;
  input_size_ -= chunk->input.data.size();
  const std::lock_guard<std::mutex> lock(mutex_);
  chunk->is_released = true;
  if (chunk->is_done) output_size_ -= chunk->counted;
  for (auto waiting = queue_.begin(); waiting != queue_.end(); ++waiting) {
    if (*waiting != chunk) continue;
    queue_.erase(waiting);
    return;
  }
}

void ChunkThreads::run() {
  for (;;) {
    ChunkPtr chunk;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      is_waiting_.wait(lock, [this] { return is_over_ || !queue_.empty(); });
      if (is_over_) return;
      chunk = queue_.front();
      queue_.pop_front();
    }
    unpack(*chunk);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      chunk->is_done = true;
      if (chunk->is_released) output_size_ -= chunk->counted;
    }
    is_done_.notify_one();
  }
}

/// If this fails, the reader unpacks the chunk again, and reports the failure.
void ChunkThreads::unpack(Chunk& chunk) {
  const auto is_too_much = [&](std::uint64_t) {
    output_size_ += chunk.output.size() - chunk.counted;
    chunk.counted = chunk.output.size();
    return is_over_ || output_size_ > kMaxOutput;
  };
  try {
    chunk.data = decompress(chunk.compression, chunk.input, 0, chunk.output, is_too_much);
  } catch (const std::exception&) {
    chunk.data.state = ChunkState::kInterrupted;
  }
}

ChunksAhead::~ChunksAhead() {
  for (const Planned& planned : planned_)
    threads_.release(planned.chunk);
}

void ChunksAhead::plan(Bytes& bytes, std::uint64_t position) {
  position_ = std::max(position_, position);
  for (int records = 0; records < kRecordsAtOnce && threads_.hasRoom(planned_.size()); ++records) {
    Record record;
    if (position_ >= bytes.size() || readRecord(bytes, position_, record) != RecordState::kGood)
      return;
    position_ = record.end();
    if (record.op != RecordOp::kChunk || record.compression == "none") continue;
    if (record.data_size == 0 || record.data_size > kMaxChunkInput) continue;
    const std::string compression(record.compression);  // a copy, because at() replaces the bytes
    const std::uint8_t* const data = bytes.at(record.data, record.data_size);
    if (!data) return;
    auto chunk = threads_.start(compression, data, record.data_size);
    if (!chunk) return;
    planned_.push_back({record.data, std::move(chunk)});
  }
}

bool ChunksAhead::take(std::string_view compression, std::uint64_t begin,
                       std::vector<std::uint8_t>& output, std::uint64_t& consumed,
                       const std::function<bool()>& is_interrupted) {
  while (!planned_.empty() && planned_.front().begin < begin) {
    threads_.release(planned_.front().chunk);
    planned_.pop_front();
  }
  if (planned_.empty() || planned_.front().begin != begin) return false;
  const ChunkThreads::ChunkPtr chunk = planned_.front().chunk;
  if (!threads_.wait(*chunk, is_interrupted)) return false;
  planned_.pop_front();
  threads_.release(chunk);
  if (chunk->data.state != ChunkState::kGood || chunk->compression != compression) return false;
  output.swap(chunk->output);
  consumed = chunk->data.consumed;
  return true;
}

}  // namespace link_bounds
