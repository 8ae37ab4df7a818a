// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/pair_contact.h"

namespace link_bounds {
namespace {

std::optional<BodyDistance> within(const Body& first, const Body& second,
                                   const Eigen::Affine3d& first_from_second, double reach) {
  if (!(reach > 0)) return {};
  const auto distance = bodyDistance(first, Eigen::Affine3d::Identity(), second, first_from_second);
  return distance && distance->upper <= reach ? distance : std::nullopt;
}

}  // namespace

std::optional<BodyDistance> coreContact(const PairBody& first, const PairBody& second,
                                        const Eigen::Affine3d& first_from_second, double reach) {
  for (const SolidCore& core : first.cores) {
    const auto found = within(core.body, *second.body, first_from_second, reach + core.skin);
    if (found) return found;
  }
  for (const SolidCore& core : second.cores) {
    const auto found = within(*first.body, core.body, first_from_second, reach + core.skin);
    if (found) return found;
  }
  return {};
}

}  // namespace link_bounds
