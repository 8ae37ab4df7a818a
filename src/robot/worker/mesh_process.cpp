// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One child process per file, a deadline, and the words for each way to fail.
#include "link_bounds/robot/worker/mesh_process.h"

#include <dlfcn.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "robot/worker/child_process.h"
#include "robot/worker/mesh_reply.h"

namespace link_bounds {
namespace {

/// Bytes that a mesh may take beyond the limit of its file, because a small file of text may give a
/// larger mesh: the 10 bytes of "f 1 2 3 4" become two triangles of 12 bytes each.
constexpr std::uint64_t kExpansionBytes = 16 << 20;

constexpr double kMaxSeconds = 1e8;  // s; three years of processor time

void checkSize(const MeshFile& file, const MeshLimits& limits) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file.path, error);
  if (error) {
    throw MeshError("its size cannot be read (" + error.message() + ")", MeshFault::kUnreadable);
  }
  if (size <= limits.max_bytes) return;
  throw MeshError("its " + std::to_string(size) + " bytes are more than the " +
                      std::to_string(limits.max_bytes) + " that are allowed",
                  MeshFault::kTooLarge);
}

/// See src/tools/mesh_worker/mesh_worker.cpp.
std::vector<std::string> commandLine(const std::string& worker, const MeshFile& file,
                                     const MeshLimits& limits) {
  const double seconds = std::ceil(std::min(limits.timeout, kMaxSeconds));
  return {worker,
          file.path,
          file.root,
          std::to_string(limits.max_bytes),
          std::to_string(static_cast<long>(seconds)),
          std::to_string(getpid())};
}

/// SIGKILL comes from the kernel here, which sends it when memory runs out.
[[noreturn]] void throwDeath(int signal, const MeshLimits& limits) {
  if (signal == SIGXCPU) throwTooSlow(limits);
  if (signal == SIGKILL) {
    throw MeshError("the program that reads it was killed, as where memory runs out",
                    MeshFault::kComputer);
  }
  throw MeshError(std::string("the program that reads it died of it (") + strsignal(signal) + ")");
}

ImportedMesh replyOf(const std::string& worker, const MeshFile& file, const MeshLimits& limits,
                     const CheckInterrupt& check_interrupt) {
  Pipe pipe;
  ChildProcess process(commandLine(worker, file, limits), pipe.writingEnd());
  pipe.closeWritingEnd();
  const auto source = [&](void* out, std::size_t wanted) {
    return pipe.read(out, wanted, check_interrupt);
  };
  try {
    return readMeshReply(source, limits.max_bytes + kExpansionBytes);
  } catch (const ReplyError&) {
    const int signal = pipe.hasEnded() ? process.waitForSignal(check_interrupt) : 0;
    if (signal == 0) throw;
    throwDeath(signal, limits);
  } catch (const MeshError& error) {
    if (process.end()) throw;
    throw MeshError(std::string(error.what()) + "; the program that reads it cannot be killed",
                    MeshFault::kFileSystem);
  }
}

/// The fault when no program could be started.
MeshFault faultOf(const std::error_code& error) {
  for (const std::errc shortage :
       {std::errc::resource_unavailable_try_again, std::errc::not_enough_memory,
        std::errc::too_many_files_open, std::errc::too_many_files_open_in_system}) {
    if (error == shortage) return MeshFault::kComputer;
  }
  return MeshFault::kReader;
}

/// The folder of this library, or of the running program if the library is linked into it; "" if
/// unknown.
std::filesystem::path folderOfLibrary() {
  static const char own_symbol = 0;
  Dl_info info{};
  std::error_code ignored;
  if (dladdr(&own_symbol, &info) == 0) return {};
  return std::filesystem::canonical(info.dli_fname, ignored).parent_path();
}

/// The folders in which mesh_worker is looked for, in this order.
std::vector<std::filesystem::path> foldersOfWorker() {
  std::vector<std::filesystem::path> folders{
      std::filesystem::read_symlink("/proc/self/exe").parent_path()};
  const std::filesystem::path library = folderOfLibrary();
  if (library.empty()) return folders;
  // As Debian packages it, so that libraries of two SOVERSIONs can be installed side by side.
  folders.push_back(library / ("link_bounds" LINK_BOUNDS_SOVERSION));
  folders.push_back(library / "link_bounds");
  // For a library in lib/TRIPLET.
  folders.push_back(library.parent_path() / "link_bounds");
  return folders;
}

}  // namespace

std::string meshWorker() {
  const std::vector<std::filesystem::path> folders = foldersOfWorker();
  for (const std::filesystem::path& folder : folders) {
    if (std::filesystem::exists(folder / "mesh_worker")) return (folder / "mesh_worker").string();
  }
  return (folders.front() / "mesh_worker").string();
}

TriangleMesh importInProcess(const std::string& worker, const MeshFile& file,
                             const MeshLimits& limits, const std::function<bool()>& is_cancelled) {
  return importInTime(worker, file, limits, meshDeadline(limits, is_cancelled));
}

ImportedMesh importInTime(const std::string& worker, const MeshFile& file, const MeshLimits& limits,
                          const CheckInterrupt& deadline) {
  deadline();
  try {
    checkSize(file, limits);
    return replyOf(worker, file, limits, deadline);
  } catch (const std::system_error& error) {
    throw MeshError("cannot run " + worker + " (" + error.code().message() + ")",
                    faultOf(error.code()));
  }
}

}  // namespace link_bounds
