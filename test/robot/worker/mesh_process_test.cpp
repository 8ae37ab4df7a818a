// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Workers that crash, hang, lie or are not there, and the real one.
#include "link_bounds/robot/worker/mesh_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>

#include "robot/worker/child_process.h"
#include "robot/worker/mesh_import.h"
#include "robot/worker/mesh_reply.h"
#include "testing/emulated.h"
#include "testing/mesh_texts.h"
#include "testing/ordinary_user.h"
#include "testing/patience.h"
#include "testing/process_census.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr double kShortTimeout = 0.3;        // s
constexpr double kDeadline = 20;             // s
constexpr std::chrono::seconds kGivenUp(4);  // 2 s, and as long again for a busy machine

pid_t numberIn(const std::string& path) {
  pid_t number = 0;
  std::ifstream(path) >> number;
  return number;
}

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

  MeshError errorOf(const std::string& worker, double timeout = kDeadline) const {
    try {
      MeshLimits limits;
      limits.timeout = timeout;
      importInProcess(worker, stl_, limits);
    } catch (const MeshError& error) {
      return error;
    }
    return MeshError("no error");
  }

  std::string reasonOf(const std::string& worker) const { return errorOf(worker).what(); }

  void expectReason(const std::string& worker, const std::string& words,
                    MeshFault fault = MeshFault::kFile, double timeout = kDeadline) const {
    const MeshError error = errorOf(worker, timeout);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(error.fault(), fault) << error.what();
  }

  void expectTooSlow(const std::string& worker) const {
    expectReason(worker, "longer than 0.3 s", MeshFault::kTooSlow, kShortTimeout);
  }

  TemporaryFolder folder_;
  MeshFile stl_{folder_.write("meshes/a.stl", binaryStl(tetrahedronCorners())), folder_ / "meshes"};
  std::string real_ = meshWorker();
  long open_descriptors_ = 0;
};

std::string goodReply() {
  std::string bytes;
  writeMeshReply(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
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
  if (!missesPrograms()) GTEST_SKIP() << "skipped: this emulator starts what does not exist";
  expectReason(folder_ / "nowhere", "cannot run", MeshFault::kReader);
}

TEST_F(MeshProcess, AMissingMesh) {
  std::filesystem::remove(stl_.path);
  expectReason(real_, "No such file", MeshFault::kUnreadable);
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
    EXPECT_EQ(error.fault(), MeshFault::kTooLarge) << error.what();
  }
}

TEST_F(MeshProcess, ACrash) {
  expectReason(script("kill -SEGV $$"), "Segmentation fault");
  expectReason(script("kill -ABRT $$"), "Aborted");
  expectReason(speaker(goodReply().substr(0, 50), "kill -SEGV $$"), "Segmentation fault");
}

TEST_F(MeshProcess, ACrashAfterTheWholeAnswerChangesNothing) {
  EXPECT_EQ(importInProcess(speaker(goodReply(), "kill -SEGV $$"), stl_, {}).triangles.size(), 1u);
}

TEST_F(MeshProcess, AnEndWithoutAnAnswer) {
  expectReason(script("exit 0"), "ends early", MeshFault::kReader);
  expectReason(script("exit 3"), "ends early", MeshFault::kReader);
  expectReason(speaker(goodReply().substr(0, 50)), "ends early", MeshFault::kReader);
}

TEST_F(MeshProcess, AHang) {
  expectTooSlow(script("exec sleep 1000"));
  expectTooSlow(speaker(goodReply().substr(0, 50), "exec sleep 1000"));
  expectTooSlow(speaker(goodReply(), "exec sleep 1000"));
  expectTooSlow(script("exec >/dev/null; exec sleep 1000"));
}

TEST_F(MeshProcess, TimeOfTheProcessorThatIsUsedUp) {
  expectReason(script("kill -XCPU $$"), "longer than 20 s", MeshFault::kTooSlow);
}

TEST_F(MeshProcess, AKillByTheSystem) {
  expectReason(script("kill -KILL $$"), "was killed", MeshFault::kComputer);
}

TEST_F(MeshProcess, AnAnswerWithoutEnd) {
  expectReason(speaker(goodReply(), "exec cat /dev/zero"), "does not end");
  expectReason(script("exec cat /dev/zero"), "is not one", MeshFault::kReader);
}

TEST_F(MeshProcess, ALieAboutSizes) {
  std::string lie = goodReply();
  lie[31] = 0x40;  // the highest byte of the number of triangles
  expectReason(speaker(lie, "exec cat /dev/zero"), "take more than", MeshFault::kTooLarge);
}

TEST_F(MeshProcess, WhatItSaysOnStandardErrorIsNotPassedOn) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(importInProcess(speaker(goodReply(), "echo noise >&2"), stl_, {}).triangles.size(), 1u);
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
    EXPECT_EQ(error.fault(), MeshFault::kCancelled);
  }
  EXPECT_EQ(asked, 3);
}

