// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads robots of damaged mesh files and one good file by the real mesh_worker. This process must
// survive all of them and leak nothing; every box must be right or missing.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "box_check.h"
#include "link_bounds/robot/worker/mesh_process.h"
#include "mesh_robot.h"
#include "mutation.h"
#include "outcomes.h"
#include "testing/mesh_texts.h"
#include "testing/process_census.h"
#include "testing/sanitized.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr char kUsage[] =
    "usage: mutated_meshes [--count N] [--seed S] [--timeout SECONDS] [--keep FOLDER]\n"
    "FOLDER is for the meshes that something is wrong with\n";
constexpr std::size_t kBatch = 100;       // meshes of one robot
constexpr long kMemoryGrowth = 32 << 20;  // bytes, from the second batch to the last
constexpr char kGoodFile[] = "good.stl";

struct Options {
  std::size_t count = kIsSanitized ? 140 : 280;
  std::uint64_t seed = 1;
  double timeout = kIsSanitized ? 5 : 1;  // wall seconds for one mesh
  std::string keep;
};

struct Mutant {
  const MeshSeed* seed;
  std::string file;
  std::string content;
};

class MutationRun {
 public:
  explicit MutationRun(Options options)
      : options_(std::move(options)), random_(options_.seed), seeds_(meshSeeds()) {
    loadSeeds();
  }

  /// False if anything was wrong.
  bool run() {
    const long descriptors = openDescriptors();
    std::optional<long> memory;
    for (std::size_t done = 0; done < options_.count; done += kBatch) {
      runBatch(done, std::min(kBatch, options_.count - done));
      if (!memory && done > 0) memory = residentBytes();
    }
    if (openDescriptors() != descriptors) fail("descriptors are left open");
    const long growth = memory ? residentBytes() - *memory : 0;
    if (!kIsSanitized && growth > kMemoryGrowth) fail("memory grows");
    outcomes_.print();
    std::printf("memory grew by %ld KiB\n", growth / 1024);
    checkBalance();
    if (failures_ == 0) std::printf("faults: %zu damaged mesh files\n", options_.count);
    return failures_ == 0;
  }

