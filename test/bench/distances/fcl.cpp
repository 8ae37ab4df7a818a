// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// FCL's trees of triangles, with the nodes that it recommends for distances. Links with solids are
// left out: FCL has no distance of a solid and a tree that is right for all of them.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>

#include "bench/distances/distance_methods.h"

namespace link_bounds::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::unique_ptr<Model> modelOf(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return nullptr;
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    vertices.push_back(vertex.cast<double>());
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.emplace_back(a, b, c);
  auto model = std::make_unique<Model>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

class FclDistances : public DistanceMethod {
 public:
  explicit FclDistances(const DistanceRobot& robot) {
    for (const DistanceLink& link : robot.links)
      models_.push_back(modelOf(link.mesh));
  }

  void prepare(const LinkPoses& poses) override {
    poses_.clear();
    for (const Eigen::Affine3d& pose : poses)
      poses_.emplace_back(pose.matrix());
  }

  bool has(std::size_t first, std::size_t second) const override {
    return models_[first] && models_[second];
  }

  MeasuredDistance distance(std::size_t first, std::size_t second) override {
    fcl::DistanceRequestd request;
    request.enable_nearest_points = true;
    request.abs_err = kAccuracy;
    fcl::DistanceResultd result;
    const double distance = fcl::distance(models_[first].get(), poses_[first],
                                          models_[second].get(), poses_[second], request, result);
    return {std::max(0.0, distance), std::max(0.0, distance)};
  }

 private:
  std::vector<std::unique_ptr<Model>> models_;
  std::vector<fcl::Transform3d> poses_;
};

}  // namespace

void addFclDistances(std::vector<DistanceSetting>& settings) {
  settings.push_back({"fcl BVH", "mesh", [](const DistanceRobot& robot, double) {
                        return std::make_unique<FclDistances>(robot);
                      }});
}

}  // namespace link_bounds::bench
