// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader gives of bags that are whole, and which files it refuses.
#include "tools/bag_bounds/bag/bag_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>

#include "testing/bag_testing.h"
#include "testing/refusal.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

using Messages = std::vector<RecordedMessage>;

const Messages kMessages{
    {"/tf", 1000000000, "first", "tf2_msgs/TFMessage", "/robot_state_publisher"},
    {"/tf_static", 1000000001, "static", "tf2_msgs/TFMessage", "/robot_state_publisher"},
    {"/tf", 1000000002, "localization", "tf2_msgs/TFMessage", "/amcl"},
    {"/chatter", 2000000000, ""},
    {"/tf", 2999999999, std::string(70000, 'x'), "tf2_msgs/TFMessage", "/robot_state_publisher"},
    {"/chatter", 4294967295999999999, "as late as a bag can say"},
    {"/tf", 5, "the clock has jumped", "tf2_msgs/TFMessage", "/amcl"}};

Messages ofTopic(const std::string& topic) {
  Messages result;
  for (const RecordedMessage& message : kMessages)
    if (message.topic == topic) result.push_back(message);
  return result;
}

std::vector<std::int64_t> timesOf(BagReader& reader) {
  std::vector<std::int64_t> times;
  for (const RecordedMessage& message : readAll(reader))
    times.push_back(message.time);
  return times;
}

std::string refusal(const std::vector<std::string>& files) {
  return refusalOf<std::runtime_error>([&] { BagReader reader(files, {}); });
}

TEST(BagReader, GivesEachMessageInTheOrderOfTheFile) {
  const TemporaryFolder folder;
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    BagReader reader({folder.write("a.bag", bagOf(kMessages, compression).bytes)}, {});
    EXPECT_EQ(readAll(reader), kMessages) << compression;
    EXPECT_EQ(reader.losses(), std::vector<std::string>()) << compression;
    EXPECT_EQ(reader.progress(), 1.0) << compression;
  }
}

TEST(BagReader, GivesOnlyMessagesOfItsTopics) {
  const TemporaryFolder folder;
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    BagReader reader({folder.write("a.bag", bagOf(kMessages, compression).bytes)},
                     {"/tf", "/absent"});
    EXPECT_EQ(readAll(reader), ofTopic("/tf")) << compression;
    EXPECT_EQ(reader.losses(), std::vector<std::string>()) << compression;
  }
}

TEST(BagReader, ATopicWithoutSlashIsInTheRootNamespace) {
  const TemporaryFolder folder;
  writeBag(folder / "a.bag", {{"tf", 1, "first"}, {"/tf", 2, "second"}});
  BagReader reader({folder / "a.bag"}, {"/tf"});
  EXPECT_EQ(readAll(reader), (Messages{{"/tf", 1, "first"}, {"/tf", 2, "second"}}));
}

TEST(BagReader, ReadsWhatTheWriterWrites) {
  const TemporaryFolder folder;
  Messages messages;
  for (int i = 0; i < 50; ++i)
    messages.insert(messages.end(), kMessages.begin(), kMessages.end());
  writeBag(folder / "a.bag", messages);
  BagReader reader({folder / "a.bag"}, {});
  EXPECT_EQ(readAll(reader), messages);
  EXPECT_EQ(reader.losses(), std::vector<std::string>());
}

TEST(BagReader, AnEmptyBagHasNoMessages) {
  const TemporaryFolder folder;
  writeBag(folder / "a.bag", {});
  BagReader reader({folder / "a.bag"}, {});
  EXPECT_EQ(readAll(reader), Messages());
  EXPECT_EQ(reader.losses(), std::vector<std::string>());
  EXPECT_EQ(reader.progress(), 1.0);
}

TEST(BagReader, ProgressGrowsWithTheBytes) {
  const TemporaryFolder folder;
  BagReader reader({folder.write("a.bag", bagOf(kMessages, "none", 1).bytes)}, {});
  double progress = reader.progress();
  EXPECT_GE(progress, 0.0);
  for (BagMessage message; reader.next(message);) {
    EXPECT_GT(reader.progress(), progress);
    progress = reader.progress();
  }
  EXPECT_EQ(reader.progress(), 1.0);
}

