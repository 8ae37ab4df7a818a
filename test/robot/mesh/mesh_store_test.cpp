// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each file is read once, shared while it is in use, and read again when it was replaced: in random
// sequences in mesh_store_sequences_test.cpp, here what these do not have.
#include "link_bounds/robot/mesh/mesh_store.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "robot/threads/row_threads.h"
#include "testing/ordinary_user.h"
#include "testing/patience.h"
#include "testing/sanitized.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

/// Reads a file whose text is a number n as a triangle of size n; other text is an error.
TriangleMesh readTriangle(const MeshFile& file) {
  float size = 0;
  if (!(std::ifstream(file.path) >> size)) throw MeshError("it is no number");
  return {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
}

constexpr char kReason[] = "it is no number; repair or replace the file";

class MeshStoreTest : public testing::Test {
 protected:
  MeshFile write(const std::string& name, const std::string& text) const {
    return {folder_.write(name, text), folder_.path().string()};
  }

  /// Rewrites a file and makes sure that its time differs, even if the clock is coarse.
  void replace(const MeshFile& file, const std::string& text) const {
    const auto before = std::filesystem::last_write_time(file.path);
    std::ofstream(file.path) << text;
    std::filesystem::last_write_time(file.path, before + std::chrono::seconds(1));
  }

  LoadedMesh loadOne(const MeshFile& file) { return store_.load({file}).at(0); }

  LoadedMesh loadWithTriangles(const MeshFile& file) {
    return store_.load({file}, nullptr, MeshContent::kPointsAndTriangles).at(0);
  }

  int imports() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return imports_;
  }

  TemporaryFolder folder_;
  std::mutex mutex_;
  int imports_ = 0;
  MeshStore store_{[this](const MeshFile& file) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++imports_;
    }
    return readTriangle(file);
  }};
};

/// A mesh that may not name a file of one root may name it of another one.
TEST_F(MeshStoreTest, OneFileOfTwoRootsIsReadForEach) {
  const MeshFile wide = write("a.txt", "2");
  const MeshFile narrow{wide.path, wide.root + "/none"};
  MeshStore store([&](const MeshFile& file) {
    if (file.root == narrow.root) throw MeshError("it names a file outside");
    return readTriangle(file);
  });
  for (int i = 0; i < 2; ++i) {
    const std::vector<LoadedMesh> meshes = store.load({narrow, wide});
    EXPECT_EQ(meshes[0].points, nullptr);
    EXPECT_EQ(meshes[0].error, "it names a file outside; repair or replace the file");
    EXPECT_TRUE(meshes[1].points) << meshes[1].error;
  }
}

double sizeOf(const LoadedMesh& mesh) {
  return mesh.points->magnitude().x();
}

/// Whichever thread it comes from.
TEST_F(MeshStoreTest, WhatACallbackThrowsIsThrown) {
  std::vector<MeshFile> files;
  for (int i = 0; i < 8; ++i)
    files.push_back(write(std::to_string(i), std::to_string(i + 1)));
  const auto fail = [](std::size_t done, std::size_t) {
    if (done == 3) throw std::bad_alloc();
  };
  EXPECT_THROW(store_.load(files, fail), std::bad_alloc);
  EXPECT_EQ(store_.load(files).size(), files.size());
}

TEST_F(MeshStoreTest, AReplacedFileIsReadAnewAndOldPointsLiveOn) {
  const MeshFile file = write("a", "1");
  const LoadedMesh old = loadOne(file);
  replace(file, "2");
  EXPECT_EQ(sizeOf(loadOne(file)), 2);
  EXPECT_EQ(sizeOf(old), 1);
  EXPECT_EQ(imports(), 2);
}

TEST_F(MeshStoreTest, TrianglesAreThereOnlyWhereTheyAreAskedFor) {
  const MeshFile file = write("a", "1");
  EXPECT_FALSE(loadOne(file).triangles);
  const LoadedMesh mesh = loadWithTriangles(file);
  ASSERT_TRUE(mesh.triangles);
  EXPECT_EQ(mesh.triangles->triangles.size(), 1u);
  EXPECT_FALSE(loadWithTriangles(write("bad", "x")).triangles);
}

TEST_F(MeshStoreTest, NothingIsAskedOfAnEmptyList) {
  EXPECT_TRUE(store_.load({}).empty());
  EXPECT_EQ(imports(), 0);
}

