// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies that come, move, change and go beside a computation that remembers nothing.
#include "world/moment/scene_distances.h"

#include <gtest/gtest.h>

#include "testing/distance_bodies.h"
#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"
#include "testing/sanitized.h"
#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

constexpr int kSequences = kIsSanitized ? 20 : 200;
constexpr int kSteps = 60;
constexpr double kMeshAccuracy = 1e-4;

const std::vector<int> kTypes{Marker::CUBE,         Marker::SPHERE,      Marker::CYLINDER,
                              Marker::ARROW,        Marker::LINE_STRIP,  Marker::LINE_LIST,
                              Marker::CUBE_LIST,    Marker::SPHERE_LIST, Marker::POINTS,
                              Marker::TRIANGLE_LIST};

/// Everything that SceneDistances may remember, kept a second time by plain means.
class Sequence {
 public:
  Sequence(std::uint64_t seed, bool are_carried) : random_(seed), are_carried_(are_carried) {
    newModel();
  }

  void step() {
    const double kind = random_.uniform(0, 1);
    if (kind < 0.02) newModel();
    if (kind < 0.3) putObject();
    if (kind > 0.8) removeObject();
    if (random_.uniform(0, 1) < 0.3) deliver();
    if (random_.uniform(0, 1) < 0.7) moveBodies();
    now_ += std::chrono::milliseconds(static_cast<int>(random_.uniform(0, 400)));
    compare();
  }

 private:
  struct Object {
    std::shared_ptr<const ObjectContent> content;
    Eigen::Affine3d pose;
  };

  Eigen::Affine3d somePose() {
    Eigen::Affine3d pose(random_.rotation());
    pose.translation() = random_.vector(1.5);
    return pose;
  }

  void newModel() {
    std::vector<BoundedLink> links;
    for (int i = 0; i < 4; ++i)
      links.push_back({"link" + std::to_string(i),
                       {Shape{points(), Solid::kNone, Eigen::Vector3d::Zero(), somePose()}},
                       0,
                       ""});
    links.front().shapes.push_back(
        {nullptr, Solid::kEllipsoid, {0.4, 0.3, 0.2}, Eigen::Affine3d::Identity()});
    auto model = std::make_shared<Model>(*modelOf("map", links));
    for (const BoundedLink& link : links)
      model->mesh_uris[link.name] = link.shapes.front().points;
    model->bodies.parents = {0, 0, 1, 2};  // a chain: neighbours are no pairs
    model->ignored_pairs = NamePairs(std::vector<NamePair>{{"link0", "o/0"}});
    model->parameters.distance_limit = random_.uniform(0, 1) < 0.2 ? 0 : random_.uniform(0, 2);
    model->parameters.distance_accuracy = kMeshAccuracy;
    model->parameters.distance_relative_accuracy = random_.uniform(0, 1) < 0.5 ? 0 : 0.1;
    model_ = model;
    link_poses_.assign(links.size(), Eigen::Affine3d::Identity());
    moveBodies();
  }

  std::shared_ptr<const PointSet> points() {
    const TriangleMesh mesh = anyMesh(random_, 0.4);
    auto result = std::make_shared<const PointSet>(mesh.vertices);
    meshes_.emplace_back(result, mesh);
    return result;
  }

  void putObject() {
    const auto number = static_cast<std::size_t>(random_.uniform(0, 6));
    const auto type =
        kTypes[static_cast<std::size_t>(random_.uniform(0, static_cast<double>(kTypes.size())))];
    const std::size_t count = type == Marker::ARROW ? 0 : 6;
    MarkerShape shape = markerShape(markerOf(type, random_.vector(0.4).cwiseAbs(), count));
    auto content = std::make_shared<ObjectContent>();
    content->bounded = {"o/" + std::to_string(number), shape.shapes, 0, ""};
    content->drawing = shape.drawing;
    if (random_.uniform(0, 1) < 0.3) {
      content->bounded.shapes = {{points()}};
      content->drawing = {DrawingKind::kMesh};
      content->mesh_uri = "uri";
    }
    objects_[number] = {content, somePose()};
  }

  void removeObject() {
    const auto found = objects_.find(static_cast<std::size_t>(random_.uniform(0, 6)));
    if (found == objects_.end()) return;
    removed_ = found->second.content->bounded.shapes.front().points;
    objects_.erase(found);
  }