TEST(BagReader, MergesFilesByTheTimesOfRecording) {
  const TemporaryFolder folder;
  writeBag(folder / "a.bag", {{"/tf", 10, ""}, {"/tf", 40, ""}, {"/tf", 50, ""}});
  writeBag(folder / "b.bag", {{"/tf", 20, ""}, {"/tf", 30, ""}, {"/tf", 60, ""}});
  writeBag(folder / "c.bag", {});
  BagReader reader({folder / "a.bag", folder / "b.bag", folder / "c.bag"}, {});
  EXPECT_EQ(timesOf(reader), (std::vector<std::int64_t>{10, 20, 30, 40, 50, 60}));
}

TEST(BagReader, EachOfSeveralFilesKeepsItsOwnOrder) {
  const TemporaryFolder folder;
  writeBag(folder / "a.bag", {{"/tf", 10, ""}, {"/tf", 40, ""}, {"/tf", 15, ""}});
  writeBag(folder / "b.bag", {{"/tf", 20, ""}, {"/tf", 41, ""}});
  BagReader reader({folder / "a.bag", folder / "b.bag"}, {});
  EXPECT_EQ(timesOf(reader), (std::vector<std::int64_t>{10, 20, 40, 15, 41}));
}

TEST(BagReader, OfEqualTimesTheFirstFileComesFirst) {
  const TemporaryFolder folder;
  writeBag(folder / "a.bag", {{"/tf", 10, "a"}, {"/tf", 20, "a"}});
  writeBag(folder / "b.bag", {{"/tf", 10, "b"}, {"/tf", 20, "b"}});
  BagReader reader({folder / "b.bag", folder / "a.bag"}, {});
  std::string order;
  for (const RecordedMessage& message : readAll(reader))
    order += message.data;
  EXPECT_EQ(order, "baba");
}

TEST(BagReader, RefusesWhatIsNoBag) {
  const TemporaryFolder folder;
  mkfifo((folder / "pipe").c_str(), 0600);
  EXPECT_EQ(refusal({folder / "absent"}),
            folder / "absent: cannot be opened: No such file or directory");
  EXPECT_EQ(refusal({folder / ""}), folder / ": is not an ordinary file");
  EXPECT_EQ(refusal({folder / "pipe"}), folder / "pipe: is not an ordinary file");
  EXPECT_EQ(refusal({folder.write("empty")}), folder / "empty: is empty; record it again");
  for (const std::string text : {"#", "#ROSBAG", "#ROSBAG V2.0", "a text that is no bag"})
    EXPECT_EQ(refusal({folder.write("text", text)}),
              folder / "text: is not a bag: its first line is not #ROSBAG V2.0");
}

TEST(BagReader, SaysHowToConvertAnOldBag) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal({folder.write("old.bag", "#ROSBAG V1.2\nmore")}),
            folder /
                "old.bag: is a bag of version 1.2, not 2.0; convert it: rosbag filter OLD.bag "
                "NEW.bag True");
}

TEST(BagReader, SaysHowToDecryptABag) {
  const TemporaryFolder folder;
  const std::string header =
      headerBytes(RecordOp::kBagHeader, fieldBytes("index_pos", bytesOf(std::uint64_t{0})) +
                                            fieldBytes("conn_count", bytesOf(1U)) +
                                            fieldBytes("chunk_count", bytesOf(1U)) +
                                            fieldBytes("encryptor", "rosbag/AesCbcEncryptor"));
  EXPECT_EQ(refusal({folder.write("a.bag", kBagVersionLine + header + withSize(""))}),
            folder / "a.bag: is encrypted; decrypt it: rosbag decrypt FILE.bag");
}

TEST(BagWriter, SaysThatAFileCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(BagWriter(folder / "absent/a.bag"), std::runtime_error);
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_THROW(writeBag("/dev/full", kMessages), std::runtime_error);
}

}  // namespace
}  // namespace link_bounds
