// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The tags of a XML text one by one, however deeply nested. Text that is not XML is left to assimp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace link_bounds {

class XmlTags {
 public:
  explicit XmlTags(std::string_view xml) : xml_(xml) {}

  /// Goes to the next tag, or the next text. False at the end.
  bool next();

  bool isText() const { return is_text_; }

  /// The element of the tag; for a text, the element that has begun just before it, else "".
  std::string_view name() const { return name_; }
  bool isEnd() const { return is_end_; }      ///< of an element; also of one without content
  bool isBegin() const { return is_begin_; }  ///< of an element

  /// The text. In it and in attributes, references to ASCII characters are replaced, such as &#51;
  /// by 3.
  std::string text() const;

  /// The value of an attribute; nothing if the tag has none.
  std::optional<std::string> attribute(std::string_view name) const;

  /// The line of the tag or text; "line 1" is the first.
  std::string place() const { return "line " + std::to_string(line_); }

 private:
  bool startsWith(std::string_view beginning) const;
  void skipBehind(std::string_view end);
  std::size_t endOfTag() const;

  std::string_view xml_;
  std::size_t at_ = 0, begin_ = 0;
  std::ptrdiff_t line_ = 1;
  bool is_text_ = false, is_begin_ = false, is_end_ = false;
  std::string_view name_, content_;
};

}  // namespace link_bounds
