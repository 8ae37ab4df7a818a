// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bags with random damage, and bags cut at each byte: the reader ends, gives no more than was
// there, and takes little memory.
#include <gtest/gtest.h>

#include <random>

#include "testing/bag_testing.h"
#include "testing/replaced_new.h"
#include "testing/sanitized.h"
#include "tools/bag_bounds/bag/bag_file.h"
#include "tools/bag_bounds/bag/records/chunk.h"

namespace link_bounds {
namespace {

// The largest request for memory [bytes]. Damaged bz2 data of some bytes may become 46 MB.
constexpr std::size_t kMaxRequest = 1 << 20;
constexpr std::size_t kMaxRequestCompressed = kMaxChunkSize + (1 << 20);

std::vector<RecordedMessage> someMessages() {
  std::vector<RecordedMessage> messages;
  for (unsigned i = 0; i < 9; ++i)
    messages.push_back(
        {i % 3 ? "/a" : "/b", 1000000000LL * i, std::string(i * (11 + i), char('0' + i))});
  return messages;
}

const std::vector<RecordedMessage> kMessages = someMessages();

struct Reading {
  std::vector<RecordedMessage> messages;
  std::vector<std::string> losses;
};

// Nothing if it is refused.
Reading read(const std::string& bytes, std::size_t max_request, unsigned threads = 1) {
  const std::set<std::string> all_topics;
  Reading result;
  auto memory = std::make_unique<MemoryBytes>();
  memory->data.assign(bytes.begin(), bytes.end());
  replaced_new::limit = max_request;
  ChunkThreads chunk_threads(threads);
  try {
    BagFile file("a.bag", std::move(memory), all_topics, result.losses, chunk_threads);
    for (BagMessage next; file.next(next);)
      result.messages.push_back({*next.topic, next.time,
                                 std::string(reinterpret_cast<const char*>(next.data), next.size),
                                 *next.type, *next.publisher});
  } catch (const std::runtime_error& refusal) {
    result.losses.push_back(refusal.what());
  }
  replaced_new::limit = replaced_new::kNoLimit;
  return result;
}

// Whether these are some of the messages, in their order.
bool areSomeOf(const std::vector<RecordedMessage>& some, const std::vector<RecordedMessage>& all) {
  auto next = all.begin();
  for (const RecordedMessage& message : some) {
    next = std::find(next, all.end(), message);
    if (next == all.end()) return false;
    ++next;
  }
  return true;
}

bool isAmong(const std::vector<RecordedMessage>& messages, std::int64_t time,
             const std::string& data) {
  return std::any_of(messages.begin(), messages.end(), [&](const RecordedMessage& message) {
    return message.time == time && message.data == data;
  });
}

// One to four damages of a kind that may hit anything.
class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string to(std::string bytes) {
    for (std::size_t i = below(4); i < 4 && !bytes.empty(); ++i)
      damage(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }

  void damage(std::string& bytes) {
    const std::size_t place = below(bytes.size());
    const std::size_t size = std::min(below(100), bytes.size() - place);
    switch (below(6)) {
      case 0:
        bytes[place] = static_cast<char>(random_());
        break;
      case 1:
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(place, size);
        break;
      case 3:
        bytes.insert(place, bytes.substr(below(bytes.size()), size));
        break;
      case 4:
        bytes.replace(place, size, size, below(2) ? '\0' : '\xff');
        break;
      case 5:
        changeLength(bytes, place);
        break;
    }
  }

  // The next four bytes that look like a length.
  void changeLength(std::string& bytes, std::size_t place) {
    constexpr std::uint32_t kLengths[] = {0, 1, 4, 255, 4096, 1U << 24, 1U << 31, ~0U};
    for (; place + 4 <= bytes.size(); ++place) {
      if (bytes[place + 1] || bytes[place + 2] || bytes[place + 3]) continue;
      bytes.replace(place, 4, bytesOf(kLengths[below(8)]));
      return;
    }
  }

  std::mt19937 random_;
};

// Counts the bytes that are asked for.
class CountedBytes : public MemoryBytes {
 public:
  explicit CountedBytes(std::uint64_t& count) : count_(count) {}
  const std::uint8_t* at(std::uint64_t offset, std::size_t size) override {
    count_ += size;
    return MemoryBytes::at(offset, size);
  }

