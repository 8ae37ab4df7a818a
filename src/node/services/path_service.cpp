// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts requests, runs the proofs about their segments, and converts the result to a message.
#include "node/services/path_service.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "node/interface/topics.h"
#include "world/log/log_text.h"
#include "world/path/path_check.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

/// The part of the deadline that loading triangles may take.
constexpr std::chrono::seconds kLoading(7);

/// Max pairs of bodies of one request. A pair of meshes may take 80 KiB while it is examined.
constexpr std::size_t kMaxPairs = 10'000;
constexpr std::size_t kMaxBegun = 3;

/// Max points of a trajectory: more than an hour at 5 Hz. A point of a robot with 50 joints takes
/// 1.2 KB.
constexpr std::size_t kMaxPoints = 20'000;

/// Triangles are freed kKeep after their last use; kForgetEvery is the period of that check.
constexpr std::chrono::seconds kKeep(10);
constexpr std::chrono::milliseconds kForgetEvery(500);

}  // namespace

/// The state of a request between two turns.
struct PathService::Job {
  Job(std::unique_ptr<PastScene> copy, CheckPath::Request& request, const PathTrees& trees,
      const PathLimits& limits)
      : scene(std::move(copy)), check(*scene, request, trees, limits) {}

  std::string problem;  ///< why triangles are missing; a copy, as trees_ serves other jobs
  std::unique_ptr<PastScene> scene;
  PathCheck check;
};

PathService::PathService(ros::NodeHandle& private_node, const SceneCopier& scenes,
                         Worker& answering, PathTrees::Load load)
    : scenes_(scenes),
      trees_(std::move(load)),
      paths_({"requests for paths", true, [this] { return forgetIfUnused(); }, kForgetEvery}),
      queue_(answering, paths_),
      service_(private_node, kCheckPathService, queue_, [this](auto&... all) { answer(all...); }) {}

bool PathService::forgetIfUnused() {
  if (begun_ > 0 || Clock::now() - last_used_ < kKeep) return true;
  trees_.forget();
  return false;
}

/// Throws NextTurn, or an error with the reason why there is no answer. The answer is sent by the
/// worker `answering`, whose thread has normal priority.
void PathService::answer(Call& call, const Params& params, CheckPath::Response& response) {
  if (call.isNew()) {
    call.is_long = true;
    throw TurnQueue::NextTurn();
  }
  if (!call.is_long) {
    response = std::move(*std::static_pointer_cast<CheckPath::Response>(call.state));
    return;
  }
  last_used_ = Clock::now();
  if (!call.state) call.state = begin(call, params);
  Job& job = *std::static_pointer_cast<Job>(call.state);
  const auto is_over = [&] {
    return paths_.isStopping() || Clock::now() >= call.arrival + kDeadline;
  };
  if (!job.check.proceed(kLongestTurn, is_over)) throw TurnQueue::NextTurn();
  if (paths_.isStopping()) throw std::runtime_error(kStopping);
  auto found = std::make_shared<CheckPath::Response>(job.check.take());
  if (!found->message.empty() && !job.problem.empty()) found->message += "; " + job.problem;
  found->message = logText(found->message);
  call.state = std::move(found);
  call.is_long = false;
  throw TurnQueue::NextTurn();
}

/// Throws if the request is too large or incomplete, or if its clearance is not a valid number.
Received<CheckPath::Request> PathService::read(const Params& params) {
  Received<CheckPath::Request> request = service_.read(params, "send the trajectory in pieces");
  if (request.trajectory.points.size() > kMaxPoints)
    throw std::runtime_error("the trajectory has " +
                             std::to_string(request.trajectory.points.size()) +
                             " points, more than " + std::to_string(kMaxPoints) +
                             "; send it in pieces, each from the last point of the one before");
  if (!(std::isfinite(request.clearance) && request.clearance >= 0))
    throw std::runtime_error("clearance is " + std::to_string(request.clearance) +
                             " m; it must be a finite number, 0 or more");
  return request;
}

/// Throws an error with the reason why there is no answer, or NextTurn while kMaxBegun requests are
/// in progress.
std::shared_ptr<PathService::Job> PathService::begin(const Call& call, const Params& params) {
  const auto deadline = call.arrival + kDeadline;
  if (Clock::now() >= deadline) throw std::runtime_error(kTooBusy);
  if (begun_ >= kMaxBegun) throw TurnQueue::NextTurn();
  Received<CheckPath::Request> request = read(params);
  const std::shared_ptr<const Model> model = scenes_.model();
  if (!model || !model->robot)
    throw std::runtime_error("no robot was loaded; ask again after the first ~boxes of its links");
  std::unique_ptr<PastScene> scene = scenes_.copy(paths_, pathRequest(), deadline);
  if (!scene) throw std::runtime_error(paths_.isStopping() ? kStopping : kTooBusy);
  if (!scene->model->robot || scene->unknown_frame)
    throw std::runtime_error("tf does not know the fixed frame; ask again after the first ~boxes");
  trees_.prepare(*scene,
                 [&] { return paths_.isStopping() || Clock::now() >= call.arrival + kLoading; });
  std::string problem = trees_.problem();
  const PathLimits limits{kMaxPairs,
                          [&] { return paths_.isStopping() || Clock::now() >= deadline; }};
  auto job = std::make_unique<Job>(std::move(scene), request, trees_, limits);
  job->problem = std::move(problem);
  ++begun_;
  return {job.release(), [this](Job* finished) {
            --begun_;
            delete finished;
          }};
}

}  // namespace link_bounds
