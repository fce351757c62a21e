// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "planish/text/number.hpp"

namespace planish::cli {
namespace {

/// "--size=12" as name and value; the value is empty without '='.
std::pair<std::string_view, std::optional<std::string_view>> split_option(std::string_view word) {
  const std::size_t equals = word.find('=');
  if (word.substr(0, 2) != "--" || equals == std::string_view::npos) return {word, std::nullopt};
  return {word.substr(0, equals), word.substr(equals + 1)};
}

/// A value may begin with a minus, but no value is the name of an option.
bool is_option(std::string_view word, std::span<const OptionRow> table) {
  const std::string_view name = split_option(word).first;
  return std::any_of(table.begin(), table.end(),
                     [name](const OptionRow& row) { return row.name == name; });
}

CommandError usage_error(std::string_view what, std::string_view text, std::string_view problem) {
  return {kWrongUsage,
          std::string(what) + ": \"" + std::string(text) + "\" " + std::string(problem)};
}

}  // namespace

Arguments::Arguments(std::span<const std::string_view> words, std::span<const OptionRow> table) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string_view word = words[k];
    if (word.size() < 2 || word[0] != '-') {
      positional_.emplace_back(word);
      continue;
    }
    const auto [name, attached] = split_option(word);
    const auto row = std::find_if(table.begin(), table.end(),
                                  [wanted = name](const OptionRow& r) { return r.name == wanted; });
    if (row == table.end()) {
      throw CommandError(kWrongUsage, "unknown option " + std::string(name));
    }
    if (row->value.empty()) {
      if (attached) throw CommandError(kWrongUsage, std::string(name) + " takes no value");
      options_.emplace_back(name, "");
    } else if (attached) {
      options_.emplace_back(name, *attached);
    } else if (row->value.front() == '[') {
      const bool number = k + 1 < words.size() && parse_number(words[k + 1]);
      options_.emplace_back(name, number ? words[++k] : std::string_view());
    } else if (k + 1 < words.size() && !is_option(words[k + 1], table)) {
      options_.emplace_back(name, words[++k]);
    } else {
      throw CommandError(kWrongUsage,
                         std::string(name) + " needs a value: " + std::string(row->value));
    }
  }
}

bool Arguments::has(std::string_view option) const { return value(option).has_value(); }

std::optional<std::string> Arguments::value(std::string_view option) const {
  const auto found = std::find_if(options_.rbegin(), options_.rend(),
                                  [&](const auto& entry) { return entry.first == option; });
  if (found == options_.rend()) return std::nullopt;
  return found->second;
}

std::vector<std::string> Arguments::values(std::string_view option) const {
  std::vector<std::string> result;
  for (const auto& [name, value] : options_) {
    if (name == option) result.push_back(value);
  }
  return result;
}

std::string Arguments::only_positional(std::string_view what) const {
  if (positional_.empty()) throw CommandError(kWrongUsage, std::string(what) + " is missing");
  if (positional_.size() > 1) {
    throw CommandError(kWrongUsage, "unexpected argument \"" + positional_[1] + "\"");
  }
  return positional_[0];
}

double parse_finite(std::string_view text, std::string_view what) {
  const std::optional<double> value = parse_number(text);
  if (!value) throw usage_error(what, text, "is not a number");
  if (!std::isfinite(*value)) throw usage_error(what, text, "is not finite");
  return *value;
}

int parse_whole(std::string_view text, std::string_view what) {
  int value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    throw usage_error(what, text, "is not a whole number");
  }
  return value;
}

PartRange parse_part(const std::string& text, std::size_t count) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    throw CommandError(kWrongUsage, "--part: \"" + text + "\" is not K/N");
  }
  const int part = parse_whole(text.substr(0, slash), "--part");
  const int parts = parse_whole(text.substr(slash + 1), "--part");
  if (part < 1 || part > parts) {
    throw CommandError(kWrongUsage, "--part: K of K/N must be from 1 to N");
  }
  const auto k = static_cast<std::size_t>(part), n = static_cast<std::size_t>(parts);
  return {count * (k - 1) / n, count * k / n};
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos;
       comma = text.find(',')) {
    parts.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  parts.push_back(text);
  return parts;
}

}  // namespace planish::cli
