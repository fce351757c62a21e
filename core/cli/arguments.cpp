// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <optional>
#include <utility>

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
    if (row == table.end()) throw UsageError("unknown option " + std::string(name));
    if (row->value.empty()) {
      if (attached) throw UsageError(std::string(name) + " takes no value");
      add(name, "");
    } else if (attached) {
      add(name, *attached);
    } else if (row->value.front() == '[') {
      const bool number = k + 1 < words.size() && parse_number(words[k + 1]);
      add(name, number ? words[++k] : std::string_view());
    } else if (k + 1 < words.size() && !is_option(words[k + 1], table)) {
      add(name, words[++k]);
    } else {
      throw UsageError(std::string(name) + " needs a value: " + std::string(row->value));
    }
  }
}

std::string Arguments::only_positional(std::string_view what) const {
  if (positional_.empty()) throw UsageError(std::string(what) + " is missing");
  if (positional_.size() > 1) throw UsageError("unexpected argument \"" + positional_[1] + "\"");
  return positional_[0];
}

}  // namespace planish::cli
