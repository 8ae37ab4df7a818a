// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From a request to what is computed of it, and back to messages.
#include "node/outputs/box_service.h"

#include <stdexcept>

#include "node/history/past_boxes.h"
#include "node/history/pose_gap.h"
#include "node/log/log_text.h"
#include "node/names/topics.h"
#include "node/outputs/past_message.h"
#include "node/threads/queued_function.h"

namespace link_bounds {
namespace {

constexpr const char* kStopping = "the node is shutting down";

/// tf's names have no slash at their beginning.
std::string tfFrame(const std::string& name) {
  return name.compare(0, 1, "/") == 0 ? name.substr(1) : name;
}

BoxRequest toRequest(const GetBoxes::Request& message) {
  BoxRequest request;
  request.stamp = static_cast<std::int64_t>(message.stamp.toNSec());
  request.span = message.span.toNSec();
  request.frame = tfFrame(message.frame);
  request.names = message.names;
  if (request.span < 0) {
    throw std::runtime_error("span is " + std::to_string(message.span.toSec()) +
                             " s; it must be 0 or more");
  }
  return request;
}

}  // namespace

BoxService::BoxService(const ros::NodeHandle& private_node, HistoryThread& history)
    : history_(history) {
  ros::NodeHandle own_queue_node(private_node);
  own_queue_node.setCallbackQueue(&history_.queue());
  server_ =
      own_queue_node.advertiseService(privateName(kGetBoxesService), &BoxService::onRequest, this);
}

bool BoxService::onRequest(GetBoxes::Request& request, GetBoxes::Response& response) {
  try {
    answer(request, response);
    response.success = true;
  } catch (const std::exception& error) {
    response = GetBoxes::Response();
    response.message = logText(error.what());
  }
  return true;
}

/// Throws why there is no answer.
void BoxService::answer(const GetBoxes::Request& message, GetBoxes::Response& response) {
  const BoxRequest request = toRequest(message);
  if (!history_.model()) {
    throw std::runtime_error(
        "there are no boxes yet, because no robot was loaded; ask again after the first ~boxes");
  }
  const std::shared_ptr<PastScene> scene = history_.copy(request);
  if (!scene) throw std::runtime_error(kStopping);
  const std::string refusal = whyRefused(*scene);
  if (!refusal.empty()) throw std::runtime_error(refusal);
  const PastBoxes found = pastBoxes(*scene, request, [this] { return history_.isStopping(); });
  if (history_.isStopping()) throw std::runtime_error(kStopping);
  fillBoxes(*scene, found, request, response.boxes);
  response.message = logText(found.problem);
  // Freed after the response has been sent.
  enqueue(history_.queue(), [scene] {});
}

}  // namespace link_bounds
