// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each request first goes to a thread for small meshes, which reads the size of the file and passes
// large meshes on.
#include "node/loading/mesh_readers.h"

#include <algorithm>

#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

/// An STL file of this size has 335,000 triangles and takes about a second to load.
constexpr std::uint64_t kLargeBytes = 16 << 20;

constexpr unsigned kMaxReaders = 4;  // threads for small meshes; each holds at most one mesh

}  // namespace

MeshReaders::MeshReaders() : large_({"mesh reader"}) {
  const unsigned count = std::min(coreCount(), kMaxReaders);
  for (unsigned i = 0; i < count; ++i)
    small_.push_back(std::make_unique<Worker>(Worker::Options{"mesh reader"}));
}

void MeshReaders::post(const std::string& key, Job job) {
  Worker& reader = *small_[std::hash<std::string>()(key) % small_.size()];
  reader.post(key, [this, &reader, key, job = std::move(job)] {
    large_.cancel(key);
    if (job.bytes() <= kLargeBytes) {
      job.work([&reader] { return reader.isCancelled(); });
    } else {
      large_.post(key, [this, job] { job.work([this] { return large_.isCancelled(); }); });
    }
  });
}

void MeshReaders::stop() {
  for (const std::unique_ptr<Worker>& reader : small_)
    reader->stop();
  large_.stop();
}

}  // namespace link_bounds
