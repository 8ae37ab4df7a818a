// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The memory of the reader and of the writer does not depend on the length of a bag.
#include <gtest/gtest.h>

#include "testing/bag_testing.h"
#include "testing/replaced_new.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr int kFirst = 20000;  // messages, several chunks
constexpr int kLast = 100000;

TEST(BagMemory, ReadingOnTakesNoMemory) {
  const TemporaryFolder folder;
  const std::string data(100, 'x');
  writeBag(folder / "a.bag", std::vector<RecordedMessage>(kLast, {"/tf", 1, data}));
  BagReader reader({folder / "a.bag"}, {"/tf"});
  BagMessage message;
  int count = 0;
  while (count < kFirst && reader.next(message))
    ++count;
  long requests = 0;
  replaced_new::counter = &requests;
  while (reader.next(message))
    ++count;
  replaced_new::counter = nullptr;
  EXPECT_EQ(count, kLast);
  EXPECT_EQ(requests, 0);
}

TEST(BagMemory, ReadingOnOfCompressedChunksTakesNoMemory) {
  const TemporaryFolder folder;
  for (const std::string compression : {"bz2", "lz4"}) {
    const std::vector<RecordedMessage> messages(200, {"/tf", 1, std::string(1000, 'x')});
    BagReader reader({folder.write("a.bag", bagOf(messages, compression).bytes)}, {});
    BagMessage message;
    for (int i = 0; i < 50; ++i)
      ASSERT_TRUE(reader.next(message));
    long requests = 0;
    replaced_new::counter = &requests;
    while (reader.next(message)) {
    }
    replaced_new::counter = nullptr;
    EXPECT_EQ(requests, 0) << compression;
  }
}

}  // namespace
}  // namespace link_bounds
