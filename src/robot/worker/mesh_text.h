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

  /// At most `max_size` bytes of it, the rest of which is the next line. Nothing at the end. It is
  /// valid until the next call.
  std::optional<std::string_view> next(std::size_t max_size = SIZE_MAX);

  /// Where the line is that next() has returned: "line 1" is the first of the file.
  std::string place() const { return "line " + std::to_string(number_); }

  std::size_t fileSize() const { return file_->FileSize(); }

  /// The first bytes of the file, at most as many; the next line is the first one.
  std::string beginning(std::size_t size);

  /// What follows the last line.
  std::string rest();

  /// Whether the last line ended with \r, alone or before \n. Not to be asked after rest().
  bool isAfterCr() const { return is_after_cr_; }

  /// The file as it is; there is no next line.
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

  /// Empty if there is none.
  std::string_view next();

  /// They are counted; the first that is no number is refused. Words of a comment, which begins
  /// with `comment`, do not count.
  std::size_t countNumbers(const std::string& place, char comment = '\0');

 private:
  std::string_view rest_;
};

/// Whether assimp reads the word to its end; also for "nan" and "inf", which it knows, and for a
/// decimal comma.
bool isNumber(std::string_view word);

/// Assimp reads larger ones as smaller ones.
bool isIndex(std::string_view word);

/// 0 for what is none.
std::size_t countOf(std::string_view word);

/// Throw MeshError if it is none.
void requireNumber(std::string_view word, const std::string& place);
void requireIndex(std::string_view word, const std::string& place);

/// For a message: the beginning of a long one.
std::string inQuotes(std::string_view word);

std::string inSmallLetters(std::string text);

[[noreturn]] void refuseCutOff(const std::string& fault);

}  // namespace link_bounds
