// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Everything at once: tf, objects, lists, meshes, spans, reloads and clock jumps:
// storm_driver NODE PID FRESH_NODE LINKS SECONDS CSV MESH_URI ...
// Prints "over" after the storm. Then FRESH_NODE must be started; it gets the same scene, and both
// nodes must say the same. Prints one line of JSON. CSV gets the age of ~boxes over time.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "link_bounds/GetBoxes.h"
#include "node/load/ages.h"
#include "node/load/boxes_stamp.h"
#include "node/load/storm_answers.h"
#include "node/load/storm_scene.h"
#include "node/load/storm_sender.h"
#include "testing/patience.h"
#include "testing/process_census.h"
#include "testing/repeated.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds kPoll(5);

const Seconds kPatience(60 * patience()), kAnswerLimit(10 * patience());
constexpr Seconds kWarmUp(2);
constexpr Seconds kPeriod(kStormPeriod);
constexpr Seconds kCubesPeriod(0.1), kListPeriod(0.25), kMeshPeriod(0.5);
constexpr Seconds kReloadPeriod(7), kSamplePeriod(0.05);
constexpr double kJumpPeriod = 25;  // s
constexpr double kSpan = 2;         // s
constexpr std::uint32_t kUnlimited = 0;

struct Task {
  std::string node;
  int pid;
  std::string fresh;
  std::size_t links;
  Seconds length;
  std::string csv;
  std::vector<std::string> meshes;
};

void waitFor(const std::function<bool()>& condition, const std::string& what) {
  if (!becomesTrue(condition, kPatience, [] { return !ros::ok(); }))
    throw std::runtime_error("waited in vain until " + what);
}

/// What the node showed during the storm.
struct Seen {
  double resident_mb = 0;  ///< max
  double silence_s = 0;    ///< max time without diagnostics
  std::atomic<int> reloads{0}, refused_reloads{0}, spans{0}, failed_spans{0};
};