TEST_F(MeshStoreTest, AMeshIsReadAnewWhenAFileThatItsReaderOpenedOrLookedForIsNew) {
  const MeshFile file = write("a", "mesh"), named = write("b", "1"), other = write("c", "1");
  const std::string missing = folder_ / "d";
  int reads = 0;
  MeshStore store([&](const MeshFile&) {
    ++reads;
    FileVersions files;
    for (const std::string& path : {named.path, missing})
      files[path] = fileVersion(path);
    return ImportedMesh(readTriangle(named), files);
  });
  LoadedMesh now = store.load({file}).at(0);
  const auto expectRead = [&](bool is_read, const char* what) {
    EXPECT_EQ(store.find(file) == nullptr, is_read) << what;
    const int before = reads;
    const LoadedMesh next = store.load({file}).at(0);
    EXPECT_EQ(next.points != now.points, is_read) << what;
    EXPECT_EQ(reads - before, is_read ? 1 : 0) << what;
    now = next;
  };
  expectRead(false, "nothing happened");
  replace(other, "2");
  expectRead(false, "another file is new");
  replace(named, "2");
  expectRead(true, "a file that was opened is new");
  EXPECT_EQ(sizeOf(now), 2);
  std::ofstream(missing) << "1";
  expectRead(true, "a file that was looked for is there");
  std::filesystem::remove(missing);
  expectRead(true, "it is gone");
  std::filesystem::create_directory(missing);
  expectRead(false, "a folder is no file");
  std::ofstream(missing + "/e") << "1";
  expectRead(false, "nor is what is in it");
  std::filesystem::create_symlink(other.path, missing + "/link");
  std::filesystem::remove(named.path);
  std::filesystem::create_symlink(missing + "/link", named.path);
  expectRead(true, "a link to a link to another file");
  replace(other, "3");
  expectRead(true, "the file behind the links is new");
  EXPECT_EQ(sizeOf(now), 3);
}

TEST_F(MeshStoreTest, AFileThatChangesAfterItsReaderOpenedItIsRefused) {
  const MeshFile file = write("a", "mesh"), named = write("b", "1");
  MeshStore store([&](const MeshFile&) {
    const FileVersions files{{named.path, fileVersion(named.path)}};
    replace(named, "2");
    return ImportedMesh(readTriangle(named), files);
  });
  const LoadedMesh mesh = store.load({file}).at(0);
  EXPECT_FALSE(mesh.points);
  EXPECT_EQ(mesh.error, "it changed while it was read; try again when it is complete");
}

TEST_F(MeshStoreTest, AFileOfAFarFutureIsReadOnceAndAnewWhenItIsRewritten) {
  const MeshFile file = write("a", "1");
  // In the year 2400; 64 bits of nanoseconds end in 2262.
  const std::array<timespec, 2> times{{{13569465600, 0}, {13569465600, 0}}};
  ASSERT_EQ(utimensat(AT_FDCWD, file.path.c_str(), times.data(), 0), 0);
  const LoadedMesh old = loadOne(file);
  EXPECT_EQ(loadOne(file).points, old.points);
  EXPECT_EQ(imports(), 1);
  std::ofstream(file.path) << "2";
  ASSERT_EQ(utimensat(AT_FDCWD, file.path.c_str(), times.data(), 0), 0);
  EXPECT_EQ(sizeOf(loadOne(file)), 2);
}

TEST_F(MeshStoreTest, MemoryIsFreedWhenNobodyUsesIt) {
  const MeshFile file = write("a", "1");
  std::weak_ptr<const PointSet> watched = loadOne(file).points;
  EXPECT_TRUE(watched.expired());
  EXPECT_TRUE(loadOne(file).points) << "and read again when needed";
  EXPECT_EQ(imports(), 2);
}

TEST_F(MeshStoreTest, TrianglesAreNotKept) {
  const MeshFile file = write("a", "1");
  LoadedMesh mesh = loadWithTriangles(file);
  const std::weak_ptr<const TriangleMesh> watched = mesh.triangles;
  mesh.triangles = nullptr;
  EXPECT_TRUE(watched.expired());
}

TEST_F(MeshStoreTest, RunningOutOfMemoryIsAFailureOfThatFileAlone) {
  const MeshFile huge = write("huge", "1");
  MeshStore store([&](const MeshFile& file) {
    if (file.path == huge.path) throw std::bad_alloc();
    return readTriangle(file);
  });
  const auto meshes = store.load({huge, write("small", "1")});
  EXPECT_NE(meshes[0].error.find("memory"), std::string::npos);
  EXPECT_TRUE(meshes[1].points);
}

TEST_F(MeshStoreTest, ProgressCountsTheFilesThatAreNew) {
  const MeshFile known = write("known", "1");
  const LoadedMesh kept = loadOne(known);
  std::vector<std::pair<std::size_t, std::size_t>> calls;
  store_.load({known, write("a", "1"), write("b", "x"), write("a", "1"), write("c", "3")},
              [&](std::size_t done, std::size_t total) { calls.emplace_back(done, total); });
  EXPECT_EQ(calls, (std::vector<std::pair<std::size_t, std::size_t>>{{1, 3}, {2, 3}, {3, 3}}));
}