  void moveBodies() {
    for (Eigen::Affine3d& pose : link_poses_) {
      if (random_.uniform(0, 1) < 0.1) pose = somePose();
      pose.translation() += random_.vector(0.02);
    }
    for (auto& [number, object] : objects_) {
      if (random_.uniform(0, 1) < 0.3) object.pose.translation() += random_.vector(0.1);
    }
  }

  /// One of the trees that were requested; now and then there is none.
  void deliver() {
    if (requests_.empty()) return;
    const auto at = requests_.begin() + static_cast<std::ptrdiff_t>(random_.uniform(
                                            0, static_cast<double>(requests_.size())));
    MadeTree made = (*at)();
    requests_.erase(at);
    if (random_.uniform(0, 1) < 0.2) made = {made.points, nullptr, "too large"};
    if (made.triangles) trees_[made.points.lock().get()] = made;
    distances_.trees().add(made);
  }

  MadeTree meshTree(const std::weak_ptr<const PointSet>& points) const {
    for (const auto& [owner, mesh] : meshes_) {
      if (owner.lock() == points.lock()) return {points, triangleTree(mesh), ""};
    }
    return {points, nullptr, "gone"};
  }

  MomentPtr moment() const {
    auto result = std::make_shared<Moment>();
    result->model = model_;
    result->header.frame_id = "map";
    result->incomplete = {"somebody"};
    for (std::size_t i = 0; i < link_poses_.size(); ++i) {
      result->bodies.push_back({i, nullptr, 5 + static_cast<std::int64_t>(i),
                                linkBox(model_->links[i], link_poses_[i]).value(), link_poses_[i]});
    }
    for (const auto& [number, object] : objects_) {
      result->bodies.push_back({std::nullopt, object.content, 0,
                                linkBox(object.content->bounded, object.pose).value(),
                                object.pose});
    }
    return result;
  }

  std::shared_ptr<const TriangleTree> treeOf(const std::shared_ptr<const PointSet>& points) const {
    const auto found = trees_.find(points.get());
    const bool is_there = found != trees_.end() && points && found->second.points.lock() == points;
    return is_there ? found->second.triangles : nullptr;
  }

  Body bodyOf(const Moment::Body& body) const {
    if (body.object) return objectBody(*body.object, treeOf(body.object->bounded.shapes[0].points));
    Body result;
    for (const Shape& shape : model_->links[*body.link].shapes)
      result.shapes.push_back({shape, treeOf(shape.points)});
    return result;
  }

  static bool isExact(const Body& body) {
    return std::all_of(body.shapes.begin(), body.shapes.end(), [](const BodyShape& shape) {
      return !shape.shape.points || shape.triangles;
    });
  }

  std::string nameOf(const Moment::Body& body) const {
    return body.object ? body.object->bounded.name : model_->links[*body.link].name;
  }

  /// Neighbours in the chain, and the pair that the model ignores.
  bool isLeftOut(const Moment::Body& a, const Moment::Body& b) const {
    if (a.link && b.link) return *a.link + 1 == *b.link;
    return nameOf(a) == "link0" && nameOf(b) == "o/0";
  }

  void compare() {
    computeAndCompare();
    EXPECT_TRUE(removed_.expired()) << "the points of a body that is gone";
  }

  /// Every name was compared, and each pair that was left out has its boxes apart or is named.
  void compareSilence(const Moment& taken, const DistanceArray& array) {
    EXPECT_EQ(array.limit, model_->parameters.distance_limit);
    EXPECT_EQ(array.accuracy, kMeshAccuracy);
    std::vector<std::string> names;
    auto entry = array.not_compared.begin();
    for (std::size_t i = 0; i < taken.bodies.size(); ++i) {
      names.push_back(nameOf(taken.bodies[i]));
      for (std::size_t j = i + 1; j < taken.bodies.size(); ++j) {
        const Moment::Body& a = taken.bodies[i];
        const Moment::Body& b = taken.bodies[j];
        const double apart = signedDistance(a.box, b.box);
        if (!isLeftOut(a, b) || apart > array.limit) continue;
        ASSERT_TRUE(entry != array.not_compared.end()) << nameOf(a) << " " << nameOf(b);
        ASSERT_EQ(entry->first + " " + entry->second, nameOf(a) + " " + nameOf(b));
        ASSERT_EQ(entry->distance, apart);
        ++entry;
      }
    }
    EXPECT_TRUE(entry == array.not_compared.end());
    EXPECT_EQ(array.complete, names);
  }

