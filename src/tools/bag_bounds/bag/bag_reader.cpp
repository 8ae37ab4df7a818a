// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/bag/bag_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tools/bag_bounds/bag/bag_file.h"
#include "tools/bag_bounds/bag/records/bytes.h"

namespace link_bounds {

struct BagReader::Source {
  std::unique_ptr<BagFile> file;
  BagMessage message;  ///< the next one
  bool has_message;
};

BagReader::BagReader(const std::vector<std::string>& files, const std::set<std::string>& topics,
                     const std::function<bool()>& is_interrupted, unsigned threads)
    : topics_(topics), threads_(std::make_unique<ChunkThreads>(threads)) {
  const auto interrupts = [this, is_interrupted] {
    was_interrupted_ |= is_interrupted();
    return was_interrupted_;
  };
  for (const std::string& name : files) {
    sources_.push_back({std::make_unique<BagFile>(name, std::make_unique<FileBytes>(name), topics_,
                                                  losses_, *threads_, interrupts),
                        {},
                        false});
  }
}

BagReader::~BagReader() = default;

bool BagReader::next(BagMessage& message) {
  if (!has_begun_) {
    for (Source& source : sources_)
      source.has_message = source.file->next(source.message);
    has_begun_ = true;
  } else if (last_) {
    last_->has_message = last_->file->next(last_->message);
  }
  last_ = nullptr;
  if (was_interrupted_) return false;
  for (Source& source : sources_)
    if (source.has_message && (!last_ || source.message.time < last_->message.time))
      last_ = &source;
  if (last_) message = last_->message;
  return last_;
}

/// Drops the losses that it finds: they concern messages that the caller does not want.
bool BagReader::goesBackTo(std::int64_t time) {
  const std::vector<std::string> losses = losses_;
  const bool goes_back = std::any_of(
      sources_.begin(), sources_.end(),
      [time](const Source& source) { return source.has_message && source.file->goesBackTo(time); });
  losses_ = losses;
  return goes_back;
}

std::int64_t BagReader::endTime() const {
  std::int64_t end = std::numeric_limits<std::int64_t>::min();
  for (const Source& source : sources_)
    end = std::max(end, source.file->lastTime());
  return end;
}

double BagReader::progress() const {
  double read = 0.0;
  double size = 0.0;
  for (const Source& source : sources_) {
    read += static_cast<double>(source.file->position());
    size += static_cast<double>(source.file->size());
  }
  return size > 0.0 ? read / size : 1.0;
}

}  // namespace link_bounds
