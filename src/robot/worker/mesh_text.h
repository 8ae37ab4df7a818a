// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines, words and numbers of a mesh file, as assimp's readers split and read them.
#pragma once

#include <array>
#include <assimp/IOStream.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "robot/worker/confined_files.h"

namespace link_bounds {

/// The lines of a file, without blank ones.
class Lines {
 public:
  /// Throws MeshError if the file cannot be opened.
  Lines(ConfinedFiles& files, const std::string& path);
  ~Lines() { files_.Close(file_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  /// Lines that begin with `begin` are comments and are left out.
  void skipComments(char begin) { comment_ = begin; }
  void keepBlankLines() { keeps_blank_ = true; }

  /// The next line; of a longer one the first `max_size` bytes, and its rest is then the next line.
  /// Nothing at the end of the file. Valid until the next call.
  std::optional<std::string_view> next(std::size_t max_size = SIZE_MAX);

  /// Where the line is that next() has returned: "line 1" is the first of the file.
  std::string place() const { return "line " + std::to_string(number_); }

  std::size_t fileSize() const { return file_->FileSize(); }

  /// The first `size` bytes of the file, or all if it has fewer. next() then begins with the first
  /// line.
  std::string beginning(std::size_t size);

  /// All bytes after the line that next() has returned last.
  std::string rest();

  /// Whether the last line ended with \r, alone or before \n. Not known after rest().
  bool isAfterCr() const { return is_after_cr_; }

  /// The whole file; next() then has no line.
  std::string all();

 private:
  bool take(std::size_t max_size);
  bool hasContent() const;
  bool read();
  void skipEndOfCrLf();

  ConfinedFiles& files_;
  Assimp::IOStream* file_;
  std::array<char, 1 << 16> buffer_;
  std::size_t next_ = 0, end_ = 0;
  std::string line_;
  std::size_t number_ = 0;
  bool is_after_cr_ = false;
  bool keeps_blank_ = false;
  char comment_ = '\n';  // none
};

/// The words of a line or text.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word; empty at the end.
  std::string_view next();

  /// Counts the words, up to a comment that begins with `comment`. Throws MeshError for a word that
  /// is no number.
  std::size_t countNumbers(const std::string& place, char comment = '\0');

 private:
  std::string_view rest_;
};

/// Whether assimp reads the whole word as a number; also for "nan" and "inf", which it knows, and
/// for a decimal comma.
bool isNumber(std::string_view word);

/// Whether the word is an index below 2^31; assimp reads larger ones as smaller ones.
bool isIndex(std::string_view word);

/// The number with which the word begins; 0 if there is none.
std::size_t countOf(std::string_view word);

/// Throw MeshError if the word is no number or no index.
void requireNumber(std::string_view word, const std::string& place);
void requireIndex(std::string_view word, const std::string& place);

/// The word in quotes, for a message; a long one is cut.
std::string inQuotes(std::string_view word);

std::string inSmallLetters(std::string text);

[[noreturn]] void refuseCutOff(const std::string& fault);

}  // namespace link_bounds