 private:
  /// Computes the boxes before any damage.
  void loadSeeds() {
    std::vector<std::string> files{kGoodFile};
    folder_.write(kGoodFile, seeds_[0].content);
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      files.push_back("seed" + std::to_string(i) + seeds_[i].extension);
      folder_.write(files.back(), seeds_[i].content);
    }
    const MeshRobot robot = meshRobot(folder_.path(), files, MeshLimits().timeout);
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      const BoundedLink& link = robot.links.at(i + 1);
      if (!link.isWhole()) throw std::runtime_error(seeds_[i].format + ": " + link.missing);
      seed_bounds_[seeds_[i].format] = boundsOf(robot.meshes.at(link.name));
    }
    good_pose_ = random_.rigid(1);
    good_box_ = linkBox(robot.links[0], good_pose_).value();
  }

  void runBatch(std::size_t first, std::size_t count) {
    std::vector<std::string> files{kGoodFile};
    std::vector<Mutant> mutants;
    for (std::size_t i = first; i < first + count; ++i) {
      const MeshSeed& seed = seeds_[i % seeds_.size()];
      mutants.push_back({&seed, std::to_string(i) + seed.extension, mutated(seed, random_)});
      files.push_back(mutants.back().file);
      folder_.write(files.back(), mutants.back().content);
    }
    const MeshRobot robot = meshRobotAmong("85", files);
    if (hasChildren()) fail("a process is left behind");
    checkGood(robot.links.at(0));
    const MeshRobot again = kIsSanitized ? robot : meshRobotAmong("170", files);
    for (std::size_t i = 0; i < count; ++i) {
      check(mutants[i], robot.links.at(i + 1), robot);
      checkSame(mutants[i], robot, again);
      std::filesystem::remove(folder_ / mutants[i].file);
    }
  }

  /// `garbage`: what the worker finds in memory that it did not write, see mallopt(3).
  MeshRobot meshRobotAmong(const char* garbage, const std::vector<std::string>& files) const {
    setenv("MALLOC_PERTURB_", garbage, 1);
    MeshRobot robot = meshRobot(folder_.path(), files, options_.timeout);
    unsetenv("MALLOC_PERTURB_");
    return robot;
  }

  /// A reader may end at a fault or at the timeout in one of the two only.
  void checkSame(const Mutant& mutant, const MeshRobot& robot, const MeshRobot& again) {
    const auto one = robot.meshes.find(mutant.file);
    const auto other = again.meshes.find(mutant.file);
    if (one == robot.meshes.end() || other == again.meshes.end()) return;
    if (one->second.vertices == other->second.vertices) return;
    fail(mutant.file + " (" + mutant.seed->format + "): its vertices depend on what was in memory");
    keep(mutant);
  }

  void checkGood(const BoundedLink& link) {
    const std::optional<Aabb> box = linkBox(link, good_pose_);
    const bool is_same = box && box->min() == good_box_.min() && box->max() == good_box_.max();
    if (!is_same) fail("the box of the good link is another one");
  }

  void check(const Mutant& mutant, const BoundedLink& link, const MeshRobot& robot) {
    const auto mesh = robot.meshes.find(mutant.file);
    std::string fault;
    if (mesh == robot.meshes.end()) {
      outcomes_.add(mutant.seed->format, refusalOf(link.missing));
      fault = faultOfRefused(link);
    } else {
      outcomes_.add(mutant.seed->format, outcomeOf(*mutant.seed, mesh->second));
      fault = faultOfLoaded(link, mesh->second.vertices, obliquePoses(random_));
    }
    if (fault.empty()) return;
    fail(mutant.file + " (" + mutant.seed->format + "): " + fault);
    keep(mutant);
  }

  void keep(const Mutant& mutant) const {
    if (options_.keep.empty()) return;
    std::filesystem::create_directories(options_.keep);
    std::ofstream(options_.keep + "/" + mutant.file, std::ios::binary) << mutant.content;
  }

  Outcome outcomeOf(const MeshSeed& seed, const TriangleMesh& mesh) const {
    const Aabb bounds = boundsOf(mesh);
    const Aabb& before = seed_bounds_.at(seed.format);
    const bool is_same = bounds.min() == before.min() && bounds.max() == before.max();
    return is_same ? Outcome::kSameBox : Outcome::kOtherBox;
  }

  void checkBalance() {
    for (const MeshSeed& seed : seeds_) {
      const std::string imbalance = seed.is_text ? outcomes_.imbalanceOf(seed.format) : "";
      if (!imbalance.empty()) fail(imbalance);
    }
  }

  void fail(const std::string& what) {
    ++failures_;
    std::cerr << "FAILED: " << what << " (--seed " << options_.seed << ")\n";
  }

  Options options_;
  brute_force::Random random_;
  std::vector<MeshSeed> seeds_;
  TemporaryFolder folder_;
  std::map<std::string, Aabb> seed_bounds_;  // by format
  Eigen::Affine3d good_pose_;
  Aabb good_box_;
  Outcomes outcomes_;
  int failures_ = 0;
};

/// nullopt if the arguments are wrong.
std::optional<Options> readOptions(int argc, char** argv) {
  Options options;
  int i = 1;
  for (; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--count") {
      options.count = std::strtoul(argv[i + 1], nullptr, 10);
    } else if (name == "--seed") {
      options.seed = std::strtoul(argv[i + 1], nullptr, 10);
    } else if (name == "--timeout") {
      options.timeout = std::strtod(argv[i + 1], nullptr);
    } else if (name == "--keep") {
      options.keep = argv[i + 1];
    } else {
      return std::nullopt;
    }
  }
  if (i != argc || options.count == 0 || !(options.timeout > 0)) return std::nullopt;
  return options;
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  const auto options = link_bounds::readOptions(argc, argv);
  if (!options) {
    std::fputs(link_bounds::kUsage, stderr);
    return 1;
  }
  // Workers may die of faults in assimp, which are not reported here.
  if (link_bounds::kIsSanitized) setenv("ASAN_OPTIONS", "hard_rss_limit_mb=1024", 1);
  return link_bounds::MutationRun(*options).run() ? 0 : 1;
}
