// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What differs between two contents, and the words for every trouble.
#include "node/objects/live_object.h"

#include <algorithm>

namespace link_bounds {
namespace {

bool isSame(const Shape& a, const Shape& b) {
  if (!a.points != !b.points || (a.points && !a.points->isSame(*b.points))) return false;
  return a.solid == b.solid && a.size == b.size &&
         a.link_from_shape.matrix() == b.link_from_shape.matrix();
}

}  // namespace

bool isSame(const ObjectContent& a, const ObjectContent& b) {
  const std::vector<Shape>& shapes = b.bounded.shapes;
  return a.frame == b.frame && a.stamp == b.stamp && a.mesh_uri == b.mesh_uri &&
         a.bounded.missing == b.bounded.missing &&
         std::equal(a.bounded.shapes.begin(), a.bounded.shapes.end(), shapes.begin(), shapes.end(),
                    [](const Shape& x, const Shape& y) { return isSame(x, y); });
}

std::string LiveObject::reason() const {
  if (!content.bounded.isWhole()) return content.bounded.missing;
  if (content.isLoading()) return "its mesh " + content.mesh_uri + " is still loading";
  switch (trouble) {
    case Trouble::kNone:
      return "";
    case Trouble::kNoTransform:
      return "no transform from \"" + content.frame + "\" to the fixed frame";
    case Trouble::kStale:
      return "stale: no transform accepted for longer than timeout";
    case Trouble::kPoseNotFinite:
      return "its pose is not finite or too large";
    case Trouble::kWaiting:
      return "the transform from \"" + content.frame + "\" at its stamp is not there yet";
    case Trouble::kGivenUp:
      return "there was no transform from \"" + content.frame + "\" at its stamp";
    case Trouble::kNotCarried:
      return "no transform from \"" + placement->fixed_frame_name +
             "\", in which it was placed, to the fixed frame";
  }
  return "";
}

}  // namespace link_bounds
