// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Workers that crash, hang, lie or are not there, and the real one.
#include "link_bounds/mesh_process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "link_bounds/mesh_frame.h"
#include "mesh_import.h"
#include "mesh_texts.h"
#include "process_census.h"
#include "temporary_folder.h"

namespace link_bounds {
namespace {

constexpr double kShortTimeout = 0.3;  // s
constexpr double kDeadline = 20;       // s

class MeshProcess : public testing::Test {
 protected:
  void SetUp() override { open_descriptors_ = openDescriptors(); }

  /// Nothing may be left of any worker.
  void TearDown() override {
    EXPECT_EQ(openDescriptors(), open_descriptors_);
    EXPECT_FALSE(hasChildren());
  }

  /// A worker that is a shell script; $1 is the mesh, $5 the parent.
  std::string script(const std::string& commands) const {
    std::string path = folder_.write("worker", "#!/bin/sh\n" + commands + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  /// A worker that writes these bytes and then runs the commands.
  std::string speaker(const std::string& bytes, const std::string& commands = "") const {
    return script("cat '" + folder_.write("answer", bytes) + "'\n" + commands);
  }

  std::string reasonOf(const std::string& worker, double timeout = kDeadline) const {
    try {
      MeshLimits limits;
      limits.timeout = timeout;
      importInProcess(worker, stl_, limits);
    } catch (const MeshError& error) {
      return error.what();
    }
    return "no error";
  }

  void expectReason(const std::string& worker, const std::string& words,
                    double timeout = kDeadline) const {
    const std::string reason = reasonOf(worker, timeout);
    EXPECT_NE(reason.find(words), std::string::npos) << reason;
  }

  TemporaryFolder folder_;
  MeshFile stl_{folder_.write("meshes/a.stl", binaryStl(tetrahedronCorners())), folder_ / "meshes"};
  std::string real_ = meshWorker();
  long open_descriptors_ = 0;
};

std::string goodFrame() {
  std::string bytes;
  writeMeshFrame({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
                 [&](const void* data, std::size_t count) {
                   bytes.append(static_cast<const char*>(data), count);
                 });
  return bytes;
}

TEST_F(MeshProcess, TheRealWorkerReadsWhatTheImporterReads) {
  const TriangleMesh here = importMesh(stl_);
  const TriangleMesh there = importInProcess(real_, stl_, {});
  EXPECT_EQ(there.vertices, here.vertices);
  EXPECT_EQ(there.triangles, here.triangles);
}

TEST_F(MeshProcess, TheRealWorkerSaysWhyNot) {
  folder_.write("meshes/a.stl", "no mesh");
  EXPECT_EQ(reasonOf(real_).find("assimp cannot read it"), 0u) << reasonOf(real_);
}

TEST_F(MeshProcess, TheRealWorkerOpensNothingOutsideTheRoot) {
  stl_.root = folder_ / "elsewhere";
  EXPECT_EQ(reasonOf(real_), "it cannot be opened");
}

TEST_F(MeshProcess, AMissingWorker) {
  expectReason(folder_ / "nowhere", "cannot run");
}

TEST_F(MeshProcess, AMissingMesh) {
  std::filesystem::remove(stl_.path);
  expectReason(real_, "No such file");
}

TEST_F(MeshProcess, AFileAboveTheLimitStartsNoWorker) {
  MeshLimits limits;
  limits.max_bytes = std::filesystem::file_size(stl_.path);
  EXPECT_EQ(importInProcess(real_, stl_, limits).triangles.size(), 4u);
  --limits.max_bytes;
  try {
    importInProcess(folder_ / "nowhere", stl_, limits);
    ADD_FAILURE() << "not refused";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("max_mesh_bytes"), std::string::npos) << error.what();
  }
}

TEST_F(MeshProcess, ACrash) {
  expectReason(script("kill -SEGV $$"), "Segmentation fault");
  expectReason(script("kill -ABRT $$"), "Aborted");
  expectReason(speaker(goodFrame().substr(0, 50), "kill -SEGV $$"), "Segmentation fault");
}

TEST_F(MeshProcess, ACrashAfterTheWholeAnswerChangesNothing) {
  EXPECT_EQ(importInProcess(speaker(goodFrame(), "kill -SEGV $$"), stl_, {}).triangles.size(), 1u);
}

TEST_F(MeshProcess, AnEndWithoutAnAnswer) {
  expectReason(script("exit 0"), "ends early");
  expectReason(script("exit 3"), "ends early");
  expectReason(speaker(goodFrame().substr(0, 50)), "ends early");
}

TEST_F(MeshProcess, AHang) {
  expectReason(script("exec sleep 1000"), "0.3 s of mesh_timeout", kShortTimeout);
  expectReason(speaker(goodFrame().substr(0, 50), "exec sleep 1000"), "mesh_timeout",
               kShortTimeout);
  expectReason(speaker(goodFrame(), "exec sleep 1000"), "mesh_timeout", kShortTimeout);
  expectReason(script("exec >/dev/null; exec sleep 1000"), "mesh_timeout", kShortTimeout);
}

TEST_F(MeshProcess, AnAnswerWithoutEnd) {
  expectReason(speaker(goodFrame(), "exec cat /dev/zero"), "does not end");
  expectReason(script("exec cat /dev/zero"), "is not one");
}

TEST_F(MeshProcess, ALieAboutSizes) {
  std::string lie = goodFrame();
  lie[31] = 0x40;  // the highest byte of the number of triangles
  expectReason(speaker(lie, "exec cat /dev/zero"), "take more than");
}

TEST_F(MeshProcess, WhatItSaysOnStandardErrorIsNotPassedOn) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(importInProcess(speaker(goodFrame(), "echo noise >&2"), stl_, {}).triangles.size(), 1u);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(MeshProcess, CancellingEndsItSoon) {
  MeshLimits limits;
  limits.timeout = kDeadline;
  int asked = 0;
  const auto is_cancelled = [&asked] { return ++asked == 3; };
  try {
    importInProcess(script("exec sleep 1000"), stl_, limits, is_cancelled);
    ADD_FAILURE() << "not cancelled";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("cancelled"), std::string::npos) << error.what();
  }
  EXPECT_EQ(asked, 3);
}

TEST_F(MeshProcess, ManyAtOnce) {
  std::atomic<int> good{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 10; ++k)
        good += importInProcess(real_, stl_, {}).triangles.size() == 4;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(good, 40);
}

}  // namespace
}  // namespace link_bounds