TEST_F(MeshProcess, WhatAWorkerStartsEndsWithIt) {
  const std::string number = folder_ / "number";
  const std::string start = "sleep 1000 >/dev/null & echo $! >'" + number + "'\n";
  const auto expect_no_child = [&number](const char* what) {
    const pid_t child = numberIn(number);
    EXPECT_GT(child, 0) << what;
    if (becomesTrue([child] { return !isRunning(child); })) return;
    ADD_FAILURE() << what << ": its child lives on";
    kill(child, SIGKILL);
  };
  EXPECT_EQ(importInProcess(speaker(goodReply(), start), stl_, {}).triangles.size(), 1u);
  expect_no_child("a good answer");
  expectReason(script(start + "exit 3"), "ends early", MeshFault::kReader);
  expect_no_child("no answer");
  expectReason(script(start + "kill -SEGV $$"), "Segmentation fault");
  expect_no_child("a crash");
  expectTooSlow(script(start + "exec sleep 1000"));
  expect_no_child("a hang");
}

/// The files by which the process that imports and the one that traces its worker wait for each
/// other.
struct Steps {
  explicit Steps(const TemporaryFolder& folder)
      : number(folder / "number"), traced(folder / "traced"), released(folder / "released") {}
  std::string number;    ///< of the worker
  std::string traced;    ///< the import may be cancelled
  std::string released;  ///< the worker may be waited for
};

/// 0 if an import that is cancelled gives up its worker, which does not end, and if the next import
/// waits for it.
int importBesideAStuckWorker(const std::string& stuck, const std::string& good,
                             const MeshFile& mesh, const Steps& steps) {
  try {
    importInProcess(stuck, mesh, {}, [&] { return std::filesystem::exists(steps.traced); });
    return 1;
  } catch (const MeshError& error) {
    if (std::string(error.what()).find("cannot be killed") == std::string::npos) return 2;
    if (error.fault() != MeshFault::kFileSystem) return 6;
  }
  if (!hasChildren()) return 3;
  std::ofstream(steps.number + ".given_up") << "";
  if (!becomesTrue([&] { return std::filesystem::exists(steps.released); })) return 4;
  importInProcess(good, mesh, {});
  return hasChildren() ? 5 : 0;
}

/// A process that another one traces is not seen to end by its parent until the other one lets it
/// go; to its parent it looks like one that waits for a file system which does not answer.
TEST_F(MeshProcess, AWorkerThatDoesNotEndWhenItIsKilledHoldsNobodyUp) {
  const Steps steps(folder_);
  const std::string stuck = script("echo $$ >'" + steps.number + "'; exec sleep 1000");
  const pid_t importer = fork();
  if (importer == 0) _exit(importBesideAStuckWorker(stuck, real_, stl_, steps));
  EXPECT_TRUE(becomesTrue([&] { return numberIn(steps.number) > 0; }));
  const pid_t worker = numberIn(steps.number);
  const bool is_traced = ptrace(PTRACE_SEIZE, worker, nullptr, nullptr) == 0;
  std::ofstream(steps.traced) << "";
  const auto start = std::chrono::steady_clock::now();
  const auto given_up = [&] { return std::filesystem::exists(steps.number + ".given_up"); };
  if (is_traced) {
    EXPECT_TRUE(becomesTrue(given_up)) << "waits for the worker without end";
    EXPECT_LT(std::chrono::steady_clock::now() - start, kGivenUp);
    EXPECT_EQ(waitpid(worker, nullptr, __WALL), worker);  // as its tracer
  }
  std::ofstream(steps.released) << "";
  int status = -1;
  EXPECT_TRUE(becomesTrue([&] { return waitpid(importer, &status, WNOHANG) == importer; }));
  if (!is_traced) GTEST_SKIP() << "skipped: no process may be traced here";
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

/// 0 if a mesh is refused where no process can start, and its file is not blamed.
int importWithoutProcesses(const std::string& worker, const MeshFile& mesh) {
  if (!forbidThreads()) return 2;
  try {
    importInProcess(worker, mesh, {});
    return 3;
  } catch (const MeshError& error) {
    const bool is_named = std::string(error.what()).find("cannot run") != std::string::npos;
    return is_named && error.fault() == MeshFault::kComputer ? 0 : 1;
  }
}

TEST_F(MeshProcess, WhereNoProcessCanStartTheMeshIsRefused) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::all);
  const pid_t child = fork();
  if (child == 0) _exit(importWithoutProcesses(real_, stl_));
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(MeshProcess, NoProgramStartsWithoutTheOutputThatItIsGiven) {
  EXPECT_THROW(ChildProcess({"/bin/true"}, -1), std::system_error);
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

TEST_F(MeshProcess, OneFileIsNotBlamedForWhatIsReadBesideIt) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const MeshFile good{folder_.write("meshes/good.off", off + "3 0 1 2\n"), folder_ / "meshes"};
  const MeshFile bad{folder_.write("meshes/bad.off", off + "3 0 1 9\n"), folder_ / "meshes"};
  const auto accepted = [&](const MeshFile& file) {
    int count = 0;
    for (int i = 0; i < 20; ++i) {
      try {
        count += importInProcess(real_, file, {}).triangles.size() == 1;
      } catch (const MeshError&) {
      }
    }
    return count;
  };
  int bad_accepted = -1;
  std::thread other([&] { bad_accepted = accepted(bad); });
  EXPECT_EQ(accepted(good), 20);
  other.join();
  EXPECT_EQ(bad_accepted, 0);
}

}  // namespace
}  // namespace link_bounds
