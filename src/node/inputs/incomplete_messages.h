// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that announce more than they have are refused.
#pragma once

#include <string>

#include "node/inputs/received.h"
#include "world/log/refusal_log.h"

namespace link_bounds {

/// Of one thread.
class IncompleteMessages {
 public:
  /// Whether all of the message is there. If not, logs that, at a limited rate. `topic` may also be
  /// a service.
  template <class Message>
  bool accept(const Received<Message>& message, const std::string& topic,
              const std::string& sender) {
    if (!message.is_complete) log(topic, sender);
    return message.is_complete;
  }

 private:
  void log(const std::string& topic, const std::string& sender);

  RefusalLog log_{"a message on", "messages on further topics"};
};

extern const char* const kIncompleteMessage;  ///< why one is refused

}  // namespace link_bounds
