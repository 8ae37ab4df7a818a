// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/records/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace link_bounds {
namespace {

constexpr std::size_t kBlockSize = 256 << 10;  // bytes; larger ones read no faster

}  // namespace

// Opens without waiting: a pipe would wait for a writer.
FileBytes::FileBytes(const std::string& name)
    : file_(open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (file_ < 0) throw std::runtime_error(name + ": cannot be opened: " + std::strerror(errno));
  struct stat state;
  if (fstat(file_, &state) != 0 || !S_ISREG(state.st_mode)) {
    close(file_);
    throw std::runtime_error(name + ": is not an ordinary file");
  }
  size_ = static_cast<std::uint64_t>(state.st_size);
}

FileBytes::~FileBytes() {
  close(file_);
}

const std::uint8_t* FileBytes::at(std::uint64_t offset, std::size_t size) {
  if (offset > size_ || size > size_ - offset) return nullptr;
  const auto is_loaded = [&] {
    return offset >= begin_ && offset - begin_ <= loaded_ && size <= loaded_ - (offset - begin_);
  };
  if (!is_loaded()) load(offset, size);
  return is_loaded() ? block_.data() + (offset - begin_) : nullptr;
}

// If reading fails or the file has become shorter, the file counts as cut.
void FileBytes::load(std::uint64_t offset, std::size_t size) {
  const std::size_t wanted = std::max(size, kBlockSize);
  if (block_.size() < wanted) block_.resize(wanted);
  begin_ = offset;
  loaded_ = 0;
  while (loaded_ < wanted) {
    const ssize_t count = pread(file_, block_.data() + loaded_, wanted - loaded_,
                                static_cast<off_t>(offset + loaded_));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    loaded_ += static_cast<std::size_t>(count);
  }
}

}  // namespace link_bounds
