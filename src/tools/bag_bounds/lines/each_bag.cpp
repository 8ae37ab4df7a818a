// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A process per bag, which sends its line through a pipe. Processes are forked while there is only
// one thread.
#include "tools/bag_bounds/lines/each_bag.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <list>
#include <map>
#include <new>
#include <system_error>

#include "robot/threads/row_threads.h"
#include "tools/bag_bounds/lines/bag_line.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;
using Share = std::atomic<double>;  // the share of each bag that has been read, 0 to 1

constexpr int kPollPause = 100;  // ms between looks at interrupts and progress
constexpr int kCodeBits = 3;     // bits of an exit code; the process of a bag returns two codes
constexpr int kInterrupted = 5;  // exit code of a process that sent no whole line

[[noreturn]] void failed(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// False on a full disk or a closed pipe.
bool writeAll(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

/// Zeros that processes share with their parent, until the program ends: one for each bag.
Share* sharedZeros(std::size_t count) {
  void* const memory = mmap(nullptr, count * sizeof(Share), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) failed("cannot share memory");
  return new (memory) Share[count]();
}

/// A process that reads a bag.
struct Reading {
  std::size_t bag;
  pid_t process;
  int pipe;
  std::string text;  ///< the part of its line that has arrived
};

std::string whyDied(int status) {
  const std::string remedy = "; --resume tries it again";
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return std::string("the process that read it was ended by signal ") + std::to_string(signal) +
           " (" + strsignal(signal) + ")" +
           (signal == SIGKILL ? ", as the kernel does when memory is short" : "") + remedy;
  }
  return "the process that read it ended without a line" + remedy;
}

class EachBag {
 public:
  EachBag(const BagBoundsOptions& options, BagQuestion& question)
      : options_(options),
        question_(question),
        fingerprint_(question.fingerprint()),
        shares_(sharedZeros(options.bags.size())) {
    for (const std::string& bag : options.bags)
      bags_.push_back(identityOf(bag));
    resume();
  }
  ~EachBag() { endAll(); }
  EachBag(const EachBag&) = delete;
  EachBag& operator=(const EachBag&) = delete;

  int run() {
    const std::size_t jobs = options_.jobs.value_or(coreCount());
    while ((!waiting_.empty() || !readings_.empty()) && !isInterrupted()) {
      while (readings_.size() < jobs && !waiting_.empty())
        start();
      collect();
      showProgress();
    }
    if (hasTerminal()) eraseBar();
    return finish();
  }

 private:
  void resume();
  void checkAppends(const std::string& file) const;
  void add(const BagLine& line);
  std::optional<BagLine> knownLine(const BagIdentity& bag,
                                   const std::vector<LineFile>& files) const;
  void start();
  [[noreturn]] void read(std::size_t bag, int pipe);
  BagLine lineOfBag(std::size_t bag);
  void collect();
  void close(std::list<Reading>::iterator reading);
  void showProgress();
  void endAll();
  int finish() const;

  const BagBoundsOptions& options_;
  BagQuestion& question_;
  const std::string fingerprint_;
  std::vector<BagIdentity> bags_;
  std::vector<double> bytes_;  ///< bytes to be read, by bag
  Share* const shares_;
  std::list<std::size_t> waiting_;
  std::list<Reading> readings_;
  std::size_t resumed_ = 0;
  std::size_t done_ = 0;
  std::map<int, std::size_t> exit_codes_;  ///< number of bags by exit code, with lines of --resume
  int worst_ = 0;                          ///< the worst of these, as the user demands
  const Clock::time_point begin_ = Clock::now();
};

/// Throws UsageError if standard output overwrites a file of --resume: its lines would be lost.
void EachBag::checkAppends(const std::string& file) const {
  struct stat read {
  }, written{};
  if (stat(file.c_str(), &read) != 0 || fstat(STDOUT_FILENO, &written) != 0) return;
  if (read.st_dev != written.st_dev || read.st_ino != written.st_ino) return;
  if ((fcntl(STDOUT_FILENO, F_GETFL) & O_APPEND) == 0)
    throw UsageError("standard output replaces " + file + " of --resume; append to it with >>");
}

void EachBag::resume() {
  std::vector<LineFile> files;
  for (const std::string& file : options_.resume) {
    checkAppends(file);
    files.push_back(readLines(file));
  }
  for (const std::string& place : placesOfCut(files))
    warn(place + " was cut; its bag is read again");
  for (std::size_t i = 0; i < bags_.size(); ++i) {
    const std::optional<BagLine> line = knownLine(bags_[i], files);
    bytes_.push_back(line ? 0 : static_cast<double>(bags_[i].size.value_or(0)));
    if (line) {
      ++resumed_;
      add(*line);
    } else {
      waiting_.push_back(i);
    }
  }
  if (!files.empty())
    say(std::to_string(resumed_) + " of " + std::to_string(bags_.size()) +
        " bags have a line already");
}

void EachBag::add(const BagLine& line) {
  ++exit_codes_[line.exit_code];
  worst_ = worseCode(worst_, line.exitCode(options_.demand));
}

/// The line of a bag in `files`; std::nullopt if it has none, or is to be read again.
std::optional<BagLine> EachBag::knownLine(const BagIdentity& bag,
                                          const std::vector<LineFile>& files) const {
  for (const LineFile& file : files) {
    const auto found = file.lines.find(bag.name);
    if (found == file.lines.end() || !bag.size) continue;
    const ReadLine& line = found->second;
    const bool is_same = line.bag.size == bag.size && line.bag.head == bag.head;
    if (is_same && line.question == fingerprint_ && !line.hasDied())
      return BagLine{line.text, line.exit_code, line.complete_code};
  }
  return std::nullopt;
}

void EachBag::start() {
  const std::size_t bag = waiting_.front();
  waiting_.pop_front();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) failed("cannot make a pipe");
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) failed("cannot start a process");
  if (process == 0) {
    // Only the parent reacts to a signal and ends this process: a terminal signals both.
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGTERM, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(kInterrupted);
    read(bag, ends[1]);
  }
  ::close(ends[1]);
  readings_.push_back({bag, process, ends[0], ""});
}

