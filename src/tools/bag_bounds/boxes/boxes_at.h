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

/// Poses at a stamp are known when the next transforms have come. Objects are those that are there
/// when record time reaches the stamp; one that waits for tf is where tf places it later.
class BoxesAt {
 public:
  explicit BoxesAt(std::int64_t stamp) : stamp_(stamp) {}

  /// To be called when record time is about to pass the stamp, after all messages of it, or the
  /// bags end later.
  void begin(const Scene& scene, const TransformBuffer& tf);
  bool hasBegun() const { return has_begun_; }

  /// To be called after each message and tick, at the record time [ns].
  void look(const Scene& scene, const TransformBuffer& tf, std::int64_t now);

  /// To be called before tf forgets: what is not known by then stays so.
  void endMotions() { missing_ = 0; }

  std::int64_t stamp() const { return stamp_; }

  /// In the order of ~boxes; links without geometry are not among them.
  std::vector<BoxAt> boxes(const Scene& scene) const;

 private:
  struct Body {
    std::string name;
    const BoundedLink* link;
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::string frame;  ///< its number may pass to another one before the pose is known
    Eigen::Affine3d frame_from_body;
    std::int64_t at;  ///< when it is placed [ns]
    std::optional<Aabb> box;
    std::int64_t stamp;
  };

  std::string noBox() const;

  std::int64_t stamp_;
  bool has_begun_ = false;
  std::vector<Body> bodies_;
  std::vector<BoxAt> boxless_;  ///< objects that were there without a box, for another reason
  std::size_t missing_ = 0;
};

}  // namespace link_bounds
