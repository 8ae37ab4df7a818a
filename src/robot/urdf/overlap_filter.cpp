// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints stand from the root outward: the body of a parent is known before that of its child.
#include "link_bounds/robot/urdf/overlap_filter.h"

#include <algorithm>
#include <tuple>

#include "robot/urdf/trimmed.h"

namespace link_bounds {
namespace {

constexpr char kSpaces[] = " \t\r\n";
constexpr char kWildcard = '*';

}  // namespace

RigidBodies rigidBodies(const Robot& robot) {
  RigidBodies bodies{std::vector<std::size_t>(robot.links.size(), 0), {0}};
  for (const Joint& joint : robot.joints) {
    std::size_t& body = bodies.of_links[joint.child];
    body = bodies.of_links[joint.parent];
    if (joint.motion == Motion::kNone) continue;
    bodies.parents.push_back(body);
    body = bodies.parents.size() - 1;
  }
  return bodies;
}

bool areJoined(const RigidBodies& bodies, std::size_t link, std::size_t other, int joints) {
  return areBodiesJoined(bodies, bodies.of_links[link], bodies.of_links[other], joints);
}

/// The body with the larger number is never above the other one, so its joint is on the way.
bool areBodiesJoined(const RigidBodies& bodies, std::size_t a, std::size_t b, int joints) {
  for (; a != b; --joints) {
    if (joints <= 0) return false;
    std::size_t& lower = a > b ? a : b;
    lower = bodies.parents[lower];
  }
  return true;
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

bool isPattern(const std::string& name) {
  return name.find(kWildcard) != std::string::npos;
}

/// Not by fnmatch(), to which brackets and question marks in a name are special, too. On a
/// mismatch, the last wildcard takes one more character, and matching starts again behind it. No
/// earlier wildcard needs to take more, because each slash of the pattern has its place.
bool fitsPattern(const std::string& name, const std::string& pattern) {
  std::size_t p = 0;
  std::size_t after_wildcard = 0;  // 0 = there was none yet
  std::size_t taken = 0;           // end of the text that the last wildcard stands for
  for (std::size_t i = 0; i < name.size();) {
    if (p < pattern.size() && pattern[p] == kWildcard) {
      after_wildcard = ++p;
      taken = i;
    } else if (p < pattern.size() && pattern[p] == name[i]) {
      ++p;
      ++i;
    } else if (after_wildcard > 0 && name[taken] != '/') {
      p = after_wildcard;
      i = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of(kWildcard, p) == std::string::npos;
}

NamePairs::NamePairs(std::vector<NamePair> pairs) : pairs_(std::move(pairs)) {
  const auto patterns = std::partition(pairs_.begin(), pairs_.end(), [](const NamePair& pair) {
    return !isPattern(pair.first) && !isPattern(pair.second);
  });
  patterns_.assign(patterns, pairs_.end());
  pairs_.erase(patterns, pairs_.end());
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
  if (found != pairs_.end() && std::tie(found->first, found->second) == wanted) return true;
  return std::any_of(patterns_.begin(), patterns_.end(), [&](const NamePair& pair) {
    return (fitsPattern(name, pair.first) && fitsPattern(other, pair.second)) ||
           (fitsPattern(other, pair.first) && fitsPattern(name, pair.second));
  });
}

std::vector<std::string> NamePairs::partnersOf(const std::string& name) const {
  std::vector<std::string> partners;
  for (const std::vector<NamePair>* pairs : {&pairs_, &patterns_}) {
    for (const auto& [first, second] : *pairs) {
      if (fitsPattern(name, first)) partners.push_back(second);
      if (fitsPattern(name, second)) partners.push_back(first);
    }
  }
  return partners;
}

}  // namespace link_bounds
