// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Only beginTick() removes a sender.
#include "node/master/senders.h"

#include <iterator>
#include <utility>

namespace link_bounds {
namespace {

constexpr int kForgotten = 10;  // ticks without ask() until removal; longer than an update takes

}  // namespace

Senders::Answer Senders::ask(const std::string& node) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [entry, is_new] = senders_.try_emplace(node);
  if (is_new) entry->second.is_doubted = was_lost_;
  entry->second.unasked = 0;
  return {entry->second.has_left, is_new};
}

void Senders::beginTick(bool is_master_lost) {
  const std::lock_guard<std::mutex> lock(mutex_);
  was_lost_ |= is_master_lost;
  for (auto entry = senders_.begin(); entry != senders_.end();) {
    Sender& sender = entry->second;
    sender.is_doubted |= is_master_lost;
    sender.has_left = false;
    entry = ++sender.unasked > kForgotten ? senders_.erase(entry) : std::next(entry);
  }
}

void Senders::look(const XmlRpcCall& master) {
  std::map<std::string, Sender> senders;  // a copy, because a call may take long
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    senders = senders_;
  }
  const auto publishers = senders.empty() ? std::nullopt : publishersOf(master, topic_);
  if (!publishers) return;
  for (auto& [node, sender] : senders) {
    const bool publishes = publishers->count(node) > 0;
    if (publishes) sender.is_doubted = false;
    if (sender.is_doubted || (publishes && !sender.address.empty())) continue;
    const auto address = addressOf(master, node);
    if (publishes) {
      sender.address = address.value_or("");
    } else {
      sender.has_left = address && (address->empty() || *address == sender.address);
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& [node, sender] : senders) {
    Sender& known = senders_[node];
    sender.unasked = known.unasked;
    known = std::move(sender);
  }
}

}  // namespace link_bounds
