// SPDX-License-Identifier: MIT
/// Walks over the lines of a text file without copying it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "planish/text/refusal.hpp"

namespace planish {

/// The lines of `bytes`, ended by LF, CR LF or CR; a byte order mark at the start is skipped.
/// `bytes` must outlive the object.
class TextLines {
 public:
  /// Whether a line begins a statement of its own, whatever stands before it.
  using BeginsAnew = bool (*)(std::string_view line);

  /// @param begins_anew given where a line that ends in a backslash goes on in the next one (OBJ),
  ///   unless that one begins anew: names and comments may end in a backslash, too
  explicit TextLines(std::string_view bytes, BeginsAnew begins_anew = nullptr);

  /// Steps to the next line; false at the end of the file.
  bool next();

  /// The line with its comment (from '#' at the start or after a blank) and outer blanks removed.
  [[nodiscard]] std::string_view text() const { return text_; }

  /// The line with what text() takes for a comment, without outer blanks.
  [[nodiscard]] std::string_view with_comment() const { return with_comment_; }

  /// The number of the line's first part, from 1.
  [[nodiscard]] int number() const { return number_; }

  /// What follows the current line, untouched.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  [[nodiscard]] std::string_view take_raw_line();
  [[nodiscard]] bool goes_on(std::string_view line) const;

  std::string_view rest_, text_, with_comment_;
  std::string joined_;  ///< holds a continued line
  BeginsAnew begins_anew_;
  int number_ = 0, next_number_ = 1;
};

/// Removes the first word from `rest` and returns it; empty at the end.
[[nodiscard]] std::string_view take_word(std::string_view& rest);

/// `text` without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Whether a blank stands for it: space, tab, vertical tab, form feed.
[[nodiscard]] bool is_blank(char c);

/// A sentence if `bytes` hold a control character that no text has, naming its line; also if they
/// are more than the 2 GiB that 32-bit counts can index.
[[nodiscard]] Refusal refuse_as_text(std::string_view bytes);

/// A sentence if `bytes` of a binary format are more than 2 GiB.
[[nodiscard]] Refusal refuse_size(std::string_view bytes);

}  // namespace planish