 private:
  std::uint64_t& count_;
};

TEST(BagDamage, ChunksInsideOfChunksAreNotReadForEver) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.blockSizeID = LZ4F_max4MB;
  LZ4F_cctx* context = nullptr;
  LZ4F_createCompressionContext(&context, LZ4F_VERSION);
  std::string frame(100, '\0');
  frame.resize(LZ4F_compressBegin(context, &frame[0], frame.size(), &preferences));
  LZ4F_freeCompressionContext(context);
  constexpr std::uint32_t kStored = 1U << 31 | 1U << 22;  // a block of 4 MB, not compressed
  const std::string chunk = chunkHeader("lz4", 0) + bytesOf(0U) + frame + bytesOf(kStored);
  std::string bytes = kBagVersionLine + bagHeader(0, 0, 0) + withSize("");
  while (bytes.size() < 2 << 20)
    bytes += chunk;
  // A record in the end shows that each chunk is damaged, not cut.
  bytes += chunkRecord("none", "");
  std::uint64_t count = 0;
  auto counted = std::make_unique<CountedBytes>(count);
  counted->data.assign(bytes.begin(), bytes.end());
  const std::set<std::string> all_topics;
  std::vector<std::string> losses;
  ChunkThreads threads(1);
  BagFile file("a.bag", std::move(counted), all_topics, losses, threads);
  BagMessage message;
  EXPECT_FALSE(file.next(message));
  EXPECT_LT(count, 1U << 30);
}

TEST(BagDamage, ABagMayBeCutAtEachByte) {
  const BagBytes bag = bagOf(kMessages);
  for (std::size_t size = 0; size < bag.bytes.size(); ++size) {
    const Reading reading = read(bag.bytes.substr(0, size), kMaxRequest);
    const auto whole =
        static_cast<std::size_t>(std::count_if(bag.message_ends.begin(), bag.message_ends.end(),
                                               [size](std::uint64_t end) { return end <= size; }));
    ASSERT_TRUE(std::equal(reading.messages.begin(), reading.messages.end(), kMessages.begin(),
                           kMessages.begin() + static_cast<std::ptrdiff_t>(whole)))
        << size;
    ASSERT_TRUE(whole == kMessages.size() || reading.losses.size() == 1) << size;
    ASSERT_TRUE(size < bag.index || reading.losses.empty()) << size;
  }
}

TEST(BagDamage, ACompressedBagMayBeCutAtEachByte) {
  for (const std::string compression : {"bz2", "lz4"}) {
    const BagBytes bag = bagOf(kMessages, compression);
    for (std::size_t size = 0; size < bag.bytes.size(); size += kIsSanitized ? 10 : 1) {
      const Reading reading = read(bag.bytes.substr(0, size), kMaxRequestCompressed);
      ASSERT_TRUE(areSomeOf(reading.messages, kMessages)) << compression << size;
      ASSERT_EQ(reading.losses.size(), size < bag.index ? 1U : 0U) << compression << size;
    }
  }
}

// The bytes of a message have no checksum, and a wrong length at which another record begins by
// chance is not noticed; here is none. The message before a damaged record is lost with it,
// because its length may be wrong.
TEST(BagDamage, ADamagedByteCostsTwoMessagesAtMost) {
  const BagBytes bag = bagOf(kMessages);
  // The header of the first chunk says that the records are not compressed.
  const std::size_t begin = bag.chunks[0] + chunkHeader("none", 0).size();
  for (std::size_t place = begin; place < bag.bytes.size(); ++place) {
    for (const int bits : {1, 0x80, 0xff}) {
      std::string bytes = bag.bytes;
      bytes[place] = static_cast<char>(bytes[place] ^ bits);
      const Reading reading = read(bytes, kMaxRequest);
      ASSERT_GE(reading.messages.size(), kMessages.size() - 2) << place - begin << ' ' << bits;
      ASSERT_LE(reading.messages.size(), kMessages.size()) << place << ' ' << bits;
      ASSERT_TRUE(reading.messages.size() == kMessages.size() || !reading.losses.empty()) << place;
      const auto is_wrong = [](const RecordedMessage& message) {
        return !isAmong(kMessages, message.time, message.data);
      };
      ASSERT_LE(std::count_if(reading.messages.begin(), reading.messages.end(), is_wrong), 1);
    }
  }
}

TEST(BagDamage, OfADamagedBagNoMoreIsReadThanWasThere) {
  const BagBytes bag = bagOf(kMessages);
  for (int seed = 0; seed < repetitions(30000); ++seed) {
    const Reading reading = read(Damage(static_cast<unsigned>(seed)).to(bag.bytes), kMaxRequest);
    ASSERT_LE(reading.messages.size(), 3 * kMessages.size()) << seed;
    ASSERT_LE(reading.losses.size(), 21U) << seed;
  }
}

// Each chunk has a checksum. Damage may repeat a chunk, and change the topics in the index.
TEST(BagDamage, OfADamagedCompressedBagOnlyTrueMessagesAreRead) {
  for (const std::string compression : {"bz2", "lz4"}) {
    const BagBytes bag = bagOf(kMessages, compression);
    for (int seed = 0; seed < repetitions(5000); ++seed) {
      const Reading reading =
          read(Damage(static_cast<unsigned>(seed)).to(bag.bytes), kMaxRequestCompressed);
      ASSERT_LE(reading.losses.size(), 21U) << compression << seed;
      for (const RecordedMessage& message : reading.messages)
        ASSERT_TRUE(isAmong(kMessages, message.time, message.data)) << compression << seed;
    }
  }
}

TEST(BagDamage, AnyNumberOfThreadsReadsTheSame) {
  for (const std::string compression : {"bz2", "lz4"}) {
    const BagBytes bag = bagOf(kMessages, compression);
    EXPECT_EQ(read(bag.bytes, replaced_new::kNoLimit, 2).messages, kMessages) << compression;
    for (int seed = 0; seed < repetitions(300); ++seed) {
      const std::string bytes = Damage(static_cast<unsigned>(seed)).to(bag.bytes);
      const Reading alone = read(bytes, replaced_new::kNoLimit);
      const Reading threaded =
          read(bytes, replaced_new::kNoLimit, 2 + static_cast<unsigned>(seed) % 3);
      ASSERT_EQ(threaded.messages, alone.messages) << compression << seed;
      ASSERT_EQ(threaded.losses, alone.losses) << compression << seed;
    }
  }
}

}  // namespace
}  // namespace link_bounds
