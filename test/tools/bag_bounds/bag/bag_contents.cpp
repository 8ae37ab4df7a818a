// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the messages of bags and the losses: bag_contents FILE ...
// Copies a bag whose topics are /a and /b: bag_contents --copy FILE COPY
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "tools/bag_bounds/bag/bag_reader.h"
#include "tools/bag_bounds/bag/bag_writer.h"

namespace {

using namespace link_bounds;

void print(const BagMessage& message) {
  std::printf("%s %s %s %lld ", message.topic->c_str(), message.type->c_str(),
              message.publisher->c_str(), static_cast<long long>(message.time));
  for (std::uint32_t i = 0; i < message.size; ++i)
    std::printf("%02x", message.data[i]);
  std::printf("\n");
}

void print(const std::vector<std::string>& files) {
  BagReader reader(files, {});
  for (BagMessage message; reader.next(message);)
    print(message);
  for (const std::string& loss : reader.losses())
    std::printf("lost: %s\n", loss.c_str());
}

void copy(const std::string& from, const std::string& to) {
  BagReader reader({from}, {});
  BagWriter writer(to);
  std::map<std::string, std::uint32_t> numbers;
  for (const std::string topic : {"/a", "/b"})
    numbers[topic] = writer.addTopic({topic, "std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1",
                                      "string data\n", "/copy", topic == "/b"});
  for (BagMessage message; reader.next(message);)
    writer.write(numbers.at(*message.topic), message.time, message.data, message.size);
  writer.close();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 3 && arguments[0] == "--copy") {
      copy(arguments[1], arguments[2]);
    } else {
      print(arguments);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
