// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints stand from the root outward: the body of a parent is known before that of its child.
#include "link_bounds/robot/urdf/overlap_filter.h"

#include <algorithm>
#include <tuple>

namespace link_bounds {
namespace {

constexpr char kSpaces[] = " \t\r\n";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) + 1 - begin);
}

}  // namespace

RigidBodies rigidBodies(const Robot& robot) {
  RigidBodies bodies{std::vector<std::size_t>(robot.links.size(), 0), {0}};
  for (const Joint& joint : robot.joints) {
    std::size_t& body = bodies.of_links[joint.child];
    body = bodies.of_links[joint.parent];
    if (joint.is_fixed) continue;
    bodies.parents.push_back(body);
    body = bodies.parents.size() - 1;
  }
  return bodies;
}

bool areJoined(const RigidBodies& bodies, std::size_t link, std::size_t other) {
  const std::size_t a = bodies.of_links[link];
  const std::size_t b = bodies.of_links[other];
  return a == b || bodies.parents[a] == b || bodies.parents[b] == a;
}

std::vector<NamePair> namePairs(const std::string& text,
                                const std::function<bool(const std::string&)>& is_name) {
  const std::string words = trimmed(text);
  std::vector<NamePair> splits;
  std::size_t space = words.find_first_of(kSpaces);
  while (space != std::string::npos) {
    const std::size_t next = words.find_first_not_of(kSpaces, space);
    splits.emplace_back(words.substr(0, space), words.substr(next));
    space = words.find_first_of(kSpaces, next);
  }
  if (splits.size() == 1) return splits;
  const auto is_unknown = [&is_name](const NamePair& pair) {
    return !is_name(pair.first) || !is_name(pair.second);
  };
  splits.erase(std::remove_if(splits.begin(), splits.end(), is_unknown), splits.end());
  return splits;
}

NamePairs::NamePairs(std::vector<NamePair> pairs) : pairs_(std::move(pairs)) {
  for (NamePair& pair : pairs_) {
    if (pair.second < pair.first) std::swap(pair.first, pair.second);
  }
  std::sort(pairs_.begin(), pairs_.end());
}

bool NamePairs::contains(const std::string& name, const std::string& other) const {
  if (other < name) return contains(other, name);
  const auto wanted = std::tie(name, other);
  const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), wanted,
                                      [](const NamePair& pair, const auto& value) {
                                        return std::tie(pair.first, pair.second) < value;
                                      });
  return found != pairs_.end() && std::tie(found->first, found->second) == wanted;
}

}  // namespace link_bounds
