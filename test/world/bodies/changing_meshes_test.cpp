// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of files that change, of ~reload and of markers that come and go while files are
// read, beside plain numbers: which file an object may have its box of.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "testing/marker_testing.h"
#include "world/bodies/object_source.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

constexpr int kFiles = 3;
constexpr int kMarkers = 5;
constexpr int kSteps = 300000;

/// A file, and the jobs of the loader that it has. A newer job replaces an older one.
struct ChangingFile {
  int version = 1;           ///< the size of its mesh [m]; every fifth is broken
  int read = 0;              ///< the version that the loader remembers
  int since_reload = 0;      ///< that at the last ~reload
  bool is_looked_at = true;  ///< since then, and the answer is there
  std::optional<MeshRequest> look, load;

  bool isBroken() const { return version % 5 == 0; }
};

/// On its way to the update thread.
struct Answer {
  int file;
  bool is_sent;  ///< a look at a file that has not changed has none
  MeshRequest request;
  LoadedMesh mesh;
};

class ChangingMeshesTest : public testing::Test {
 protected:
  ChangingMeshesTest() {
    frames_.setTarget("map", 2, now_);
    objects_.adopt(now_);
  }

  static int fileOf(const std::string& uri) { return uri.back() - '0'; }
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  void sendMarker(int id, int file) {
    Marker marker = markerOf(Marker::MESH_RESOURCE, {1, 1, 1});
    marker.header.frame_id = "map";
    marker.ns = "scene";
    marker.id = id;
    marker.mesh_resource = "file:///" + std::to_string(file);
    source_.take(std::move(marker), "/camera", now_);
  }

  void deleteMarker(int id) {
    Marker marker;
    marker.ns = "scene";
    marker.id = id;
    marker.action = Marker::DELETE;
    source_.take(std::move(marker), "/camera", now_);
  }

  void reload() {
    for (ChangingFile& file : files_) {
      file.since_reload = file.version;
      file.is_looked_at = false;
    }
    source_.reloadMeshes();
  }

  void look(int index) {
    ChangingFile& file = files_[static_cast<std::size_t>(index)];
    if (!file.look) return;
    const MeshRequest request = *std::exchange(file.look, {});
    const bool has = file.read == file.version && !file.isBroken();
    if (has) endLate();  // what the loader has, it answers at once
    answers_.push_back({index, !has, request, LoadedMesh()});
  }

  void load(int index) {
    ChangingFile& file = files_[static_cast<std::size_t>(index)];
    if (!file.load) return;
    endLate();  // one after the other
    const MeshRequest request = *std::exchange(file.load, {});
    if (request.use.expired()) return;
    file.read = file.version;
    LoadedMesh mesh;
    if (file.isBroken()) {
      mesh.error = "broken";
    } else {
      const auto size = static_cast<float>(file.version);
      mesh.points = std::make_shared<const PointSet>(
          std::vector<Eigen::Vector3f>{{0, 0, 0}, {size, 0, 0}, {0, size, size}});
    }
    (pick(4) == 0 ? late_ : answers_).push_back({index, true, request, mesh});
  }

  /// A reader is held up between its work and its answer.
  void endLate() {
    answers_.insert(answers_.end(), late_.begin(), late_.end());
    late_.clear();
  }

  void deliver() {
    if (answers_.empty()) return;
    const Answer answer = std::move(answers_.front());
    answers_.pop_front();
    if (answer.is_sent) source_.fillMesh(answer.request, answer.mesh, now_);
    ChangingFile& file = files_[static_cast<std::size_t>(answer.file)];
    if (answer.request.number == newest_[answer.file]) file.is_looked_at = true;
  }

  void deliverAll() {
    for (int i = 0; i < kFiles; ++i) {
      look(i);
      load(i);
    }
    endLate();
    while (!answers_.empty())
      deliver();
  }

  /// Snapshots of the past keep contents, and with them points, of objects that have gone.
  void remember() {
    past_.clear();
    for (const auto& [key, object] : objects_.objects())
      past_.push_back(object.content);
  }

  void doAny() {
    switch (pick(13)) {
      case 0:
      case 1:
        return sendMarker(pick(kMarkers), pick(kFiles));
      case 2:
        return deleteMarker(pick(kMarkers));
      case 3:
        return static_cast<void>(++files_[static_cast<std::size_t>(pick(kFiles))].version);
      case 4:
        return reload();
      case 5:
      case 6:
        return look(pick(kFiles));
      case 7:
      case 8:
        return load(pick(kFiles));
      case 9:
        return remember();
      case 10:
        return endLate();
      default:
        return deliver();
    }
  }

  /// Of the mesh, from the box.
  static int versionOf(const LiveObject& object) {
    return static_cast<int>(std::lround(object.state.box->sizes().x()));
  }

  void expectNoneTooOld() {
    for (const auto& [key, object] : objects_.objects()) {
      const ChangingFile& file = files_[static_cast<std::size_t>(fileOf(object.content->mesh_uri))];
      if (object.state.incomplete) continue;
      ++complete_;
      ASSERT_TRUE(object.state.box);
      if (!file.is_looked_at) continue;
      ASSERT_GE(versionOf(object), file.since_reload);
    }
  }

  /// Where all is read, nothing waits.
  void expectAllRead() {
    for (const auto& [key, object] : objects_.objects()) {
      const ChangingFile& file = files_[static_cast<std::size_t>(fileOf(object.content->mesh_uri))];
      ASSERT_FALSE(object.content->isLoading());
      ASSERT_FALSE(object.content->is_read_again);
      ASSERT_EQ(object.state.incomplete, file.read % 5 == 0);
      if (object.state.incomplete) continue;
      ASSERT_EQ(versionOf(object), file.read);
    }
  }

  void expectCurrent() {
    for (const auto& [key, object] : objects_.objects()) {
      const ChangingFile& file = files_[static_cast<std::size_t>(fileOf(object.content->mesh_uri))];
      ASSERT_EQ(object.state.incomplete, file.isBroken());
      if (object.state.incomplete) continue;
      ASSERT_EQ(versionOf(object), file.version);
    }
  }

  ros::Time now_{100};
  std::mt19937 random_{1};
  std::vector<ChangingFile> files_ = std::vector<ChangingFile>(kFiles);
  std::map<int, std::uint64_t> newest_;  ///< number of a request, by file
  std::deque<Answer> answers_, late_;
  std::vector<std::shared_ptr<const ObjectContent>> past_;
  int complete_ = 0;
  TransformBuffer tf_;
  FrameTracker frames_{tf_};
  LiveObjects objects_{frames_};
  ObjectSource source_{objects_,
                       [this](const MeshRequest& request) {
                         newest_[fileOf(request.uri)] = request.number;
                         files_[static_cast<std::size_t>(fileOf(request.uri))].load = request;
                       },
                       [this](const MeshRequest& request) {
                         newest_[fileOf(request.uri)] = request.number;
                         files_[static_cast<std::size_t>(fileOf(request.uri))].look = request;
                       }};
};

TEST_F(ChangingMeshesTest, BoxesAreOfFilesThatWereThereAtTheLastReload) {
  int settled = 0;
  for (int step = 0; step < kSteps && !HasFatalFailure(); ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    doAny();
    expectNoneTooOld();
    if (pick(50) != 0) continue;
    const bool is_reloaded = pick(2) == 0;
    if (is_reloaded) reload();
    deliverAll();
    expectAllRead();
    if (is_reloaded) expectCurrent();
    ++settled;
  }
  EXPECT_GT(settled, kSteps / 100);
  EXPECT_GT(complete_, kSteps / 2);
}

}  // namespace
}  // namespace link_bounds
