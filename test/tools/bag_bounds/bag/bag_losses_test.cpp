// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is read of bags that end too early or are damaged, and what is said about the loss.
#include <gtest/gtest.h>

#include "testing/bag_testing.h"
#include "testing/temporary_folder.h"
#include "tools/bag_bounds/bag/bag_reader.h"
#include "tools/bag_bounds/bag/records/chunk.h"

namespace link_bounds {
namespace {

using Lines = std::vector<std::string>;

std::vector<RecordedMessage> messagesOf(int count) {
  std::vector<RecordedMessage> messages;
  for (int i = 0; i < count; ++i)
    messages.push_back({i % 2 ? "/a" : "/b", 1000 + i, "message " + std::to_string(i)});
  return messages;
}

struct Reading {
  std::string numbers;  ///< of the messages that were read
  Lines losses;         ///< after the name of the file
};

Reading read(const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.bag", bytes);
  BagReader reader({file}, {});
  Reading result;
  for (const RecordedMessage& message : readAll(reader))
    result.numbers += std::to_string(message.time - 1000);
  for (const std::string& loss : reader.losses()) {
    EXPECT_EQ(loss.substr(0, file.size() + 2), file + ": ");
    result.losses.push_back(loss.substr(file.size() + 2));
  }
  return result;
}

const std::string kNotClosed =
    "was not closed by its recorder: its last messages may be missing; end rosbag record with "
    "Ctrl-C and wait for it";

std::string damaged(const std::string& what) {
  return what + ": messages are missing; copy it again from where it was recorded";
}

std::string range(std::uint64_t begin, std::uint64_t end) {
  return "bytes " + std::to_string(begin) + " to " + std::to_string(end);
}

void replace(std::string& bytes, std::uint64_t position, const std::string& by) {
  bytes.replace(position, by.size(), by);
}

// The header of a bag that was not closed.
std::string openHeader() {
  return kBagVersionLine + bagHeader(0, 0, 0) + withSize("");
}

const BagTopic kTopic{"/b", "std_msgs/String", "*", "", "/recorded"};

std::string messageRecord(std::uint32_t connection, int number) {
  return messageHeader(connection, 1000 + number) + withSize("message");
}

TEST(BagLosses, ABagThatWasNotClosedIsReadUpToItsEnd) {
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    BagBytes bag = bagOf(messagesOf(6), compression);
    replace(bag.bytes, sizeof kBagVersionLine - 1, bagHeader(0, 0, 0));
    const Reading reading = read(bag.bytes.substr(0, bag.index));
    EXPECT_EQ(reading.numbers, "012345") << compression;
    EXPECT_EQ(reading.losses, Lines{kNotClosed}) << compression;
  }
}

// A recorder writes the sizes into the header of a chunk when it is complete.
TEST(BagLosses, TheLastChunkNeedsNotBeCompleted) {
  const std::string records =
      connectionRecord(0, kTopic) + messageRecord(0, 0) + messageRecord(0, 1);
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    const Reading reading = read(openHeader() + chunkHeader(compression, 0) +
                                 bytesOf(std::uint32_t{0}) + compressed(compression, records));
    EXPECT_EQ(reading.numbers, "01") << compression;
    EXPECT_EQ(reading.losses, Lines{kNotClosed}) << compression;
  }
}

TEST(BagLosses, ABagWhoseRecorderWasKilledIsReadUpToItsLastMessage) {
  const std::string records = connectionRecord(0, kTopic) + messageRecord(0, 0);
  const Reading reading = read(openHeader() + chunkHeader("none", 0) + bytesOf(std::uint32_t{0}) +
                               records + messageRecord(0, 1).substr(0, 40));
  EXPECT_EQ(reading.numbers, "0");
  EXPECT_EQ(reading.losses, Lines{kNotClosed});
}

TEST(BagLosses, AChunkThatIsMissingIsSaid) {
  BagBytes bag = bagOf(messagesOf(9));
  bag.bytes.erase(bag.chunks[1], bag.chunks[2] - bag.chunks[1]);
  replace(bag.bytes, sizeof kBagVersionLine - 1,
          bagHeader(bag.index - (bag.chunks[2] - bag.chunks[1]), 2, 3));
  const Reading reading = read(bag.bytes);
  EXPECT_EQ(reading.numbers, "012678");
  EXPECT_EQ(reading.losses, Lines{damaged("has 2 of its 3 chunks")});
}

TEST(BagLosses, ABagThatWasCutIsReadUpToThere) {
  const BagBytes bag = bagOf(messagesOf(6));
  const std::uint64_t end = bag.message_ends[4];
  for (const std::uint64_t size : {end, end + 1, bag.message_ends[5] - 1}) {
    const Reading reading = read(bag.bytes.substr(0, size));
    EXPECT_EQ(reading.numbers, "01234") << size;
    EXPECT_EQ(reading.losses, Lines{damaged("was cut at byte " + std::to_string(size))}) << size;
  }
}

