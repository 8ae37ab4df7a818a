// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A map of weak pointers, and threads that import the files that are not in it.
#include "link_bounds/robot/mesh/mesh_store.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <thread>

namespace link_bounds {
namespace {

constexpr char kChangedReason[] = "it changed while it was read";

/// Twice the longest tick of the kernel clock that sets the times of files (10 ms at 100 Hz). Two
/// writes within one tick give the same time.
constexpr std::chrono::milliseconds kFileTick(20);

bool areEqual(const timespec& a, const timespec& b) {
  return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// In seconds; as double, because a file may claim any time.
double secondsSince(const timespec& time) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec) - static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - time.tv_nsec);
}

/// Starts fewer threads than `count` if the system refuses more.
std::vector<std::thread> startThreads(std::size_t count, const std::function<void()>& work) {
  std::vector<std::thread> threads;
  threads.reserve(count);
  try {
    for (std::size_t i = 0; i < count; ++i)
      threads.emplace_back(work);
  } catch (const std::exception&) {
    // The threads that started and the calling one do the work.
  }
  return threads;
}

/// Calls job(0) ... job(count - 1), each once, on as many threads as there are cores.
void inParallel(std::size_t count, const std::function<void(std::size_t)>& job) {
  if (count == 0) return;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++)
      job(i);
  };
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> helpers = startThreads(std::min(cores, count) - 1, work);
  work();
  for (std::thread& helper : helpers)
    helper.join();
}

bool hasTriangles(MeshContent content) {
  return content == MeshContent::kPointsAndTriangles || content == MeshContent::kAll;
}

bool hasTree(MeshContent content) {
  return content == MeshContent::kPointsAndTree || content == MeshContent::kAll;
}

}  // namespace

bool MeshStore::Version::operator==(const Version& other) const {
  return device == other.device && inode == other.inode && size == other.size &&
         areEqual(written, other.written) && areEqual(changed, other.changed);
}

MeshStore::Version MeshStore::versionOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, static_cast<std::uintmax_t>(status.st_size), status.st_mtim,
          status.st_ctim};
}

/// Waits until a tick has passed since the last write, so that every later write gives a new
/// version.
MeshStore::Version MeshStore::settledVersionOf(const std::string& path) {
  const Version version = versionOf(path);
  const double age = secondsSince(version.changed);
  if (age < 0 || age > std::chrono::duration<double>(kFileTick).count()) return version;
  std::this_thread::sleep_for(kFileTick);
  return versionOf(path);
}

LoadedMesh MeshStore::cached(const MeshFile& file) const {
  const auto found = entries_.find(file.path);
  if (found == entries_.end()) return {};
  const Entry& entry = found->second;
  if (!entry.error.empty()) return {nullptr, entry.error};
  if (!(entry.version == versionOf(file.path))) return {};
  return {entry.points.lock(), ""};
}

/// If only triangles or the tree are new, the points that are in use are returned.
LoadedMesh MeshStore::import(const MeshFile& file, const Version& version,
                             const Request& request) const {
  try {
    const auto mesh = std::make_shared<const TriangleMesh>(importer_(file));
    if (!(versionOf(file.path) == version)) return failure(kChangedReason, MeshFault::kChanged);
    LoadedMesh result{cached(file).points, ""};
    if (!result.points) result.points = std::make_shared<const PointSet>(mesh->vertices);
    if (hasTriangles(request.content)) result.triangles = mesh;
    if (hasTree(request.content)) addTree(*mesh, request.max_tree_bytes, result);
    return result;
  } catch (const std::bad_alloc&) {
    return failure("it does not fit into memory", MeshFault::kComputer);
  } catch (const MeshError& error) {
    const bool is_half_written =
        error.fault() == MeshFault::kFile && !(versionOf(file.path) == version);
    if (is_half_written) return failure(kChangedReason, MeshFault::kChanged);
    return failure(error.what(), error.fault());
  } catch (const std::exception& error) {
    return failure(error.what(), MeshFault::kFile);
  }
}

void MeshStore::addTree(const TriangleMesh& mesh, std::uint64_t max_bytes,
                        LoadedMesh& result) const {
  const auto fail = [&](const char* reason, MeshFault fault) {
    result.tree_error = failure(reason, fault).error;
  };
  try {
    const std::uint64_t needed = maxTreeBytes(mesh);
    if (needed > max_bytes) {
      const std::string reason = "its " + std::to_string(mesh.triangles.size()) +
                                 " triangles could take " + std::to_string(needed) +
                                 " bytes of memory, which are more than the " +
                                 std::to_string(max_bytes) + " allowed";
      return fail(reason.c_str(), MeshFault::kTooLarge);
    }
    result.tree = triangleTree(mesh);
    if (!result.tree) fail("a coordinate exceeds 1e30 m", MeshFault::kFile);
  } catch (const std::bad_alloc&) {
    fail("its triangles do not fit into memory", MeshFault::kComputer);
  }
}

/// If even the words do not fit into memory, shorter ones that need no allocation.
LoadedMesh MeshStore::failure(const char* reason, MeshFault fault) const noexcept {
  try {
    return {nullptr, std::string(reason) + "; " + remedy_(fault)};
  } catch (const std::exception&) {
    return {nullptr, "out of memory"};
  }
}

std::map<std::string, MeshStore::Imported> MeshStore::importAll(
    const std::map<std::string, MeshFile>& files, const Request& request) const {
  std::map<std::string, Imported> results;
  std::vector<std::pair<const MeshFile*, Imported*>> jobs;
  for (const auto& [path, file] : files)
    jobs.emplace_back(&file, &results[path]);
  std::mutex mutex;
  std::size_t done = 0;
  inParallel(jobs.size(), [&](std::size_t i) {
    const MeshFile& file = *jobs[i].first;
    const Version version = settledVersionOf(file.path);
    *jobs[i].second = {version, import(file, version, request)};
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (request.progress) request.progress(done, jobs.size());
  });
  return results;
}

std::vector<LoadedMesh> MeshStore::load(const std::vector<MeshFile>& files,
                                        const LoadProgress& progress, MeshContent content,
                                        std::uint64_t max_tree_bytes) {
  std::map<std::string, LoadedMesh> meshes;
  std::map<std::string, MeshFile> missing;
  for (const MeshFile& file : files) {
    if (meshes.count(file.path) || missing.count(file.path)) continue;
    LoadedMesh mesh = cached(file);
    const bool has_content = mesh.points && content == MeshContent::kPoints;
    if (has_content || !mesh.error.empty()) {
      meshes.emplace(file.path, std::move(mesh));
    } else {
      missing.emplace(file.path, file);
    }
  }
  for (auto& [path, imported] : importAll(missing, {progress, content, max_tree_bytes})) {
    const bool only_triangles_failed = !imported.mesh.points && cached(missing.at(path)).points;
    if (!only_triangles_failed)
      entries_[path] = {imported.version, imported.mesh.points, imported.mesh.error};
    meshes.emplace(path, std::move(imported.mesh));
  }
  std::vector<LoadedMesh> results;
  for (const MeshFile& file : files)
    results.push_back(meshes.at(file.path));
  return results;
}

void MeshStore::forgetFailures() {
  // A failure has no points, so it is erased with the entries whose points nobody uses.
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.points.expired() ? entries_.erase(entry) : std::next(entry);
}

}  // namespace link_bounds
