// SPDX-License-Identifier: MIT
#include "io/text_lines.hpp"

#include <limits>

#include "text/sentence.hpp"

namespace planish {
namespace {

std::string_view without_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    // A name such as "part#2" keeps its '#'.
    if (at == 0 || is_blank(line[at - 1])) return line.substr(0, at);
  }
  return line;
}

/// What stands before the first line end.
std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find_first_of("\n\r"));
}

}  // namespace

TextLines::TextLines(std::string_view bytes, BeginsAnew begins_anew)
    : rest_(bytes), begins_anew_(begins_anew) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    rest_.remove_prefix(kByteOrderMark.size());
  }
}

std::string_view TextLines::take_raw_line() {
  const std::string_view line = first_line(rest_);
  std::size_t end = line.size();
  if (end < rest_.size() && rest_[end] == '\r') ++end;
  if (end < rest_.size() && rest_[end] == '\n' && (end == line.size() || rest_[end - 1] == '\r')) {
    ++end;
  }
  rest_.remove_prefix(end);
  ++next_number_;
  return line;
}

bool TextLines::goes_on(std::string_view line) const {
  const std::string_view end = trimmed(line);
  if (!begins_anew_ || end.empty() || end.back() != '\\') return false;
  return without_comment(line).size() == line.size() && !begins_anew_(first_line(rest_));
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  number_ = next_number_;
  std::string_view line = take_raw_line();
  if (goes_on(line)) {
    joined_.clear();
    do {
      joined_ += line.substr(0, line.rfind('\\'));
      joined_ += ' ';
      line = take_raw_line();
    } while (goes_on(line));
    joined_ += line;
    line = joined_;
  }
  with_comment_ = trimmed(line);
  text_ = trimmed(without_comment(line));
  return true;
}

std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

Refusal refuse_size(std::string_view bytes) {
  if (bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return std::nullopt;
  }
  return "the file is larger than 2 GiB";
}

Refusal refuse_as_text(std::string_view bytes) {
  if (Refusal refusal = refuse_size(bytes)) return refusal;
  int line = 1;
  for (const char c : bytes) {
    if (c == '\n') ++line;
    const bool text = static_cast<unsigned char>(c) >= ' ' || (c >= '\t' && c <= '\r');
    if (!text) return line_text(line, "the file is not text");
  }
  return std::nullopt;
}

}  // namespace planish
