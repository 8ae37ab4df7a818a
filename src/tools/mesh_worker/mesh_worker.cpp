// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads one mesh file and writes its triangles, or the reason why there are none, to standard
// output, as robot/worker/mesh_reply.h describes. Only importInTime starts it.
#include <errno.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <system_error>

#include "robot/worker/mesh_import.h"
#include "robot/worker/mesh_reply.h"
#include "robot/worker/worker_limits.h"

namespace link_bounds {
namespace {

enum Argument { kFile = 1, kRoot, kMaxBytes, kCpuSeconds, kParent, kCount };

void writeToOutput(const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = write(STDOUT_FILENO, next, count);
    if (written < 0 && errno != EINTR) _exit(1);
    if (written < 0) continue;
    next += written;
    count -= static_cast<std::size_t>(written);
  }
}

/// Raises the memory limit with each file that is opened: a mesh file may keep its vertices in
/// another file.
void reply(const MeshFile& file, std::uint64_t max_bytes) {
  std::uint64_t file_bytes = 0;
  const auto on_bytes = [&file_bytes](std::uint64_t bytes) {
    file_bytes = bytes;
    raiseMemoryLimit(memoryLimit(bytes));
  };
  try {
    writeMeshReply(importMesh(file, max_bytes, on_bytes), writeToOutput);
  } catch (const std::bad_alloc&) {
    writeErrorReply(
        MeshError(
            "reading it takes more than the " + std::to_string(memoryLimit(file_bytes) >> 20) +
                " MiB of memory that are allowed for its " + std::to_string(file_bytes) + " bytes",
            MeshFault::kMemory),
        writeToOutput);
  } catch (const MeshError& error) {
    writeErrorReply(error, writeToOutput);
  } catch (const std::exception& error) {
    writeErrorReply(MeshError(error.what()), writeToOutput);
  }
}

int run(char** argv) {
  const MeshFile file{argv[kFile], argv[kRoot]};
  const std::uint64_t max_bytes = std::strtoull(argv[kMaxBytes], nullptr, 10);
  const MemoryLimits memory{memoryLimit(0), memoryLimit(max_bytes)};
  try {
    limitThisProcess(memory, std::atol(argv[kCpuSeconds]), std::atoi(argv[kParent]));
  } catch (const std::system_error& refusal) {
    writeErrorReply(MeshError(std::string("the program that reads it cannot limit itself (") +
                                  refusal.what() + ")",
                              MeshFault::kForbidden),
                    writeToOutput);
    _exit(0);
  }
  reply(file, max_bytes);
  // Without destructors: a reader that has damaged its memory could crash in them.
  _exit(0);
}

/// Answers a user who starts this program by hand.
int answerUser(int argc, char** argv) {
  const std::string argument = argc == 2 ? argv[1] : "";
  if (argument == "--version") {
    std::puts("mesh_worker " LINK_BOUNDS_VERSION);
    return 0;
  }
  const bool asks_for_help = argument == "--help" || argument == "-h";
  std::fputs("usage: mesh_worker is started by link_bounds for one mesh file; use urdf_bounds\n",
             asks_for_help ? stdout : stderr);
  return asks_for_help ? 0 : 1;
}

}  // namespace
}  // namespace link_bounds

#if defined(__SANITIZE_ADDRESS__)
/// The parent reports the signal that ends this process; sanitizers must not catch it.
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_abort=0:handle_sigbus=0:handle_sigfpe=0:allocator_may_return_null=1";
}
#endif

int main(int argc, char** argv) {
  if (argc != link_bounds::kCount) return link_bounds::answerUser(argc, argv);
  std::signal(SIGABRT, SIG_DFL);  // a sanitizer may have set a handler
  return link_bounds::run(argv);
}
