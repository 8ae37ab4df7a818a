// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bullet's dynamic trees. Boxes are in single precision, rounded outward. A leaf is larger than its
// box by gDbvtMargin and stays as it is while the box is inside. The pairs are kept from step to
// step, which is faster than emptying the cache.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include "bench/overlaps/overlap_methods.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds::bench {
namespace {

struct BulletAabb {
  btVector3 min, max;
};

BulletAabb toBullet(const Aabb& box) {
  const Eigen::Vector3d& a = box.min();
  const Eigen::Vector3d& b = box.max();
  return {{floatDown(a.x()), floatDown(a.y()), floatDown(a.z())},
          {floatUp(b.x()), floatUp(b.y()), floatUp(b.z())}};
}

struct BulletSetting {
  bool collides_at_once;  ///< tests each box when it moves, else all boxes at the end of a step
  btScalar margin;        ///< [m]
};

class BulletOverlaps : public OverlapMethod {
 public:
  BulletOverlaps(const BulletSetting& setting, const SceneBoxes& boxes) : setting_(setting) {
    gDbvtMargin = setting_.margin;
    broadphase_.m_deferedcollide = !setting_.collides_at_once;
    numbers_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      numbers_[i] = i;
      const BulletAabb box = toBullet(boxes[i]);
      proxies_.push_back(broadphase_.createProxy(box.min, box.max, 0, &numbers_[i], 1, 1, nullptr));
    }
  }

  void prepare(const SceneBoxes& boxes) override {
    next_.clear();
    for (const Aabb& box : boxes)
      next_.push_back(toBullet(box));
  }

  void step(const SceneBoxes& boxes) override {
    pairs.clear();
    gDbvtMargin = setting_.margin;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      broadphase_.setAabb(proxies_[i], next_[i].min, next_[i].max, nullptr);
    broadphase_.calculateOverlappingPairs(nullptr);
    const auto& cached = broadphase_.getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < cached.size(); ++i)
      addIfNear(numberOf(cached[i].m_pProxy0), numberOf(cached[i].m_pProxy1), boxes);
  }

 private:
  static std::size_t numberOf(const btBroadphaseProxy* proxy) {
    return *static_cast<const std::size_t*>(proxy->m_clientObject);
  }

  BulletSetting setting_;
  btDbvtBroadphase broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::vector<std::size_t> numbers_;
  std::vector<BulletAabb> next_;
};

void add(const std::string& name, const BulletSetting& bullet,
         std::vector<OverlapSetting>& settings) {
  settings.push_back({"bullet", name, [bullet](const SceneBoxes& boxes) {
                        return std::make_unique<BulletOverlaps>(bullet, boxes);
                      }});
}

}  // namespace

void addBulletOverlaps(std::vector<OverlapSetting>& settings) {
  add("at once, margin 0.05", {true, 0.05f}, settings);
  add("at once, margin 0.02", {true, 0.02f}, settings);
  add("deferred, margin 0.05", {false, 0.05f}, settings);
  add("deferred, margin 0", {false, 0.0f}, settings);
}

}  // namespace link_bounds::bench