  void computeAndCompare() {
    const auto taken = moment();
    const auto computed = distances_.compute(taken, moment_pairs_, now_, [] { return false; });
    distances_.trees().requestSettled(now_);
    ASSERT_TRUE(computed);
    EXPECT_EQ(computed->array.incomplete, taken->incomplete);
    const double limit = model_->parameters.distance_limit;
    auto entry = computed->array.distances.begin();
    const auto end = computed->array.distances.end();
    double nearest = limit;
    for (std::size_t i = 0; i < taken->bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < taken->bodies.size(); ++j) {
        const Moment::Body& a = taken->bodies[i];
        const Moment::Body& b = taken->bodies[j];
        const bool is_there =
            entry != end && entry->first == nameOf(a) && entry->second == nameOf(b);
        if (isLeftOut(a, b)) {
          ASSERT_FALSE(is_there) << nameOf(a) << " " << nameOf(b);
          continue;
        }
        const auto expected =
            bodyDistance(bodyOf(a), a.frame_from_body, bodyOf(b), b.frame_from_body,
                         {kMeshAccuracy, std::numeric_limits<double>::infinity(), 1'000'000})
                .value();
        if (!is_there) {
          ASSERT_GT(expected.upper, limit) << nameOf(a) << " " << nameOf(b);
          continue;
        }
        ASSERT_LE(entry->distance, limit);
        ASSERT_LE(entry->distance, expected.upper);
        ASSERT_GE(entry->distance_max, expected.lower);
        if (isExact(bodyOf(a)) && isExact(bodyOf(b)) && limit > 0) {
          const double width = entry->distance_max - entry->distance;
          const double part = model_->parameters.distance_relative_accuracy;
          ASSERT_LE(width, std::max(kMeshAccuracy, part * entry->distance_max));
          rough_ += width > kMeshAccuracy ? 1 : 0;
        }
        ASSERT_EQ(entry->stamp.toNSec(),
                  a.link ? 5 + (b.link ? std::min(*a.link, *b.link) : *a.link) : 0);
        nearest = std::min(nearest, entry->distance);
        ++entry;
        ++pairs_;
      }
    }
    ASSERT_TRUE(entry == end) << entry->first << " " << entry->second;
    compareSilence(*taken, computed->array);
    EXPECT_EQ(computed->nearest.distance, nearest);
    EXPECT_EQ(computed->nearest.first.empty(), computed->array.distances.empty());
  }

 public:
  std::size_t pairs_ = 0;
  std::size_t rough_ = 0;  ///< of these, as distance_relative_accuracy allows

 private:
  brute_force::Random random_;
  bool are_carried_;
  TriangleTrees::Time now_{};
  std::shared_ptr<const Model> model_;
  std::vector<Eigen::Affine3d> link_poses_;
  std::map<std::size_t, Object> objects_;
  std::weak_ptr<const PointSet> removed_;  ///< points of the last object that was removed
  std::vector<std::pair<std::weak_ptr<const PointSet>, TriangleMesh>> meshes_;
  std::vector<std::function<MadeTree()>> requests_;
  std::map<const PointSet*, MadeTree> trees_;  ///< delivered
  MomentPairs moment_pairs_;
  SceneDistances distances_{
      {[this](const std::string&, const auto& points) {
         requests_.emplace_back(
             [this, weak = std::weak_ptr<const PointSet>(points)] { return meshTree(weak); });
       },
       [this](const auto& list) {
         requests_.emplace_back([weak = std::weak_ptr<const ObjectContent>(list)] {
           const auto content = weak.lock();
           return content ? listTree(*content) : MadeTree();
         });
       }},
      are_carried_};
};

TEST(SceneDistancesTest, isAsWithoutMemory) {
  std::size_t pairs = 0, rough = 0;
  for (std::uint64_t seed = 0; seed < kSequences; ++seed) {
    Sequence sequence(seed, seed % 2 == 0);
    for (int i = 0; i < kSteps && !testing::Test::HasFatalFailure(); ++i) {
      SCOPED_TRACE("sequence " + std::to_string(seed) + ", step " + std::to_string(i));
      sequence.step();
    }
    pairs += sequence.pairs_;
    rough += sequence.rough_;
  }
  EXPECT_GT(pairs, 60U * kSequences);
  EXPECT_GT(rough, 0U);
}

}  // namespace
}  // namespace link_bounds
