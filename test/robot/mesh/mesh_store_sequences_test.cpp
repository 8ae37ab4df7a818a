// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of loads and of changes to the files, compared with reading each file anew.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <map>

#include "link_bounds/robot/mesh/mesh_store.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "testing/brute_force.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 500;
constexpr std::size_t kFiles = 5;
constexpr std::size_t kParts = 3;
constexpr char kPart[] = "part";  // then a digit

/// The file that a mesh names; "" if it names none.
std::string partOf(const MeshFile& file) {
  std::string word;
  std::ifstream(file.path) >> word;
  return word.rfind(kPart, 0) == 0 ? (fs::path(file.path).parent_path() / word).string() : "";
}

/// Reads a file whose text is a number n as a triangle of size n. The number may be in another
/// file, which it names, if that is below the root; other text is an error.
ImportedMesh triangleIn(const MeshFile& file) {
  FileVersions files;
  const std::string part = partOf(file);
  if (!part.empty() && !isBelow(file.root, part)) throw MeshError("it is no number");
  if (!part.empty()) files[part] = fileVersion(part);
  float size = 0;
  if (!(std::ifstream(part.empty() ? file.path : part) >> size)) throw MeshError("it is no number");
  return {TriangleMesh{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}}, files};
}

/// What MeshStore promises for one file of one root.
struct Expectation {
  bool has_failed = false;  ///< since failures were forgotten
  bool has_changed = true;  ///< it or its part, since it was last imported
  std::string part;         ///< then
  std::weak_ptr<const PointSet> points;
};

class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : random_(seed) {
    for (std::size_t i = 0; i < kFiles; ++i)
      paths_.push_back(folder_.write(std::to_string(i), "1"));
    for (std::size_t i = 0; i < kParts; ++i)
      parts_.push_back(folder_.write(kPart + std::to_string(i), "1"));
  }

  void run() {
    for (int step = 0; step < kSteps && !testing::Test::HasFailure(); ++step) {
      switch (below(6)) {
        case 0:
          changeFile(paths_[below(kFiles)], below(2) == 0);
          break;
        case 1:
          changeFile(parts_[below(kParts)], false);
          break;
        case 2:
          held_.clear();
          break;
        case 3:
          if (below(4) == 0) forgetFailures();
          break;
        default:
          load();
      }
    }
  }

 private:
  using Key = std::pair<std::string, std::string>;  ///< path and root

  static Key keyOf(const MeshFile& file) { return {file.path, file.root}; }

  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform(0, 1) * static_cast<double>(count)) % count;
  }

  std::string number() { return std::to_string(1 + below(9)); }

  void changeFile(const std::string& path, bool names_part) {
    for (auto& [mesh, file] : expected_)
      file.has_changed = file.has_changed || mesh.first == path || file.part == path;
    const std::string text = names_part ? kPart + std::to_string(below(kParts)) : number();
    const auto time = fs::exists(path) ? fs::last_write_time(path) : fs::file_time_type();
    switch (below(6)) {
      case 0:
        std::ofstream(path) << text;
        return;
      case 1:
        std::ofstream(path) << "broken";
        return;
      case 2:
        fs::remove(path);
        return;
      case 3:  // touched
        std::ofstream(path, std::ios::app).close();
        fs::last_write_time(path, time + std::chrono::seconds(1));
        return;
      case 4:  // in place, as old
        std::ofstream(path) << text;
        fs::last_write_time(path, time);
        return;
      default:  // replaced by one that is as old
        const std::string other = folder_.write("other", text);
        fs::last_write_time(other, time);
        fs::rename(other, path);
    }
  }

  void forgetFailures() {
    store_.forgetFailures();
    for (auto& [key, file] : expected_)
      file.has_failed = false;
  }

  void load() {
    constexpr std::array kContents{MeshContent::kPoints, MeshContent::kPoints,
                                   MeshContent::kPointsAndTriangles, MeshContent::kPointsAndTree,
                                   MeshContent::kAll};
    const MeshContent content = kContents[below(kContents.size())];
    std::vector<MeshFile> batch;
    for (std::size_t i = 1 + below(4); i > 0; --i)
      batch.push_back({paths_[below(kFiles)], folder_.path().string() + (below(4) ? "" : "/none")});
    std::map<Key, bool> is_imported;
    for (const MeshFile& file : batch) {
      const Expectation& now = expected_[keyOf(file)];
      const bool is_known = !now.has_changed && !now.points.expired();
      is_imported[keyOf(file)] = !now.has_failed && (!is_known || content != MeshContent::kPoints);
    }
    imports_ = 0;
    const std::vector<LoadedMesh> meshes = store_.load(batch, nullptr, content);
    int expected_imports = 0;
    for (const auto& [key, imported] : is_imported)
      expected_imports += imported;
    EXPECT_EQ(imports_, expected_imports);
    for (std::size_t i = 0; i < batch.size(); ++i)
      check(batch[i], meshes[i], content);
    if (below(2) == 0) held_.insert(held_.end(), meshes.begin(), meshes.end());
  }

  void check(const MeshFile& file, const LoadedMesh& mesh, MeshContent content) {
    Expectation& now = expected_[keyOf(file)];
    if (now.has_failed) {
      EXPECT_FALSE(mesh.points) << "failures are remembered";
      EXPECT_EQ(mesh.error, "it is no number; repair or replace the file");
      return;
    }
    try {
      const PointSet points(triangleIn(file).vertices);
      ASSERT_TRUE(mesh.points) << mesh.error;
      EXPECT_EQ(mesh.points->magnitude(), points.magnitude());
      EXPECT_EQ(mesh.error, "");
      const bool is_all = content == MeshContent::kAll;
      EXPECT_EQ(mesh.triangles != nullptr, is_all || content == MeshContent::kPointsAndTriangles);
      EXPECT_EQ(mesh.tree != nullptr, is_all || content == MeshContent::kPointsAndTree);
      const auto shared = now.points.lock();
      EXPECT_TRUE(!shared || now.has_changed || mesh.points == shared) << "points are shared";
      now.points = mesh.points;
    } catch (const MeshError&) {
      EXPECT_FALSE(mesh.points);
      EXPECT_EQ(mesh.error, "it is no number; repair or replace the file");
      now.has_failed = true;
      now.points.reset();
    }
    now.has_changed = false;
    now.part = partOf(file);
  }

  brute_force::Random random_;
  TemporaryFolder folder_;
  std::vector<std::string> paths_;
  std::vector<std::string> parts_;
  std::map<Key, Expectation> expected_;
  std::vector<LoadedMesh> held_;
  std::atomic<int> imports_{0};
  MeshStore store_{[this](const MeshFile& file) {
    ++imports_;
    return triangleIn(file);
  }};
};

TEST(MeshStoreSequences, GiveWhatAStoreWithoutMemoryGives) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Sequence(seed).run();
  }
}

}  // namespace
}  // namespace link_bounds