/// Runs in the process of a bag. Standard error is discarded, because the line has all messages.
void EachBag::read(std::size_t bag, int pipe) {
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDIN_FILENO);
  dup2(null, STDERR_FILENO);
  const BagLine line = lineOfBag(bag);
  _exit(writeAll(pipe, line.text) ? line.exit_code | line.complete_code << kCodeBits
                                  : kInterrupted);
}

BagLine EachBag::lineOfBag(std::size_t bag) {
  BagBoundsOptions options = options_;
  options.bags = {bags_[bag].name};
  options.jobs = 1;
  try {
    BagRun run(options, question_, [&share = shares_[bag]](double read) { share = read; });
    run.read();
    return lineOf(bags_[bag], fingerprint_, run, options.demand);
  } catch (const std::bad_alloc&) {
    return diedLine(bags_[bag], fingerprint_, "out of memory; --resume tries it again");
  } catch (const std::exception& error) {
    return unusableLine(bags_[bag], fingerprint_, error.what());
  }
}

/// Waits for parts of lines, at most kPollPause.
void EachBag::collect() {
  std::vector<pollfd> pipes;
  for (const Reading& reading : readings_)
    pipes.push_back({reading.pipe, POLLIN, 0});
  if (poll(pipes.data(), pipes.size(), kPollPause) <= 0) return;
  auto reading = readings_.begin();
  for (const pollfd& pipe : pipes) {
    const auto current = reading++;
    if (pipe.revents == 0) continue;
    char block[1 << 16];
    const ssize_t count = ::read(pipe.fd, block, sizeof(block));
    if (count > 0) {
      current->text.append(block, static_cast<std::size_t>(count));
    } else if (count == 0 && !isInterrupted()) {
      close(current);
    }
  }
}

/// Takes and writes the line of a bag whose process has closed its pipe.
void EachBag::close(std::list<Reading>::iterator reading) {
  int status = 0;
  while (waitpid(reading->process, &status, 0) < 0 && errno == EINTR) {
  }
  ::close(reading->pipe);
  const BagIdentity& bag = bags_[reading->bag];
  const bool is_whole = WIFEXITED(status) && !reading->text.empty() && reading->text.back() == '\n';
  const int codes = WEXITSTATUS(status);
  const BagLine line = is_whole
                           ? BagLine{reading->text, codes % (1 << kCodeBits), codes >> kCodeBits}
                           : diedLine(bag, fingerprint_, whyDied(status));
  shares_[reading->bag] = 1;
  readings_.erase(reading);
  if (!writeAll(STDOUT_FILENO, line.text))
    throw std::runtime_error(std::string("cannot write to standard output: ") + strerror(errno));
  ++done_;
  add(line);
}

std::string timeLeft(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 120) return std::to_string(whole) + " s left";
  if (whole < 7200) return std::to_string(whole / 60) + " min left";
  return std::to_string(whole / 3600) + " h left";
}

void EachBag::showProgress() {
  if (!hasTerminal()) return;
  double read = 0;
  double size = 0;
  for (std::size_t i = 0; i < bags_.size(); ++i) {
    read += shares_[i] * bytes_[i];
    size += bytes_[i];
  }
  const std::chrono::duration<double> passed = Clock::now() - begin_;
  const std::string left = read > 0 ? timeLeft(passed.count() * (size - read) / read) : "";
  drawBar(static_cast<std::size_t>(size > 0 ? 100 * read / size : 0), 100,
          "% of the bags, " + std::to_string(done_) + " done" + (left.empty() ? "" : ", " + left) +
              "   ");
}

void EachBag::endAll() {
  for (const Reading& reading : readings_) {
    kill(reading.process, SIGKILL);
    waitpid(reading.process, nullptr, 0);
    ::close(reading.pipe);
  }
  readings_.clear();
}

int EachBag::finish() const {
  int worst = worst_;
  if (isInterrupted()) {
    say("interrupted: " + std::to_string(done_) + " of " +
        std::to_string(waiting_.size() + readings_.size() + done_) +
        " bags are done, and have their lines; --resume goes on");
    worst = worseCode(worst, kOpen);
  }
  const auto count = [](const auto& entry) {
    return std::to_string(entry.second) + " " + verdictOf(entry.first);
  };
  const bool may_be_accepted = worst == kOpen && !isInterrupted();
  if (worst_ != 0)
    say(joined(exit_codes_, ", ", count) + "; the lines say why" +
        (may_be_accepted ? "; --allow-incomplete accepts what is incomplete" : ""));
  return worst;
}

}  // namespace

int runEach(const BagBoundsOptions& options, BagQuestion& question) {
  if (options.distances) question.loadTrees();
  return EachBag(options, question).run();
}

}  // namespace link_bounds