TEST_F(MeshStoreTest, ManyFilesEachOnce) {
  std::vector<MeshFile> files;
  for (int i = 1; i <= 200; ++i)
    files.push_back(write(std::to_string(i), std::to_string(i)));
  const auto meshes = store_.load(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(sizeOf(meshes[i]), static_cast<double>(i + 1));
  }
  EXPECT_EQ(imports(), 200);
}

TEST_F(MeshStoreTest, TheRemedyFollowsFromTheFault) {
  const auto import = [](const MeshFile&) -> TriangleMesh {
    throw MeshError("too slow", MeshFault::kTooSlow);
  };
  const auto remedy = [](MeshFault fault) {
    return fault == MeshFault::kTooSlow ? "wait" : "another";
  };
  const MeshFile file = write("a", "1");
  EXPECT_EQ(MeshStore(import, remedy).load({file}).at(0).error, "too slow; wait");
  EXPECT_EQ(MeshStore(import).load({file}).at(0).error, "too slow; simplify the mesh");
}

TEST_F(MeshStoreTest, AReasonThatDoesNotFitIntoMemoryHarmsNoOtherFile) {
  const auto remedy = [](MeshFault) -> std::string { throw std::bad_alloc(); };
  MeshStore store(readTriangle, remedy);
  std::vector<MeshFile> files{write("good", "1")};
  for (int i = 0; i < 20; ++i)
    files.push_back(write("bad" + std::to_string(i), "x"));
  const auto meshes = store.load(files);
  EXPECT_TRUE(meshes[0].points);
  for (std::size_t i = 1; i < files.size(); ++i)
    EXPECT_EQ(meshes[i].error, "out of memory");
}

TEST_F(MeshStoreTest, AFileThatIsBrokenOnlyWhileItIsWrittenHasChanged) {
  MeshStore store([&](const MeshFile& mesh) {
    replace(mesh, "x");
    return readTriangle(mesh);
  });
  EXPECT_EQ(store.load({write("a", "1")}).at(0).error,
            "it changed while it was read; try again when it is complete");
}

TEST_F(MeshStoreTest, AFileThatChangesWhileItIsReadIsRefusedUntilForgotten) {
  const MeshFile file = write("a", "1");
  bool changes = true;
  MeshStore store([&](const MeshFile& mesh) {
    if (changes) replace(mesh, "2");
    return readTriangle(mesh);
  });
  EXPECT_NE(store.load({file}).at(0).error.find("changed while it was read"), std::string::npos);
  changes = false;
  EXPECT_FALSE(store.load({file}).at(0).points);
  store.forgetFailures();
  EXPECT_EQ(sizeOf(store.load({file}).at(0)), 2);
}

TEST_F(MeshStoreTest, AChangeRightAfterTheFileWasWrittenIsSeen) {
  for (int i = 0; i < 20; ++i) {
    const MeshFile file = write("a" + std::to_string(i), "1");
    MeshStore store([](const MeshFile& mesh) {
      std::ofstream(mesh.path) << "2";
      return readTriangle(mesh);
    });
    EXPECT_FALSE(store.load({file}).at(0).points);
  }
}

