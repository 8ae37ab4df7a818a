// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/records/chunk.h"

#include <bzlib.h>
#include <lz4frame.h>

#include <algorithm>
#include <cstddef>
#include <new>

namespace link_bounds {
namespace {

constexpr std::size_t kInputSize = 64 << 10;    // bytes at once
constexpr std::size_t kOutputSize = 256 << 10;  // bytes at once

struct Step {
  std::size_t consumed = 0;
  std::size_t produced = 0;
  bool is_good = false;
  bool is_end = false;
};

class Bzip2 {
 public:
  Bzip2() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream_); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  Step run(const std::uint8_t* input, std::size_t input_size, std::uint8_t* output,
           std::size_t output_size) {
    stream_.next_in = const_cast<char*>(reinterpret_cast<const char*>(input));
    stream_.avail_in = static_cast<unsigned>(input_size);
    stream_.next_out = reinterpret_cast<char*>(output);
    stream_.avail_out = static_cast<unsigned>(output_size);
    const int result = BZ2_bzDecompress(&stream_);
    return {input_size - stream_.avail_in, output_size - stream_.avail_out,
            result == BZ_OK || result == BZ_STREAM_END, result == BZ_STREAM_END};
  }

 private:
  bz_stream stream_{};
};

class Lz4 {
 public:
  Lz4() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context_, LZ4F_VERSION)))
      throw std::bad_alloc();
  }
  ~Lz4() { LZ4F_freeDecompressionContext(context_); }
  Lz4(const Lz4&) = delete;
  Lz4& operator=(const Lz4&) = delete;

  Step run(const std::uint8_t* input, std::size_t input_size, std::uint8_t* output,
           std::size_t output_size) {
    const std::size_t result =
        LZ4F_decompress(context_, output, &output_size, input, &input_size, nullptr);
    return {input_size, output_size, !LZ4F_isError(result), result == 0};
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};

// Reserves the limit at once: a vector would double its memory to twice the limit.
void makeRoom(std::vector<std::uint8_t>& output, std::size_t size) {
  if (size <= output.size()) return;
  if (size > kMaxChunkSize / 2) output.reserve(kMaxChunkSize + 2 * kOutputSize);
  output.resize(size);
}

template <class Decompressor>
ChunkData run(Bytes& bytes, std::uint64_t begin, std::vector<std::uint8_t>& output,
              const IsInterrupted& is_interrupted) {
  Decompressor decompressor;
  std::size_t filled = 0;
  const auto finish = [&](ChunkState state, std::uint64_t consumed) {
    output.resize(state == ChunkState::kGood || state == ChunkState::kCut ? filled : 0);
    return ChunkData{state, consumed};
  };
  for (std::uint64_t offset = begin;;) {
    if (is_interrupted(offset)) return finish(ChunkState::kInterrupted, offset - begin);
    const std::size_t input_size = std::min<std::uint64_t>(kInputSize, bytes.size() - offset);
    const std::uint8_t* const input = bytes.at(offset, input_size);
    if (!input) return finish(ChunkState::kCut, offset - begin);
    if (filled > kMaxChunkSize) return finish(ChunkState::kTooLarge, offset - begin);
    makeRoom(output, filled + kOutputSize);
    const Step step =
        decompressor.run(input, input_size, output.data() + filled, output.size() - filled);
    offset += step.is_good ? step.consumed : input_size;
    if (!step.is_good) return finish(ChunkState::kDamaged, offset - begin);
    filled += step.produced;
    if (step.is_end) return finish(ChunkState::kGood, offset - begin);
    if (step.consumed + step.produced == 0) return finish(ChunkState::kCut, offset - begin);
  }
}

}  // namespace

ChunkData decompress(std::string_view compression, Bytes& bytes, std::uint64_t begin,
                     std::vector<std::uint8_t>& output, const IsInterrupted& is_interrupted) {
  if (compression == "bz2") return run<Bzip2>(bytes, begin, output, is_interrupted);
  if (compression == "lz4") return run<Lz4>(bytes, begin, output, is_interrupted);
  return {ChunkState::kUnknownCompression, 0};
}

}  // namespace link_bounds
