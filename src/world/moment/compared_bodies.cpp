// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Most bodies have a partner among the first few that are tried. If many have none, such as objects
// in ignore_pairs, only one body of each kind is compared with all others.
#include "world/moment/compared_bodies.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace link_bounds {
namespace {

constexpr std::size_t kFew = 16;

/// Bodies of the same kind are excluded from comparison with the same other bodies.
struct Kind {
  std::optional<std::size_t> rigid_body;  ///< of a link, or of an object that is attached
  std::vector<std::string> ignored_with;  ///< names and patterns

  bool operator<(const Kind& other) const {
    return std::tie(rigid_body, ignored_with) < std::tie(other.rigid_body, other.ignored_with);
  }
};

Kind kindOf(const Model& model, const PairMember& member) {
  return {bodyOf(model, member), model.ignored_pairs.partnersOf(*member.name)};
}

/// Tries all other bodies, from the next index on and around the end of the list.
bool hasPartner(const Moment& moment, std::size_t body, std::map<Kind, bool>& known) {
  const std::size_t count = moment.bodies.size();
  const PairMember member = moment.member(body);
  std::map<Kind, bool>::iterator entry;
  for (std::size_t i = 1; i < count; ++i) {
    if (i == kFew) {
      const auto [found, is_new] = known.try_emplace(kindOf(*moment.model, member), false);
      if (!is_new) return found->second;
      entry = found;
    }
    if (!isPair(*moment.model, member, moment.member((body + i) % count))) continue;
    if (i >= kFew) entry->second = true;
    return true;
  }
  return false;
}

}  // namespace

std::vector<bool> areCompared(const Moment& moment, const std::vector<BoxPair>& pairs) {
  std::vector<bool> result(moment.bodies.size(), false);
  for (const BoxPair& pair : pairs) {
    result[pair.first] = true;
    result[pair.second] = true;
  }
  std::map<Kind, bool> known;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = result[i] || hasPartner(moment, i, known);
  return result;
}

}  // namespace link_bounds