/// Writes a file again and again while it lives.
class Writer {
 public:
  explicit Writer(std::string path)
      : thread_([this, path = std::move(path)] {
          while (!is_over_)
            std::ofstream(path) << "1";
        }) {}
  ~Writer() {
    is_over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

TEST_F(MeshStoreTest, AFileThatIsWrittenOnAndOnIsNotWaitedForForEver) {
  const MeshFile file = write("a", "1");
  std::future<LoadedMesh> loading;  // where it does not end, it does when nobody writes
  const Writer writer(file.path);
  loading = std::async(std::launch::async, [&] { return loadOne(file); });
  EXPECT_EQ(loading.wait_for(deadline()), std::future_status::ready);
  EXPECT_EQ(imports(), 1);
}

TEST_F(MeshStoreTest, AFileThatIsWrittenOnAndOnIsNotReadOnceItIsCancelled) {
  const MeshFile file = write("a", "1");
  const Writer writer(file.path);
  int calls = 0;
  const auto is_cancelled = [&calls] { return ++calls > 2; };
  const auto mesh = store_.load({file}, nullptr, MeshContent::kPoints, {}, is_cancelled).at(0);
  EXPECT_TRUE(mesh.is_cancelled);
  EXPECT_EQ(imports(), 0);
}

TEST_F(MeshStoreTest, FilesAreImportedSideBySide) {
  if (coreCount() < 2) GTEST_SKIP() << "skipped: a single core";
  constexpr auto kDeadline = std::chrono::seconds(20);
  std::mutex mutex;
  std::condition_variable arrived;
  int waiting = 0;
  bool met = true;
  MeshStore store([&](const MeshFile& file) {
    std::unique_lock<std::mutex> lock(mutex);
    ++waiting;
    arrived.notify_all();
    met &= arrived.wait_for(lock, kDeadline, [&] { return waiting >= 2; });
    return readTriangle(file);
  });
  store.load({write("a", "1"), write("b", "2")});
  EXPECT_TRUE(met) << "the second import began only after the first was over";
}

bool canLoad(const std::vector<MeshFile>& files) {
  MeshStore store([](const MeshFile&) {
    return TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  });
  for (const LoadedMesh& mesh : store.load(files)) {
    if (!mesh.points) return false;
  }
  return true;
}

TEST_F(MeshStoreTest, WhereNoThreadCanStartFilesAreImportedOneByOne) {
  const std::vector<MeshFile> files{write("a", "1"), write("b", "2"), write("c", "3")};
  EXPECT_TRUE(isTrueWithoutThreads([&] { return canLoad(files); }));
}

constexpr int kBall = repetitions(100000);

/// Of many points that can all be extreme, so that their table takes more than half a second.
TriangleMesh ball() {
  TriangleMesh mesh;
  for (int i = 0; i < kBall; ++i) {
    const double z = 1 - 2.0 / kBall * i;
    const double r = std::sqrt(1 - z * z);
    mesh.vertices.emplace_back(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
    const auto k = static_cast<std::uint32_t>(i);
    if (i >= 2) mesh.triangles.push_back({k, k - 1, k - 2});
  }
  return mesh;
}

TEST_F(MeshStoreTest, PreparingAMeshCountsToItsTime) {
  MeshStore store([mesh = ball()](const MeshFile&) { return mesh; });
  const MeshFile file = write("ball", "");
  MeshLimits limits;
  limits.timeout = 0.05;
  const LoadedMesh late = store.load({file}, nullptr, MeshContent::kPoints, limits).at(0);
  EXPECT_FALSE(late.points);
  EXPECT_EQ(late.error, "loading it takes longer than 0.05 s; simplify the mesh");
  store.forgetFailures();
  const LoadedMesh whole = store.load({file}).at(0);
  EXPECT_EQ(whole.points->size(), static_cast<std::size_t>(kBall));
}

TEST_F(MeshStoreTest, ATreeThatTakesTooLongLeavesThePoints) {
  MeshStore store([mesh = ball()](const MeshFile&) { return mesh; });
  const MeshFile file = write("ball", "");
  const auto points = store.load({file}).at(0).points;
  MeshLimits limits;
  limits.timeout = 0.01;
  const LoadedMesh mesh = store.load({file}, nullptr, MeshContent::kPointsAndTree, limits).at(0);
  EXPECT_EQ(mesh.points, points);
  EXPECT_FALSE(mesh.tree);
  EXPECT_EQ(mesh.tree_error, "loading it takes longer than 0.01 s; simplify the mesh");
}

TEST_F(MeshStoreTest, ACancelledLoadIsNoFailureOfTheFile) {
  std::atomic<int> calls{0};
  const MeshFile file = write("ball", "");
  MeshStore store([mesh = ball()](const MeshFile&) { return mesh; });
  const LoadedMesh mesh =
      store.load({file}, nullptr, MeshContent::kAll, {}, [&calls] { return ++calls == 10; }).at(0);
  EXPECT_TRUE(mesh.is_cancelled);
  EXPECT_FALSE(mesh.points);
  EXPECT_EQ(calls, 10);
  EXPECT_TRUE(store.load({file}).at(0).points);
}

TEST_F(MeshStoreTest, AFailureThatBeganBeforeFailuresWereForgottenIsNotRemembered) {
  const MeshFile file = write("a", "1");
  MeshStore* store = nullptr;
  int reads = 0;
  MeshStore forgetful([&](const MeshFile& read) {
    if (++reads > 1) return readTriangle(read);
    store->forgetFailures();
    throw MeshError("it is no number");
  });
  store = &forgetful;
  EXPECT_EQ(store->load({file}).at(0).error, kReason);
  EXPECT_TRUE(store->load({file}).at(0).points);
}

TEST_F(MeshStoreTest, LoadsOfOneFileAtOnceShareItsPoints) {
  const MeshFile file = write("a", "1");
  MeshStore* store = nullptr;
  bool is_outer = true;
  std::shared_ptr<const PointSet> inner;
  MeshStore shared([&](const MeshFile& read) {
    if (std::exchange(is_outer, false)) inner = store->load({file}).at(0).points;
    return readTriangle(read);
  });
  store = &shared;
  const auto outer = store->load({file}).at(0).points;
  EXPECT_TRUE(outer);
  EXPECT_EQ(outer, inner);
  EXPECT_EQ(store->load({file}).at(0).points, inner);
}

}  // namespace
}  // namespace link_bounds
