// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh whose geometry is in other files, too, through mesh_worker: whichever of them is replaced,
// appears or goes, the store notices it.
#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "link_bounds/robot/mesh/mesh_store.h"
#include "link_bounds/robot/worker/mesh_process.h"
#include "robot/worker/mesh_import.h"
#include "testing/mesh_texts.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr std::chrono::nanoseconds kTick(10'000'000);  // the longest of the clock of files

/// Three vertices, one of them at (size, 0, 0).
std::string threeCorners(float size) {
  std::string bytes;
  for (const float value : {0.0f, 0.0f, 0.0f, size, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f})
    bytes += bytesOf(value);
  return bytes;
}

/// The binary kind, without a chunk of data.
std::string binaryGltf(std::string json) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(json.size());
  return "glTF" + bytesOf(std::uint32_t(2)) + bytesOf(size + 20) + bytesOf(size) + "JSON" + json;
}

std::string triangleObj(float size) {
  return "v 0 0 0\nv " + std::to_string(size) + " 0 0\nv 0 1 0\nf 1 2 3\n";
}

class FilesOfMeshes : public testing::Test {
 protected:
  LoadedMesh load(const std::string& name) {
    return store_.load({{folder_ / name, folder_.path().string()}}).at(0);
  }
  bool isKnown(const std::string& name) const {
    return store_.find({folder_ / name, folder_.path().string()}) != nullptr;
  }

  static double widthOf(const LoadedMesh& mesh) {
    return mesh.points ? mesh.points->magnitude().maxCoeff() : 0;
  }

  TemporaryFolder folder_;
  MeshStore store_{
      [](const MeshFile& file, const MeshLimits& limits, const CheckInterrupt& deadline) {
        return importInTime(meshWorker(), file, limits, deadline);
      }};
};

/// How assimp understands a URI differs between its versions, but the store may not miss any.
TEST_F(FilesOfMeshes, ABufferOfAGltfIsWatchedHoweverItIsNamed) {
  int seen = 0;
  for (const std::string& uri :
       {std::string("a.bin"), std::string("my%20data.bin"), std::string(R"(.\/a.bin)"),
        std::string(R"(my\u0020d\u0061ta.bin)"), std::string(R"(C:\\x\\a.bin)"),
        std::string("/home/you/a.bin"), std::string("export/a.bin"),
        "file://" + (folder_ / "a.bin"), std::string(R"(sub\\a.bin)"), std::string("/sub/a.bin"),
        std::string("//sub/a.bin"), std::string("%2Fsub%2Fa.bin"), std::string("sub/../a.bin"),
        folder_ / "a.bin"}) {
    for (const auto& [name, text] : std::map<std::string, std::string>{
             {"a.gltf", gltf(uri)}, {"b.GLTF", gltf(uri)}, {"c.glb", binaryGltf(gltf(uri))}}) {
      for (const char* buffer : {"a.bin", "my data.bin", "sub/a.bin"})
        folder_.write(buffer, threeCorners(2));
      folder_.write(name, text);
      store_.forgetFailures();
      const LoadedMesh first = load(name);
      if (!first.points) continue;
      ASSERT_EQ(widthOf(first), 2) << uri << " in " << name;
      EXPECT_TRUE(isKnown(name)) << uri << " in " << name;
      ++seen;
      for (const char* buffer : {"a.bin", "my data.bin", "sub/a.bin"})
        folder_.write(buffer, threeCorners(3));
      EXPECT_FALSE(isKnown(name)) << uri << " in " << name;
      EXPECT_EQ(widthOf(load(name)), 3) << uri << " in " << name;
    }
  }
  EXPECT_GE(seen, 12) << "plain names and escapes";
}

TEST_F(FilesOfMeshes, AFileThatTakesThePlaceOfAnotherIsNoticed) {
  folder_.write("my data.bin", threeCorners(2));
  folder_.write("a.gltf", gltf("my%20data.bin"));
  const LoadedMesh first = load("a.gltf");
  ASSERT_EQ(widthOf(first), 2) << first.error;
  folder_.write("my%20data.bin", threeCorners(3));
  EXPECT_FALSE(isKnown("a.gltf"));
  const LoadedMesh second = load("a.gltf");
  EXPECT_EQ(widthOf(second), 3);
  std::filesystem::remove(folder_ / "my%20data.bin");
  EXPECT_FALSE(isKnown("a.gltf"));
  EXPECT_EQ(widthOf(load("a.gltf")), 2);
}