TEST(BagLosses, ACompressedBagThatWasCutIsReadUpToThere) {
  for (const std::string compression : {"bz2", "lz4"}) {
    const BagBytes bag = bagOf(messagesOf(6), compression);
    const std::uint64_t size = bag.chunks[1] + 70;
    const Reading reading = read(bag.bytes.substr(0, size));
    EXPECT_EQ(reading.numbers, "012") << compression;
    EXPECT_EQ(reading.losses, Lines{damaged("was cut at byte " + std::to_string(size))})
        << compression;
  }
}

TEST(BagLosses, WholeBlocksOfAChunkThatWasCutAreRead) {
  const std::string large(40000, 'x');  // an lz4 block has 64 kB
  std::vector<RecordedMessage> messages = messagesOf(5);
  for (RecordedMessage& message : messages)
    message.data = large;
  const BagBytes bag = bagOf(messages, "lz4", 5);
  const Reading reading =
      read(bag.bytes.substr(0, bag.chunks[0] + (bag.index - bag.chunks[0]) / 2));
  EXPECT_EQ(reading.numbers.substr(0, 1), "0");
  EXPECT_LT(reading.numbers.size(), 5U);
  EXPECT_EQ(reading.losses.size(), 1U);
}

TEST(BagLosses, ACutIndexLosesNothing) {
  const BagBytes bag = bagOf(messagesOf(6));
  const Reading reading = read(bag.bytes.substr(0, bag.bytes.size() - 3));
  EXPECT_EQ(reading.numbers, "012345");
  EXPECT_EQ(reading.losses, Lines());
}

TEST(BagLosses, ADamagedRecordCostsItsMessageOnly) {
  BagBytes bag = bagOf(messagesOf(6), "none", 6);
  replace(bag.bytes, bag.message_ends[2] + 4, "damage");
  const Reading reading = read(bag.bytes);
  EXPECT_EQ(reading.numbers,
            "01"
            "45");  // the length of message 2 cannot be trusted
  ASSERT_EQ(reading.losses.size(), 1U);
  EXPECT_EQ(reading.losses[0].substr(0, 6), "bytes ");
}

TEST(BagLosses, ADamagedChunkCostsItsMessagesOnly) {
  for (const std::string compression : {"bz2", "lz4"}) {
    BagBytes bag = bagOf(messagesOf(9), compression);
    const std::uint64_t header_size = chunkHeader(compression, 0).size() + 4;
    replace(bag.bytes, bag.chunks[1] + header_size + 30, "damage");
    const Reading reading = read(bag.bytes);
    EXPECT_EQ(reading.numbers, "012678") << compression;
    const std::uint64_t next =  // an index record with three fields
        bag.chunks[2] -
        headerBytes(RecordOp::kIndex, fieldBytes("ver", "1234") + fieldBytes("conn", "1234") +
                                          fieldBytes("count", "1234"))
            .size() -
        4;
    EXPECT_EQ(reading.losses,
              Lines{damaged(range(bag.chunks[1], next) + " are a chunk with damaged data")});
  }
}

TEST(BagLosses, ADamagedChunkHeaderCostsItsMessagesOnly) {
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    BagBytes bag = bagOf(messagesOf(9), compression);
    replace(bag.bytes, bag.chunks[1] + 4, "damage");
    const Reading reading = read(bag.bytes);
    EXPECT_EQ(reading.numbers, compression == "none" ? "012345678" : "012678") << compression;
    EXPECT_EQ(reading.losses.size(), 1U);
  }
}

TEST(BagLosses, LengthsOfAChunkMayBeWrong) {
  for (const std::string compression : {"none", "bz2", "lz4"}) {
    BagBytes bag = bagOf(messagesOf(9), compression);
    const std::uint64_t length = bag.chunks[1] + chunkHeader(compression, 0).size();
    replace(bag.bytes, length - 4, std::string(4, '\xff'));  // 4 GB
    replace(bag.bytes, length, std::string(4, '\xff'));
    const Reading reading = read(bag.bytes);
    EXPECT_EQ(reading.numbers, "012345678") << compression;
    EXPECT_EQ(reading.losses, Lines()) << compression;
  }
}

// Its data would reach to the end of the next chunk, where a record begins.
TEST(BagLosses, AnIndexWithAWrongLengthHidesNoMessages) {
  BagBytes bag = bagOf(messagesOf(9));
  const std::uint64_t next_index = bag.message_ends[5];
  replace(bag.bytes, bag.chunks[1] - 4,
          bytesOf(static_cast<std::uint32_t>(next_index - bag.chunks[1])));
  const Reading reading = read(bag.bytes);
  EXPECT_EQ(reading.numbers.substr(reading.numbers.size() - 6), "345678");
  EXPECT_EQ(reading.losses.size(), 1U);
}

