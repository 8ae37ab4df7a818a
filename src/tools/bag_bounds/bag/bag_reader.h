// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages of bags, in the order of their record times.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace link_bounds {

/// One message as it was recorded. What it points to is valid until the next call of the reader.
struct BagMessage {
  const std::string* topic;      ///< with a slash in front
  const std::string* type;       ///< such as tf2_msgs/TFMessage; "" if the bag does not say it
  const std::string* publisher;  ///< name of the node that sent it; "" if the bag does not say it
  std::int64_t time;             ///< when it was recorded [ns]
  const std::uint8_t* data;      ///< serialised
  std::uint32_t size;            ///< [bytes]
};

class BagFile;
class ChunkThreads;

/// Reads each file once, from its begin to its end, without its index, so that its memory does not
/// depend on the length of the files, and a file that was cut, damaged or never closed is read as
/// far as possible.
///
/// rosbag's own reader, rosbag::View, needs the index: it refuses a bag that was cut or not closed,
/// ends at a damaged chunk, and remembers each message. At 100 Hz it takes 17 MB for 10 minutes and
/// 60 MB for 2 hours; this reader takes 4 MB. rosbag::View takes 5 times as long to read and
/// deserialise such a bag (scripts/bench bag, Debian 12).
class BagReader {
 public:
  /// Reads only messages of `topics`; of all topics if there are none. Throws std::runtime_error if
  /// a file cannot be read at all. `is_interrupted` is called regularly while next() searches for a
  /// message, also within a compressed chunk; true ends the reading. `threads` unpack compressed
  /// chunks; the messages do not depend on their number.
  BagReader(
      const std::vector<std::string>& files, const std::set<std::string>& topics,
      const std::function<bool()>& is_interrupted = [] { return false; }, unsigned threads = 1);
  ~BagReader();
  BagReader(const BagReader&) = delete;
  BagReader& operator=(const BagReader&) = delete;

  /// The next message; false after the last one, or if interrupted. The messages of one file keep
  /// their order: if times go back, the clock has jumped. Several files are merged by time.
  bool next(BagMessage& message);

  /// Whether a file goes back to this time or an earlier one, although all further messages should
  /// be later. next() must not be called any more.
  bool goesBackTo(std::int64_t time);

  /// Time of the last message of any topic [ns], after next() has returned false. The min of its
  /// type if there is no message.
  std::int64_t endTime() const;

  /// Whether an interrupt ended next() before the last message.
  bool wasInterrupted() const { return was_interrupted_; }

  /// How much has been read, 0 to 1, by bytes of the files.
  double progress() const;

  /// Parts that could not be read so far, one line each: file, place, loss, remedy.
  const std::vector<std::string>& losses() const { return losses_; }

 private:
  struct Source;

  const std::set<std::string> topics_;
  std::vector<std::string> losses_;
  std::unique_ptr<ChunkThreads> threads_;
  std::vector<Source> sources_;
  Source* last_ = nullptr;  ///< the source of the last message
  bool has_begun_ = false;
  bool was_interrupted_ = false;
};

}  // namespace link_bounds