class Storm {
 public:
  explicit Storm(Task task)
      : task_(std::move(task)),
        sender_(node_, task_.links, ages_),
        scene_(task_.links, task_.meshes),
        objects_(node_.advertise<visualization_msgs::MarkerArray>(task_.node + "/objects", 1000)),
        fresh_objects_(
            node_.advertise<visualization_msgs::MarkerArray>(task_.fresh + "/objects", 10)) {
    boxes_ = node_.subscribe<BoxesStamp>(
        task_.node + "/boxes", kUnlimited,
        [this](const boost::shared_ptr<const BoxesStamp>& boxes) { ages_.answer(boxes->stamp); },
        {}, ros::TransportHints().tcpNoDelay());
    diagnostics_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          for (const auto& status : array->status)
            if ("/" + status.name == task_.node + ": boxes") diagnosed_ = Clock::now();
        });
  }

  void run() {
    ros::AsyncSpinner spinner(1);
    spinner.start();
    waitFor([this] { return sender_.hasSubscriber() && objects_.getNumSubscribers() > 0; },
            "the node listens");
    waitFor([this] { return diagnosed_.load() != Clock::time_point(); }, "diagnostics come");
    objects_.publish(scene_.allCubes());
    blow();
    waitFor([this] { return ages_.isAllAnswered(); }, "the last message is answered");
    spinner.stop();
    std::ostringstream ages;
    ages_.print(ages);
    storm_ages_ = ages.str();
    std::cout << "over" << std::endl;
    const std::string difference = compare();
    print(difference);
  }

 private:
  /// The activities end in the reverse order; tf goes on until all others have ended.
  void blow() {
    const double seconds = task_.length.count();
    const auto steps_per_jump =
        static_cast<std::uint64_t>(std::min(kJumpPeriod, seconds / 2) / kStormPeriod);
    std::uint64_t steps = 0;
    const Repeated tf(kPeriod, [&] {
      if (++steps % steps_per_jump == 0) sender_.jumpBack();
      sender_.step();
    });
    std::this_thread::sleep_for(kWarmUp);
    const Repeated objects(kCubesPeriod, [&, count = 0]() mutable {
      objects_.publish(scene_.nextCubes());
      if (++count % static_cast<int>(kListPeriod / kCubesPeriod) == 0)
        objects_.publish(scene_.nextList());
      if (count % static_cast<int>(kMeshPeriod / kCubesPeriod) == 0)
        objects_.publish(scene_.nextMesh());
    });
    const Repeated spans(Seconds(0), [this] { requestSpan(); });
    const Repeated reloads(kReloadPeriod, [this] { reload(); });
    watch();
  }

  void requestSpan() {
    if (!get_boxes_.isValid())
      get_boxes_ = ros::service::createClient<GetBoxes>(task_.node + "/get_boxes", true);
    GetBoxes span;
    span.request.span = ros::Duration(kSpan);
    const bool is_answered = get_boxes_.call(span) && span.response.success;
    ++(is_answered ? seen_.spans : seen_.failed_spans);
  }

  void reload() {
    std_srvs::Trigger reload;
    const bool is_done = ros::service::call(task_.node + "/reload", reload);
    ++(is_done && reload.response.success ? seen_.reloads : seen_.refused_reloads);
  }

  void watch() {
    std::ofstream csv(task_.csv);
    csv << "seconds,age_ms,resident_mb\n";
    const auto start = Clock::now();
    for (auto due = start; due < start + task_.length && ros::ok();) {
      const double resident = static_cast<double>(residentBytes(task_.pid)) / 1e6;
      seen_.resident_mb = std::max(seen_.resident_mb, resident);
      seen_.silence_s =
          std::max(seen_.silence_s, Seconds(Clock::now() - diagnosed_.load()).count());
      csv << Seconds(Clock::now() - start).count() << "," << ages_.waiting() << "," << resident
          << "\n";
      due += std::chrono::duration_cast<Clock::duration>(kSamplePeriod);
      std::this_thread::sleep_until(due);
    }
  }

  /// How the node differs from one that saw nothing of the storm; empty: not at all. At the first
  /// common moment the fresh node may have got the objects after the moment's tf, so that its
  /// outputs are of different objects; at the next one all are of what it has by then.
  std::string compare() {
    boxes_.shutdown();
    StormAnswers stormed(node_, task_.node);
    StormAnswers fresh(node_, task_.fresh);
    waitFor([this] { return fresh_objects_.getNumSubscribers() > 0; }, "the fresh node listens");
    fresh_objects_.publish(scene_.everything());
    const auto end = Clock::now() + kPatience;
    bool had_all = false;
    while (ros::ok() && Clock::now() < end) {
      if (!areBothOf(stormed, fresh, sender_.step())) continue;
      if (had_all) {
        std::cerr << stormed.counts() << "\n" << fresh.counts() << "\n";
        return stormed.differenceTo(fresh);
      }
      had_all = stormed.countBoxes() == fresh.countBoxes();
    }
    return "no common moment: " + stormed.counts() + "; " + fresh.counts();
  }

  /// Whether both nodes answer that message completely within a time.
  static bool areBothOf(const StormAnswers& a, const StormAnswers& b, ros::Time stamp) {
    const auto end = Clock::now() + kAnswerLimit;
    while (ros::ok() && Clock::now() < end) {
      ros::spinOnce();
      if (a.areOf(stamp) && b.areOf(stamp)) return true;
      std::this_thread::sleep_for(kPoll);
    }
    return false;
  }

  void print(const std::string& difference) const {
    std::cout << "{" << storm_ages_ << ", \"stall_ms\": " << stalls_.longest()
              << ", \"resident_mb\": " << seen_.resident_mb
              << ", \"silence_s\": " << seen_.silence_s << ", \"reloads\": " << seen_.reloads
              << ", \"refused_reloads\": " << seen_.refused_reloads
              << ", \"spans\": " << seen_.spans << ", \"failed_spans\": " << seen_.failed_spans
              << ", \"jumps\": " << sender_.jumps() << ", \"difference\": \"" << difference
              << "\"}\n";
  }

  ros::NodeHandle node_;
  Task task_;
  Ages ages_;
  StallWatch stalls_;
  StormSender sender_;
  StormScene scene_;
  ros::Publisher objects_;
  ros::Publisher fresh_objects_;
  ros::Subscriber boxes_;
  ros::Subscriber diagnostics_;
  /// Persistent, because roscpp may close another connection before it has read the answer
  /// (https://github.com/ros/ros_comm/issues/1976).
  ros::ServiceClient get_boxes_;
  std::atomic<Clock::time_point> diagnosed_{Clock::time_point()};
  Seen seen_;
  std::string storm_ages_;
};

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) try {
  ros::init(argc, argv, "storm_driver");
  if (argc < 8) {
    throw std::runtime_error(
        "usage: storm_driver NODE PID FRESH_NODE LINKS SECONDS CSV MESH_URI ...");
  }
  // A call of a service that is not answered waits without limit: then the signal ends it.
  alarm(static_cast<unsigned>(std::stod(argv[5]) + 2 * link_bounds::kPatience.count()));
  link_bounds::Storm({argv[1],
                      std::stoi(argv[2]),
                      argv[3],
                      std::stoul(argv[4]),
                      link_bounds::Seconds(std::stod(argv[5])),
                      argv[6],
                      {argv + 7, argv + argc}})
      .run();
} catch (const std::exception& error) {
  std::cerr << "storm_driver: " << error.what() << "\n";
  return 1;
}
