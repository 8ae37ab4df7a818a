// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A subscriber that reads when the test wants it to.
#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <ros/connection_manager.h>
#include <ros/header.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace link_bounds {

/// Connects to a topic of this process by TCP, as another process would.
class TcprosReader {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// `meanwhile` is called while it waits, and must let the node work.
  TcprosReader(const std::string& topic, const std::string& caller, std::function<void()> meanwhile)
      : meanwhile_(std::move(meanwhile)), socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    const int small = 4096;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof(small));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port =
        htons(static_cast<std::uint16_t>(ros::ConnectionManager::instance()->getTCPPort()));
    if (connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0)
      throw std::runtime_error("cannot connect");
    send(Fields{"callerid=" + caller, "topic=" + topic, "md5sum=*", "type=*", "tcp_nodelay=1"});
    std::optional<Bytes> answer = read();
    if (!answer) throw std::runtime_error("no header");
    std::string error;
    header_.parse(answer->data(), static_cast<std::uint32_t>(answer->size()), error);
  }
  ~TcprosReader() { close(socket_); }
  TcprosReader(const TcprosReader&) = delete;
  TcprosReader& operator=(const TcprosReader&) = delete;

  /// A field of what the publisher answered.
  std::string field(const std::string& name) {
    std::string value;
    header_.getValue(name, value);
    return value;
  }

  /// The next message without its length; nothing if none begins within so many ms.
  std::optional<Bytes> read(int patience = 20'000) {
    std::uint32_t size = 0;
    if (!readInto(&size, sizeof(size), patience)) return std::nullopt;
    Bytes bytes(size);
    if (!readInto(bytes.data(), size, 20'000)) throw std::runtime_error("half a message");
    return bytes;
  }

 private:
  using Fields = std::vector<std::string>;

  void send(const Fields& fields) const {
    std::string text;
    const auto add = [](std::uint32_t size, std::string& to) {
      to.append(reinterpret_cast<const char*>(&size), sizeof(size));
    };
    for (const std::string& field : fields) {
      add(static_cast<std::uint32_t>(field.size()), text);
      text += field;
    }
    std::string message;
    add(static_cast<std::uint32_t>(text.size()), message);
    message += text;
    if (::send(socket_, message.data(), message.size(), 0) != static_cast<ssize_t>(message.size()))
      throw std::runtime_error("cannot send");
  }

  /// False if nothing came for so long; throws if it stops in between.
  bool readInto(void* to, std::size_t size, int patience) {
    constexpr int kSlice = 2;  // ms
    auto* position = static_cast<std::uint8_t*>(to);
    for (int waited = 0; size > 0;) {
      pollfd entry{socket_, POLLIN, 0};
      if (poll(&entry, 1, kSlice) == 0) {
        meanwhile_();
        waited += kSlice;
        if (waited > patience) return false;
        continue;
      }
      const ssize_t count = recv(socket_, position, size, 0);
      if (count <= 0) throw std::runtime_error("the connection is gone");
      position += count;
      size -= static_cast<std::size_t>(count);
    }
    return true;
  }

  std::function<void()> meanwhile_;
  int socket_;
  ros::Header header_;
};

}  // namespace link_bounds
