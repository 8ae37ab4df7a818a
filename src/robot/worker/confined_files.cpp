// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Opens a file before it checks it: if it checked the path first, another file could take its place
// before it is opened.
#include "robot/worker/confined_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <assimp/IOStream.hpp>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "link_bounds/robot/mesh/mesh_uri.h"
#include "robot/mesh/percent_decoded.h"

namespace link_bounds {
namespace {

class ReadStream : public Assimp::IOStream {
 public:
  ReadStream(std::FILE* file, std::size_t size) : file_(file), size_(size) {}
  ~ReadStream() override { std::fclose(file_); }
  ReadStream(const ReadStream&) = delete;
  ReadStream& operator=(const ReadStream&) = delete;

  std::size_t Read(void* out, std::size_t size, std::size_t count) override {
    return std::fread(out, size, count, file_);
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const int whence = origin == aiOrigin_SET   ? SEEK_SET
                       : origin == aiOrigin_CUR ? SEEK_CUR
                                                : SEEK_END;
    return std::fseek(file_, static_cast<long>(offset), whence) == 0 ? aiReturn_SUCCESS
                                                                     : aiReturn_FAILURE;
  }
  std::size_t Tell() const override { return static_cast<std::size_t>(std::ftell(file_)); }
  std::size_t FileSize() const override { return size_; }
  void Flush() override {}

 private:
  std::FILE* file_;
  std::size_t size_;
};

/// The status of an open file; none unless it is a regular file below root.
std::optional<struct stat> allowedStatus(const std::string& root, int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  std::error_code error;
  const auto real =
      std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error);
  if (error || !isBelow(root, real)) return std::nullopt;
  return status;
}

}  // namespace

ConfinedFiles::ConfinedFiles(const MeshFile& mesh, std::uint64_t max_bytes, BytesHandler on_bytes)
    : root_(mesh.root),
      folder_(std::filesystem::path(mesh.path).parent_path().string() + "/"),
      max_bytes_(max_bytes),
      on_bytes_(std::move(on_bytes)) {}

/// O_NONBLOCK: does not wait for the writer of a pipe. O_NOCTTY: takes no controlling terminal. A
/// glTF names its buffers by URIs, which assimp does not decode.
int ConfinedFiles::openForReading(const std::string& path) const {
  const int descriptor = openAndNote(path);
  if (descriptor >= 0 || path.rfind(folder_, 0) != 0) return descriptor;
  const std::string decoded = folder_ + percentDecoded(path.substr(folder_.size()));
  return decoded == path ? descriptor : openAndNote(decoded);
}

/// If the file cannot be opened, notes its version from before the attempt, so that a file that
/// appears meanwhile counts as changed.
int ConfinedFiles::openAndNote(const std::string& path) const {
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(path, error).string();
  if (absolute.empty()) return -1;
  const FileVersion before = fileVersion(absolute);
  const int descriptor = open(absolute.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0 && errno == EACCES)
    refusal_.emplace("this user may not read " + absolute, MeshFault::kUnreadable);
  const auto version = [&] {
    struct stat status {};
    return fstat(descriptor, &status) == 0 ? fileVersion(status) : FileVersion{};
  };
  files_.emplace(absolute, descriptor < 0 ? before : settledVersion(version, ticks_left_));
  return descriptor;
}

bool ConfinedFiles::Exists(const char* path) const {
  const int descriptor = openForReading(path);
  if (descriptor < 0) return false;
  const bool is_allowed = allowedStatus(root_, descriptor).has_value();
  close(descriptor);
  return is_allowed;
}

Assimp::IOStream* ConfinedFiles::Open(const char* path, const char* mode) {
  if (std::string(mode).find_first_of("wa+") != std::string::npos) return nullptr;
  const int descriptor = openForReading(path);
  if (descriptor < 0) return nullptr;
  const std::optional<struct stat> status = allowedStatus(root_, descriptor);
  std::FILE* file = status && mayBeRead(path, *status) ? fdopen(descriptor, "rb") : nullptr;
  if (!file) {
    close(descriptor);
    return nullptr;
  }
  return new ReadStream(file, static_cast<std::size_t>(status->st_size));
}

/// Adds up sizes by device and inode, because readers may open a file twice.
bool ConfinedFiles::mayBeRead(const char* path, const struct stat& status) {
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes_) {
    refusal_.emplace(std::filesystem::path(path).filename().string() + " has " +
                         std::to_string(size) + " bytes, more than the " +
                         std::to_string(max_bytes_) + " that are allowed",
                     MeshFault::kTooLarge);
    return false;
  }
  bytes_[{status.st_dev, status.st_ino}] = size;
  std::uint64_t sum = 0;
  for (const auto& [file, bytes] : bytes_)
    sum += bytes;
  if (on_bytes_) on_bytes_(sum);
  return true;
}

void ConfinedFiles::Close(Assimp::IOStream* file) {
  delete file;
}

}  // namespace link_bounds
