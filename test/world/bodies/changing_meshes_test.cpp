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

using Points = std::shared_ptr<const PointSet>;

/// A file, what the loader knows of it, and its job. A newer job replaces an older one.
struct ChangingFile {
  int version = 1;                       ///< the size of its mesh [m]; every fifth is broken
  int read = 0;                          ///< the version of `cached`
  std::weak_ptr<const PointSet> cached;  ///< in use by a link or an object
  std::weak_ptr<const PointSet> given;   ///< to objects, last
  int loaded = 0;                        ///< the version that objects were told last
  int since_reload = 0;                  ///< the version when somebody last looked for a ~reload
  std::optional<MeshRequest> load;
  Points of_link;

  bool isBroken() const { return version % 5 == 0; }

  Points points() {
    Points known = read == version ? cached.lock() : nullptr;
    if (known || isBroken()) return known;
    const auto size = static_cast<float>(version);
    known = std::make_shared<const PointSet>(
        std::vector<Eigen::Vector3f>{{0, 0, 0}, {size, 0, 0}, {0, size, size}});
    read = version;
    cached = known;
    return known;
  }
};

/// On its way to the update thread.
struct Answer {
  MeshRequest request;
  LoadedMesh mesh;
};

class ChangingMeshesTest : public testing::Test {
 protected:
  ChangingMeshesTest() {
    frames_.setTarget("map", 2, now_);
    objects_.adopt(now_);
  }

  ChangingFile& fileAt(int index) { return files_[static_cast<std::size_t>(index)]; }
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

  /// What ~reload does before the update thread adopts it.
  void look() {
    unchanged_.emplace();
    looked_at_.clear();
    for (int i = 0; i < kFiles; ++i) {
      ChangingFile& file = fileAt(i);
      looked_at_.push_back(file.version);
      const Points given = file.given.lock();
      if (given && given == file.cached.lock() && file.read == file.version)
        unchanged_->emplace("file:///" + std::to_string(i), given);
    }
  }

  void adopt() {
    if (!unchanged_) return;
    for (int i = 0; i < kFiles; ++i)
      fileAt(i).since_reload = looked_at_[static_cast<std::size_t>(i)];
    source_.reloadMeshes(*std::exchange(unchanged_, {}), now_);
  }

  void load(int index) {
    ChangingFile& file = fileAt(index);
    if (!file.load) return;
    endLate();  // one after the other
    const MeshRequest request = *std::exchange(file.load, {});
    if (request.use.expired()) return;
    const Points points = file.points();
    file.given = points;
    file.loaded = file.version;
    (pick(4) == 0 ? late_ : answers_).push_back({request, {points, points ? "" : "broken"}});
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
    source_.fillMesh(answer.request, answer.mesh, now_);
  }

  void deliverAll() {
    for (int i = 0; i < kFiles; ++i)
      load(i);
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

  /// The link may have no mesh, or the points of an older file.
  void loadLink(ChangingFile& file) { file.of_link = pick(2) == 0 ? nullptr : file.points(); }

  void doAny() {
    switch (pick(14)) {
      case 0:
      case 1:
        return sendMarker(pick(kMarkers), pick(kFiles));
      case 2:
        return deleteMarker(pick(kMarkers));
      case 3:
        return static_cast<void>(++fileAt(pick(kFiles)).version);
      case 4:
        return look();
      case 5:
      case 6:
        return adopt();
      case 7:
      case 8:
        return load(pick(kFiles));
      case 9:
        return remember();
      case 10:
        return endLate();
      case 11:
        return loadLink(fileAt(pick(kFiles)));
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
      const ChangingFile& file = fileAt(fileOf(object.content->mesh_uri));
      if (object.state.incomplete) continue;
      ++complete_;
      ASSERT_TRUE(object.state.box);
      ASSERT_GE(versionOf(object), file.since_reload);
    }
  }

  /// Where all is read, nothing waits.
  void expectAllRead() {
    for (const auto& [key, object] : objects_.objects()) {
      const ChangingFile& file = fileAt(fileOf(object.content->mesh_uri));
      ASSERT_FALSE(object.content->isLoading());
      ASSERT_FALSE(object.content->is_read_again);
      ASSERT_EQ(object.state.incomplete, file.loaded % 5 == 0);
      if (object.state.incomplete) continue;
      ASSERT_EQ(versionOf(object), file.loaded);
    }
  }

  void expectCurrent() {
    for (const auto& [key, object] : objects_.objects()) {
      const ChangingFile& file = fileAt(fileOf(object.content->mesh_uri));
      ASSERT_EQ(object.state.incomplete, file.isBroken());
      if (object.state.incomplete) continue;
      ASSERT_EQ(versionOf(object), file.version);
    }
  }

  ros::Time now_{100};
  std::mt19937 random_{1};
  std::vector<ChangingFile> files_ = std::vector<ChangingFile>(kFiles);
  std::optional<ObjectSource::Points> unchanged_;  ///< for the ~reload that is not yet adopted
  std::vector<int> looked_at_;                     ///< versions, at that time
  std::deque<Answer> answers_, late_;
  std::vector<std::shared_ptr<const ObjectContent>> past_;
  int complete_ = 0;
  TransformBuffer tf_;
  FrameTracker frames_{tf_};
  LiveObjects objects_{frames_};
  ObjectSource source_{
      objects_, [this](const MeshRequest& request) { fileAt(fileOf(request.uri)).load = request; }};
};

TEST_F(ChangingMeshesTest, BoxesAreOfFilesThatWereThereAtTheLastReload) {
  int settled = 0;
  for (int step = 0; step < kSteps && !HasFatalFailure(); ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    doAny();
    expectNoneTooOld();
    if (pick(50) != 0) continue;
    const bool is_reloaded = pick(2) == 0;
    if (is_reloaded) {
      look();
      adopt();
    }
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
