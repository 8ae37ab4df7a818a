// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A map of weak pointers, and threads that import the files that are not in it.
#include "link_bounds/robot/mesh/mesh_store.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <new>

#include "robot/mesh/erase_dead.h"
#include "robot/mesh/file_versions.h"
#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

bool hasTriangles(MeshContent content) {
  return content == MeshContent::kPointsAndTriangles || content == MeshContent::kAll;
}

bool hasTree(MeshContent content) {
  return content == MeshContent::kPointsAndTree || content == MeshContent::kAll;
}

/// The root decides which further files the mesh may name. No path contains a null byte.
std::string keyOf(const MeshFile& file) {
  return file.path + '\0' + file.root;
}

}  // namespace

MeshStore::MeshStore(TimedMeshImporter importer, MeshRemedy remedy)
    : importer_(std::move(importer)), remedy_(std::move(remedy)), max_entries_(kManyMeshes) {}

LoadedMesh MeshStore::cached(const MeshFile& file) const {
  Entry entry;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(keyOf(file));
    if (found == entries_.end()) return {};
    entry = found->second;
  }
  if (!entry.error.empty()) return {nullptr, entry.error};
  if (!areUnchanged(*entry.files)) return {};
  return {entry.points.lock(), ""};
}

/// Returns points that are in use already, so that only triangles or the tree are new. `files` has
/// the mesh file, and gets the other files that the importer opened or looked for.
LoadedMesh MeshStore::import(const MeshFile& file, const Request& request,
                             FileVersions& files) const {
  try {
    const CheckInterrupt deadline = meshDeadline(request.limits, request.is_cancelled);
    deadline();
    ImportedMesh imported = importer_(file, request.limits, deadline);
    files.merge(imported.files);
    if (!areUnchanged(files)) return failure(kChangedReason, MeshFault::kChanged);
    const auto mesh = std::make_shared<const TriangleMesh>(std::move(imported));
    LoadedMesh result{cached(file).points, ""};
    if (!result.points) result.points = std::make_shared<const PointSet>(mesh->vertices, deadline);
    if (hasTriangles(request.content)) result.triangles = mesh;
    if (hasTree(request.content)) addTree(*mesh, request, deadline, result);
    return result;
  } catch (const std::bad_alloc&) {
    return failure("it does not fit into memory", MeshFault::kComputer);
  } catch (const MeshError& error) {
    const bool is_half_written = isOfContent(error.fault()) && !areUnchanged(files);
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

/// If even this text does not fit into memory, returns a shorter one that needs no allocation.
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
  int ticks_left = kMaxFileTicks;
  const auto version = [&] { return fileVersion(file.path); };
  FileVersions files{{file.path, settledVersion(version, ticks_left, request.is_cancelled)}};
  LoadedMesh mesh = import(file, request, files);
  remember(file, std::move(files), request, mesh);
  return mesh;
}

/// If another load has read the same file meanwhile, `mesh` gets the points of that load.
void MeshStore::remember(const MeshFile& file, FileVersions files, const Request& request,
                         LoadedMesh& mesh) {
  const auto in_use = cached(file).points;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!mesh.points) {
    const bool is_outdated = mesh.is_cancelled || request.generation != generation_;
    // If points are in use, only reading the triangles failed.
    if (!is_outdated && !in_use) entries_[keyOf(file)] = {nullptr, {}, mesh.error};
    return;
  }
  eraseDead(entries_, max_entries_,
            [](const Entry& entry) { return entry.error.empty() && entry.points.expired(); });
  Entry& entry = entries_[keyOf(file)];
  const bool is_same = entry.files && *entry.files == files;
  const auto points = is_same ? entry.points.lock() : nullptr;
  if (points) mesh.points = points;
  entry = {std::make_shared<const FileVersions>(std::move(files)), mesh.points, ""};
}

std::vector<LoadedMesh> MeshStore::load(const std::vector<MeshFile>& files,
                                        const LoadProgress& progress, MeshContent content,
                                        const MeshLimits& limits,
                                        const std::function<bool()>& is_cancelled) {
  const Request request{content, limits, is_cancelled, generation()};
  std::map<std::string, LoadedMesh> meshes;
  std::vector<std::pair<const MeshFile*, LoadedMesh*>> missing;
  for (const MeshFile& file : files) {
    const auto [entry, is_new] = meshes.try_emplace(keyOf(file));
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
    results.push_back(meshes.at(keyOf(file)));
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
