// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a bag must give messages that lie in it and a few losses, or be refused.
#include "fuzzing.h"
#include "testing/bag_testing.h"
#include "tools/bag_bounds/bag/bag_file.h"

namespace link_bounds {
namespace {

std::vector<std::string> seeds() {
  std::vector<RecordedMessage> messages;
  for (unsigned i = 0; i < 6; ++i)
    messages.push_back(
        {i % 2 ? "/a" : "/b", 1000000000LL * i, std::string(9 * i, static_cast<char>(i))});
  std::vector<std::string> result;
  for (const std::string compression : {"none", "bz2", "lz4"})
    result.push_back(bagOf(messages, compression).bytes);
  return result;
}

void check(const BagMessage& message) {
  require(message.topic && message.type && message.publisher, "a message has a connection");
  require(message.time >= 0, "a time is not negative");
  unsigned sum = 0;
  for (std::uint32_t i = 0; i < message.size; ++i)
    sum += message.data[i];
  require(sum <= 255U * message.size, "all bytes of a message can be read");
}

void read(const std::uint8_t* data, std::size_t size) {
  auto bytes = std::make_unique<MemoryBytes>();
  bytes->data.assign(data, data + size);
  const std::set<std::string> all_topics;
  std::vector<std::string> losses;
  ChunkThreads threads(1);
  BagFile file("a.bag", std::move(bytes), all_topics, losses, threads);
  for (BagMessage message; file.next(message);)
    check(message);
  require(losses.size() <= 21, "the losses are a few lines");
  require(file.position() <= size, "the place is in the file");
}

}  // namespace
}  // namespace link_bounds

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    link_bounds::read(data, size);
  } catch (const std::runtime_error&) {
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned random) {
  using namespace link_bounds;
  static const std::vector<std::string> kSeeds = seeds();
  const std::size_t seed_size = seeded(kSeeds, random, data, size, max_size);
  return seed_size > 0 ? seed_size : LLVMFuzzerMutate(data, size, max_size);
}
