// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts requests, runs the computation, and converts the result to messages.
#include "node/services/box_service.h"

#include <stdexcept>
#include <utility>

#include "node/interface/topics.h"
#include "node/outputs/messages/box_message.h"
#include "world/history/past_boxes.h"
#include "world/log/log_text.h"
#include "world/model/model.h"
#include "world/tf/nanoseconds.h"
#include "world/tf/tf_message.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::hours kNoPause(1000);

/// No further span is started while the scene copies of the started requests take this many bytes.
/// The largest copy, of 200 edges at 1 kHz, takes 140 MB.
constexpr std::size_t kMaxCopiedBytes = 32 << 20;

/// True if the request asks for a span. Reads only the beginning of the request, because it may
/// have many names.
bool hasSpan(const ros::SerializedMessage& request) {
  constexpr std::size_t kBeginning = 16;  // bytes: stamp and span
  if (request.num_bytes < kBeginning) return false;
  ros::serialization::IStream stream(request.message_start,
                                     static_cast<std::uint32_t>(request.num_bytes));
  GetBoxes::Request message;
  stream.next(message.stamp);
  stream.next(message.span);
  return message.span.toNSec() > 0;  // ros::Duration's > is wrong for nanoseconds < 0 or >= 1e9
}

BoxRequest toRequest(GetBoxes::Request& message) {
  if (!isTime(message.stamp))
    throw std::runtime_error("stamp is no time that tf can handle; 0 asks for the latest boxes");
  BoxRequest request;
  request.stamp = nanosecondsOf(message.stamp);
  request.span = message.span.toNSec();
  request.frame = tfName("", message.frame);
  request.names = std::move(message.names);
  if (request.span < 0) {
    throw std::runtime_error("span is " + std::to_string(message.span.toSec()) +
                             " s; it must be 0 or more");
  }
  return request;
}

std::string messageOf(const PastBoxes& boxes) {
  std::string text = logText(boxes.problem);
  if (boxes.late > 0) {
    text += "; " + std::to_string(boxes.late) +
            " boxes were not computed within 10 s: ask for a shorter span or for fewer names";
  }
  return text;
}

}  // namespace

/// The state of a request between two turns.
struct BoxService::Job {
  Job(BoxRequest box_request, std::unique_ptr<PastScene> copy, std::atomic<std::size_t>& bytes)
      : request(std::move(box_request)),
        scene(std::move(copy)),
        maker(*scene, request),
        copied_bytes(bytes) {
    copied_bytes += scene->excerpt.bytes();
  }
  ~Job() { copied_bytes -= scene->excerpt.bytes(); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  BoxRequest request;
  std::unique_ptr<PastScene> scene;
  PastBoxMaker maker;
  std::atomic<std::size_t>& copied_bytes;
};

BoxService::BoxService(ros::NodeHandle& private_node, const SceneCopier& scenes)
    : scenes_(scenes),
      moments_({"requests for boxes"}),
      spans_({"requests for spans", true}),
      queue_(moments_, spans_),
      service_(private_node, kGetBoxesService, queue_, [this](auto&... all) { answer(all...); }) {}

/// Stops the workers before the service is destroyed. The service waits for a running request,
/// which may wait for the update thread, and that thread runs this destructor.
BoxService::~BoxService() {
  moments_.stop();
  spans_.stop();
}

/// Throws NextTurn, or an error with the reason why there is no answer. The answer to a finished
/// span is sent by moments_, whose thread has normal priority.
void BoxService::answer(Call& call, const Params& params, GetBoxes::Response& response) {
  if (call.isNew() && hasSpan(params.request)) {
    call.is_long = true;
    throw TurnQueue::NextTurn();
  }
  Worker& worker = call.is_long ? spans_ : moments_;
  if (!call.state) call.state = begin(worker, call, params);
  Job& job = *std::static_pointer_cast<Job>(call.state);
  const auto gives_up = [&] {
    return worker.isStopping() || Clock::now() >= call.arrival + kDeadline;
  };
  const std::chrono::nanoseconds budget = call.is_long ? kLongestTurn : kNoPause;
  if (!job.maker.proceed(budget, gives_up)) throw TurnQueue::NextTurn();
  if (worker.isStopping()) throw std::runtime_error(kStopping);
  if (std::exchange(call.is_long, false)) throw TurnQueue::NextTurn();
  const PastBoxes boxes = job.maker.take();
  fillBoxes(boxes.moment, response.boxes);
  response.message = messageOf(boxes);
  response.success = true;
}

/// Throws an error with the reason why there is no answer, or NextTurn while there is no memory for
/// another span.
std::shared_ptr<BoxService::Job> BoxService::begin(Worker& worker, const Call& call,
                                                   const Params& params) {
  const auto deadline = call.arrival + kDeadline;
  const bool is_late = Clock::now() >= deadline;
  if (call.is_long && copied_bytes_ >= kMaxCopiedBytes && !is_late) throw TurnQueue::NextTurn();
  if (is_late) throw std::runtime_error(kTooBusy);
  Received<GetBoxes::Request> message = service_.read(params, "ask for fewer names");
  BoxRequest box_request = toRequest(message);
  if (!scenes_.model()) {
    throw std::runtime_error(
        "there are no boxes yet, because no robot was loaded; ask again after the first ~boxes");
  }
  std::unique_ptr<PastScene> scene = scenes_.copy(worker, box_request, deadline);
  if (!scene) throw std::runtime_error(worker.isStopping() ? kStopping : kTooBusy);
  const std::string refusal = whyRefused(*scene);
  if (!refusal.empty()) throw std::runtime_error(refusal);
  return std::make_shared<Job>(std::move(box_request), std::move(scene), copied_bytes_);
}

}  // namespace link_bounds
