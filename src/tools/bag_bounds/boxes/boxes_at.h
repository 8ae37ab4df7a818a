// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All boxes at one moment, as tf2 interpolates.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"

namespace link_bounds {

struct BoxAt {
  std::string name;
  std::optional<Aabb> box;
  std::int64_t stamp = 0;  ///< [ns]; 0 if all transforms on its way are static
  std::string problem;     ///< why there is no box; "" if there is one
};

/// Poses at a stamp are known only after the next transforms. Objects are those that exist when
/// record time reaches the stamp. An object that waits for tf is where tf places it later.
class BoxesAt {
 public:
  explicit BoxesAt(std::int64_t stamp) : stamp_(stamp) {}

  /// Call it after all messages up to the stamp, when record time is about to pass the stamp, or
  /// when the bags end.
  void begin(const Scene& scene, const TransformBuffer& tf);
  bool hasBegun() const { return has_begun_; }

  /// Call it after each message and tick, at the record time `now` [ns].
  void look(const Scene& scene, const TransformBuffer& tf, std::int64_t now);

  /// Call it before tf forgets: poses that are not known by then stay unknown.
  void endMotions() { missing_ = 0; }

  std::int64_t stamp() const { return stamp_; }

  /// In the order of ~boxes; links without geometry are not among them.
  std::vector<BoxAt> boxes(const Scene& scene) const;

 private:
  struct Body {
    std::string name;
    const BoundedLink* link;
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::string frame;  ///< a name, because tf may reuse a number before the pose is known
    Eigen::Affine3d frame_from_body;
    std::int64_t at;  ///< stamp of its pose [ns]
    std::optional<Aabb> box;
    std::int64_t stamp;
  };

  std::string noBox() const;

  std::int64_t stamp_;
  bool has_begun_ = false;
  std::vector<Body> bodies_;
  std::vector<BoxAt> boxless_;  ///< objects without a box for another reason than tf
  std::size_t missing_ = 0;
};

}  // namespace link_bounds
