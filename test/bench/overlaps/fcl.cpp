// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// FCL's dynamic tree. Objects are not turned, so their boxes are those of their geometry.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

#include "bench/overlaps/overlap_methods.h"

namespace link_bounds::bench {
namespace {

/// Either refits all boxes of the tree or moves each object within the tree.
enum class Update { kFit, kMove };

class FclOverlaps : public OverlapMethod {
 public:
  FclOverlaps(Update update, const SceneBoxes& boxes) : update_(update) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      shapes_.push_back(std::make_shared<fcl::Boxd>(1, 1, 1));
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(shapes_[i]));
      place(i, boxes[i]);
      pointers_.push_back(objects_[i].get());
      numbers_.push_back(i);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
      objects_[i]->setUserData(&numbers_[i]);
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  void step(const SceneBoxes& boxes) override {
    pairs.clear();
    boxes_ = &boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      place(i, boxes[i]);
    if (update_ == Update::kFit) {
      manager_.update();
    } else {
      manager_.update(pointers_);
    }
    manager_.collide(this, &FclOverlaps::onPair);
  }

 private:
  void place(std::size_t i, const Aabb& box) {
    shapes_[i]->aabb_local.min_ = box.min();
    shapes_[i]->aabb_local.max_ = box.max();
    objects_[i]->computeAABB();
  }

  static bool onPair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    auto& self = *static_cast<FclOverlaps*>(data);
    self.addIfNear(*static_cast<std::size_t*>(a->getUserData()),
                   *static_cast<std::size_t*>(b->getUserData()), *self.boxes_);
    return false;
  }

  Update update_;
  std::vector<std::shared_ptr<fcl::Boxd>> shapes_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  std::vector<fcl::CollisionObjectd*> pointers_;
  std::vector<std::size_t> numbers_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  const SceneBoxes* boxes_ = nullptr;
};

OverlapSetting setting(const std::string& name, Update update) {
  return {"fcl", name, [update](const SceneBoxes& boxes) {
            return std::make_unique<FclOverlaps>(update, boxes);
          }};
}

}  // namespace

void addFclOverlaps(std::vector<OverlapSetting>& settings) {
  settings.push_back(setting("update()", Update::kFit));
  settings.push_back(setting("update(objects)", Update::kMove));
}

}  // namespace link_bounds::bench
