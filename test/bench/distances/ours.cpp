// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ours with and without triangles.
#include "bench/distances/distance_methods.h"
#include "link_bounds/geometry/distance/body_distances.h"

namespace link_bounds::bench {
namespace {

class OurDistances : public DistanceMethod {
 public:
  OurDistances(const DistanceRobot& robot, double limit, bool has_triangles, double relative)
      : count_(robot.links.size()),
        distances_({kAccuracy, limit, DistanceGoal().max_steps, relative}) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      auto body = std::make_shared<Body>(robot.links[i].body);
      for (BodyShape& shape : body->shapes) {
        if (!has_triangles) shape.triangles = nullptr;
      }
      distances_.set(i, body);
    }
  }

  void prepare(const LinkPoses& poses) override {
    for (std::size_t i = 0; i < poses.size(); ++i)
      distances_.move(i, poses[i]);
  }

  /// No pair has a distance below 0, so nothing is searched.
  void place() override {
    for (std::size_t i = 0; i < count_; ++i)
      distances_.findOnce(i, i, -1);
  }

  bool has(std::size_t, std::size_t) const override { return true; }

  MeasuredDistance distance(std::size_t first, std::size_t second) override {
    const BodyDistance found = distances_.find(first, second).value();
    return {found.lower, found.upper};
  }

  MeasuredDistance follow(std::size_t first, std::size_t second) override {
    const BodyDistance found = distances_.follow(first, second).value();
    return {found.lower, found.upper};
  }

 private:
  std::size_t count_;
  BodyDistances distances_;
};

DistanceSetting setting(const std::string& level, bool has_triangles, double relative) {
  return {"ours", level, [has_triangles, relative](const DistanceRobot& robot, double limit) {
            return std::make_unique<OurDistances>(robot, limit, has_triangles, relative);
          }};
}

}  // namespace

void addOurDistances(std::vector<DistanceSetting>& settings) {
  settings.push_back(setting("hull", false, 0));
  settings.push_back(setting("mesh", true, 0));
}

void addRoughDistances(std::vector<DistanceSetting>& settings) {
  settings.push_back(setting("mesh to 0.01", true, 0.01));
}

}  // namespace link_bounds::bench
