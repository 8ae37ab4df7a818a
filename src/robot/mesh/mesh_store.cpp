// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A map of weak pointers, and threads that import the files that are not in it.
#include "link_bounds/robot/mesh/mesh_store.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

#include "robot/mesh/erase_dead.h"
#include "robot/mesh/gltf_files.h"
#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

constexpr char kChangedReason[] = "it changed while it was read";

/// Twice the longest tick of the kernel clock that sets the times of files (10 ms at 100 Hz). Two
/// writes within one tick give the same time.
constexpr std::chrono::milliseconds kFileTick(20);
constexpr int kMaxTicks = 50;

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

bool hasTriangles(MeshContent content) {
  return content == MeshContent::kPointsAndTriangles || content == MeshContent::kAll;
}

bool hasTree(MeshContent content) {
  return content == MeshContent::kPointsAndTree || content == MeshContent::kAll;
}

}  // namespace

MeshStore::MeshStore(TimedMeshImporter importer, MeshRemedy remedy)
    : importer_(std::move(importer)), remedy_(std::move(remedy)), max_entries_(kManyMeshes) {}

bool MeshStore::FileVersion::operator==(const FileVersion& other) const {
  return device == other.device && inode == other.inode && size == other.size &&
         areEqual(written, other.written) && areEqual(changed, other.changed);
}

MeshStore::Version MeshStore::versionOf(const std::string& path) {
  Version version;
  for (const std::string& file : filesOf(path)) {
    struct stat status {};
    FileVersion& one = version.emplace_back();
    if (stat(file.c_str(), &status) == 0)
      one = {status.st_dev, status.st_ino, static_cast<std::uintmax_t>(status.st_size),
             status.st_mtim, status.st_ctim};
  }
  return version;
}

/// Waits until a tick has passed since the last write, so that every later write gives a new
/// version; but for a second at most, if somebody goes on writing, and not once it is cancelled.
MeshStore::Version MeshStore::settledVersionOf(const std::string& path,
                                               const std::function<bool()>& is_cancelled) {
  const auto is_settled = [](const FileVersion& file) {
    const double age = secondsSince(file.changed);
    return age < 0 || age > std::chrono::duration<double>(kFileTick).count();
  };
  for (int ticks = 0;; ++ticks) {
    const Version version = versionOf(path);
    const bool is_over = ticks == kMaxTicks || (is_cancelled && is_cancelled());
    if (is_over || std::all_of(version.begin(), version.end(), is_settled)) return version;
    std::this_thread::sleep_for(kFileTick);
  }
}

LoadedMesh MeshStore::cached(const MeshFile& file) const {
  const Version version = versionOf(file.path);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = entries_.find(file.path);
  if (found == entries_.end()) return {};
  const Entry& entry = found->second;
  if (!entry.error.empty()) return {nullptr, entry.error};
  if (!(entry.version == version)) return {};
  return {entry.points.lock(), ""};
}

/// If only triangles or the tree are new, the points that are in use are returned.
LoadedMesh MeshStore::import(const MeshFile& file, const Version& version,
                             const Request& request) const {
  try {
    const CheckInterrupt deadline = meshDeadline(request.limits, request.is_cancelled);
    deadline();
    const auto mesh =
        std::make_shared<const TriangleMesh>(importer_(file, request.limits, deadline));
    if (!(versionOf(file.path) == version)) return failure(kChangedReason, MeshFault::kChanged);
    LoadedMesh result{cached(file).points, ""};
    if (!result.points) result.points = std::make_shared<const PointSet>(mesh->vertices, deadline);
    if (hasTriangles(request.content)) result.triangles = mesh;
    if (hasTree(request.content)) addTree(*mesh, request, deadline, result);
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

void MeshStore::addTree(const TriangleMesh& mesh, const Request& request,
                        const CheckInterrupt& deadline, LoadedMesh& result) const {
  const std::uint64_t max_bytes = request.limits.max_bytes;
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
    result.tree = triangleTree(mesh, deadline);
    if (!result.tree) fail("a coordinate exceeds 1e30 m", MeshFault::kFile);
  } catch (const std::bad_alloc&) {
    fail("its triangles do not fit into memory", MeshFault::kComputer);
  } catch (const MeshError& error) {
    if (error.fault() == MeshFault::kCancelled) throw;
    fail(error.what(), error.fault());
  }
}

/// If even the words do not fit into memory, shorter ones that need no allocation.
LoadedMesh MeshStore::failure(const char* reason, MeshFault fault) const noexcept {
  try {
    LoadedMesh result{nullptr, std::string(reason) + "; " + remedy_(fault)};
    result.is_cancelled = fault == MeshFault::kCancelled;
    return result;
  } catch (const std::exception&) {
    return {nullptr, "out of memory"};
  }
}

LoadedMesh MeshStore::importAndRemember(const MeshFile& file, const Request& request) {
  const Version version = settledVersionOf(file.path, request.is_cancelled);
  LoadedMesh mesh = import(file, version, request);
  remember(file, version, request, mesh);
  return mesh;
}

/// If another load has read the same file meanwhile, its points become those of this one.
void MeshStore::remember(const MeshFile& file, const Version& version, const Request& request,
                         LoadedMesh& mesh) {
  const auto in_use = cached(file).points;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!mesh.points) {
    const bool is_outdated = mesh.is_cancelled || request.generation != generation_;
    // If points are in use, only reading the triangles failed.
    if (!is_outdated && !in_use) entries_[file.path] = {version, {}, mesh.error};
    return;
  }
  eraseDead(entries_, max_entries_,
            [](const Entry& entry) { return entry.error.empty() && entry.points.expired(); });
  Entry& entry = entries_[file.path];
  const auto points = entry.version == version ? entry.points.lock() : nullptr;
  if (points) mesh.points = points;
  entry = {version, mesh.points, ""};
}

std::vector<LoadedMesh> MeshStore::load(const std::vector<MeshFile>& files,
                                        const LoadProgress& progress, MeshContent content,
                                        const MeshLimits& limits,
                                        const std::function<bool()>& is_cancelled) {
  const Request request{content, limits, is_cancelled, generation()};
  std::map<std::string, LoadedMesh> meshes;
  std::vector<std::pair<const MeshFile*, LoadedMesh*>> missing;
  for (const MeshFile& file : files) {
    const auto [entry, is_new] = meshes.try_emplace(file.path);
    if (!is_new) continue;
    LoadedMesh& mesh = entry->second = cached(file);
    const bool has_content = mesh.points && content == MeshContent::kPoints;
    if (!has_content && mesh.error.empty()) missing.emplace_back(&file, &mesh);
  }
  std::mutex mutex;
  std::size_t done = 0;
  forRows(0, missing.size(), coreCount(), 1, [&](unsigned, std::size_t i, std::size_t) {
    *missing[i].second = importAndRemember(*missing[i].first, request);
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (progress) progress(done, missing.size());
  });
  std::vector<LoadedMesh> results;
  for (const MeshFile& file : files)
    results.push_back(meshes.at(file.path));
  return results;
}

std::uint64_t MeshStore::generation() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return generation_;
}

void MeshStore::forgetFailures() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++generation_;
  // A failure has no points, so it is erased with the entries whose points nobody uses.
  for (auto entry = entries_.begin(); entry != entries_.end();)
    entry = entry->second.points.expired() ? entries_.erase(entry) : std::next(entry);
}

}  // namespace link_bounds