TEST_F(FilesOfMeshes, OtherFilesOfTheFolderAreNot) {
  folder_.write("a.obj", "mtllib a.mtl\n" + triangleObj(2));
  folder_.write("a.mtl", "newmtl m\n");
  const LoadedMesh first = load("a.obj");
  ASSERT_EQ(widthOf(first), 2) << first.error;
  folder_.write("b.mtl", "newmtl m\n");
  folder_.write("b.obj", triangleObj(3));
  EXPECT_TRUE(isKnown("a.obj"));
  EXPECT_EQ(load("a.obj").points, first.points);
  folder_.write("a.mtl", "newmtl n\n");
  EXPECT_FALSE(isKnown("a.obj")) << "its material is";
}

/// Calls `during` each time before a file is read.
MeshFault faultOf(const MeshFile& file, const BytesHandler& during) {
  try {
    importMesh(file, MeshLimits().max_bytes, during);
  } catch (const MeshError& error) {
    return error.fault();
  }
  return MeshFault::kFileSystem;  // which the importer does not have
}

TEST_F(FilesOfMeshes, ABufferThatChangesAfterItWasOpenedIsRefused) {
  folder_.write("a.bin", threeCorners(2));
  const MeshFile file{folder_.write("a.gltf", gltf("a.bin")), folder_.path().string()};
  EXPECT_EQ(faultOf(file, nullptr), MeshFault::kFileSystem);
  const std::uint64_t alone = gltf("a.bin").size();
  const auto rewriteOnceItIsOpen = [&](std::uint64_t bytes) {
    if (bytes > alone) folder_.write("a.bin", threeCorners(3));
  };
  EXPECT_EQ(faultOf(file, rewriteOnceItIsOpen), MeshFault::kChanged);
}

/// Otherwise a second write within a tick would give the version that was read.
TEST_F(FilesOfMeshes, ABufferIsReadWhenATickHasPassedSinceItWasWritten) {
  const MeshFile file{folder_.write("a.gltf", gltf("a.bin")), folder_.path().string()};
  const std::string buffer = folder_.write("a.bin", threeCorners(2));
  const std::uint64_t alone = gltf("a.bin").size();
  int checks = 0;
  const auto checkAge = [&](std::uint64_t bytes) {
    if (bytes == alone) folder_.write("a.bin", threeCorners(2));  // just before it is opened
    if (bytes == alone || checks++ > 0) return;
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    const timespec written = fileVersion(buffer).changed;
    const auto age = 1e9 * static_cast<double>(now.tv_sec - written.tv_sec) +
                     static_cast<double>(now.tv_nsec - written.tv_nsec);
    EXPECT_GT(age, static_cast<double>(kTick.count())) << "ns";
  };
  EXPECT_EQ(faultOf(file, checkAge), MeshFault::kFileSystem);
  EXPECT_GE(checks, 1);
}

/// Writes a file again and again, until it is stopped.
class Writer {
 public:
  explicit Writer(const std::string& name) : thread_([this, name] { write(name); }) {}
  ~Writer() { stop(); }

  void stop() {
    is_over_ = true;
    if (thread_.joinable()) thread_.join();
  }

  /// Between two writes; where the processor is busy elsewhere, it may be longer than a tick.
  std::chrono::nanoseconds longestPause() const { return longest_pause_; }

 private:
  using Clock = std::chrono::steady_clock;

  void write(const std::string& name) {
    Clock::time_point last = Clock::now();
    const auto measure = [&] {
      longest_pause_ = std::max<std::chrono::nanoseconds>(longest_pause_, Clock::now() - last);
      last = Clock::now();
    };
    while (!is_over_) {
      std::ofstream(name, std::ios::in | std::ios::binary) << threeCorners(2);
      measure();
    }
    measure();
  }

  std::atomic<bool> is_over_{false};
  std::chrono::nanoseconds longest_pause_{0};
  std::thread thread_;  ///< last, as it uses the others
};

/// Also where the last write was just before it was opened, and has the same time as one before.
TEST_F(FilesOfMeshes, ABufferThatSomebodyWritesWithoutEndIsRefused) {
  const MeshFile file{folder_.write("a.gltf", gltf("a.bin")), folder_.path().string()};
  const std::string buffer = folder_.write("a.bin", threeCorners(2));
  const std::uint64_t alone = gltf("a.bin").size();
  MeshFault fault = MeshFault::kFileSystem;
  std::chrono::nanoseconds pause{0};
  do {
    Writer writer(buffer);
    fault = faultOf(file, [&](std::uint64_t bytes) {
      if (bytes > alone) writer.stop();
    });
    writer.stop();
    pause = writer.longestPause();
  } while (fault != MeshFault::kChanged && pause > kTick);
  EXPECT_EQ(fault, MeshFault::kChanged);
  EXPECT_EQ(faultOf(file, nullptr), MeshFault::kFileSystem);
}

}  // namespace
}  // namespace link_bounds
