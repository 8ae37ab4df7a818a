// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bytes at any place of a file or of memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace link_bounds {

class Bytes {
 public:
  virtual ~Bytes() = default;

  /// `size` bytes from `offset` on, valid until the next call; null if there are not so many.
  virtual const std::uint8_t* at(std::uint64_t offset, std::size_t size) = 0;

  virtual std::uint64_t size() const = 0;
};

/// Called regularly with the position that is being read; true ends the reading.
using IsInterrupted = std::function<bool(std::uint64_t position)>;

/// A file, of which one block is in memory.
class FileBytes : public Bytes {
 public:
  /// Throws std::runtime_error if there is no such file, or if it is no ordinary file.
  explicit FileBytes(const std::string& name);
  ~FileBytes() override;
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const std::uint8_t* at(std::uint64_t offset, std::size_t size) override;
  std::uint64_t size() const override { return size_; }

 private:
  void load(std::uint64_t offset, std::size_t size);

  int file_;
  std::uint64_t size_;
  std::uint64_t begin_ = 0;  ///< of the block in memory
  std::size_t loaded_ = 0;
  std::vector<std::uint8_t> block_;
};

class MemoryBytes : public Bytes {
 public:
  const std::uint8_t* at(std::uint64_t offset, std::size_t size) override {
    return offset <= data.size() && size <= data.size() - offset ? data.data() + offset : nullptr;
  }
  std::uint64_t size() const override { return data.size(); }

  std::vector<std::uint8_t> data;
};

}  // namespace link_bounds