TEST(BagLosses, TheIndexSaysWhichTopicsALostChunkHasAnnounced) {
  BagBytes bag = bagOf(messagesOf(6), "bz2");
  replace(bag.bytes, bag.chunks[0] + 100, "damage");
  const Reading reading = read(bag.bytes);
  EXPECT_EQ(reading.numbers, "345");
  EXPECT_EQ(reading.losses.size(), 1U);
}

TEST(BagLosses, MessagesWithoutTopicAreCounted) {
  const Reading reading =
      read(openHeader() + chunkRecord("none", connectionRecord(0, kTopic) + messageRecord(0, 0) +
                                                  messageRecord(7, 1) + messageRecord(7, 2)));
  EXPECT_EQ(reading.numbers, "0");
  EXPECT_EQ(reading.losses, Lines{"2 messages have no topic, because its record is lost; copy it "
                                  "again from where it was recorded"});
}

TEST(BagLosses, AnImpossibleTimeIsDamage) {
  const std::string odd = headerBytes(
      RecordOp::kMessage, fieldBytes("conn", bytesOf(0U)) +
                              fieldBytes("time", bytesOf(1U) + bytesOf(std::uint32_t{1000000000})));
  const Reading reading =
      read(openHeader() +
           chunkRecord("none", connectionRecord(0, kTopic) + messageRecord(0, 0) +
                                   messageRecord(0, 1) + odd + withSize("") + messageRecord(0, 2)));
  EXPECT_EQ(reading.numbers, "02");
  EXPECT_EQ(reading.losses.size(), 1U);
}

TEST(BagLosses, AnUnknownCompressionIsALoss) {
  const BagBytes bag = bagOf(messagesOf(3));
  const std::string chunk = chunkHeader("zst", 4) + withSize("data");
  const Reading reading = read(bag.bytes.substr(0, bag.chunks[0]) + chunk +
                               bag.bytes.substr(bag.chunks[0], bag.index - bag.chunks[0]));
  EXPECT_EQ(reading.numbers, "012");
  EXPECT_EQ(reading.losses, Lines{damaged(range(bag.chunks[0], bag.chunks[0] + chunk.size()) +
                                          " are a chunk of an unknown compression")});
}

TEST(BagLosses, ABagWithoutHeaderIsRead) {
  BagBytes bag = bagOf(messagesOf(3));
  replace(bag.bytes, 20, "damage");
  const Reading reading = read(bag.bytes);
  EXPECT_EQ(reading.numbers, "012");
  EXPECT_EQ(reading.losses, Lines{damaged(range(13, bag.chunks[0]) + " are damaged")});
}

TEST(BagLosses, MuchDamageIsListedInAFewLines) {
  BagBytes bag = bagOf(messagesOf(200), "none", 200);
  for (std::size_t i = 0; i < 200; i += 4)
    replace(bag.bytes, bag.message_ends[i] + 4, "damage");
  const Reading reading = read(bag.bytes);
  ASSERT_EQ(reading.losses.size(), 21U);
  EXPECT_EQ(reading.losses[20], "has more damage; not listed");
}

// Little input that becomes more memory than a chunk may have.
TEST(BagLosses, AChunkThatBecomesTooLargeIsNotRead) {
  constexpr std::size_t kBlock = 4 << 20;
  const std::string zeros(kBlock, '\0');
  LZ4F_cctx* context = nullptr;
  LZ4F_createCompressionContext(&context, LZ4F_VERSION);
  std::string data(kMaxChunkSize / 200 + 2 * kBlock, '\0');
  std::size_t size = LZ4F_compressBegin(context, &data[0], data.size(), nullptr);
  for (std::size_t i = 0; i <= kMaxChunkSize / kBlock; ++i)
    size += LZ4F_compressUpdate(context, &data[size], data.size() - size, zeros.data(), kBlock,
                                nullptr);
  size += LZ4F_compressEnd(context, &data[size], data.size() - size, nullptr);
  LZ4F_freeCompressionContext(context);
  data.resize(size);
  const BagBytes bag = bagOf(messagesOf(3), "lz4");
  const Reading reading =
      read(bag.bytes.substr(0, bag.chunks[0]) + chunkHeader("lz4", 0) + withSize(data) +
           bag.bytes.substr(bag.chunks[0], bag.index - bag.chunks[0]));
  EXPECT_EQ(reading.numbers, "012");
  ASSERT_EQ(reading.losses.size(), 1U);
  EXPECT_NE(reading.losses[0].find("are a chunk that is too large"), std::string::npos);
}

}  // namespace
}  // namespace link_bounds
