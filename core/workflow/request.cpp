// SPDX-License-Identifier: MIT
#include "request.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "planish/text/number.hpp"

namespace planish::workflow {
namespace {

UsageError usage_error(std::string_view what, std::string_view text, std::string_view problem) {
  return UsageError(std::string(what) + ": \"" + std::string(text) + "\" " + std::string(problem));
}

const OptionRow* find_row(std::span<const OptionRow> table, std::string_view name) {
  const auto row =
      std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.name == name; });
  return row == table.end() ? nullptr : &*row;
}

}  // namespace

Request::Request(std::string_view json, std::span<const OptionRow> table) {
  const Json given = Json::parse(json);
  for (const auto& [key, value] : given.items()) {
    if (value.is_null()) continue;
    const std::string name = std::string("--").append(key);
    if (const OptionRow* row = find_row(table, name)) {
      const bool is_switch = row->value.empty() || (row->value[0] == '[' && value.is_boolean());
      if (!is_switch) {
        add(name, value);
      } else if (!value.is_boolean()) {
        throw UsageError(name + " must be true or false");
      } else if (value.get<bool>()) {
        add(name, "");
      }
    } else if (const auto one = name.substr(0, name.size() - 1);
               name.ends_with('s') && find_row(table, one) != nullptr) {
      add_all(one, value);
    } else {
      throw UsageError("unknown option " + name);
    }
  }
}

/// Numbers, such as those of vertices, are one value; whatever else is in a list is one each.
void Request::add_all(std::string_view option, const Json& value) {
  const auto is_number = [](const Json& entry) { return entry.is_number(); };
  if (value.is_object()) {
    for (const auto& [name, part] : value.items()) add(option, Json::object({{name, part}}));
  } else if (value.is_array() && !std::all_of(value.begin(), value.end(), is_number)) {
    for (const Json& entry : value) add(option, entry);
  } else if (!value.empty()) {
    add(option, value);
  }
}

std::optional<std::string> Request::value(std::string_view option) const {
  const Json* found = last(option);
  return found == nullptr ? std::nullopt : std::optional(text_of(*found));
}

const Json* Request::last(std::string_view option) const {
  const auto found = std::find_if(options_.rbegin(), options_.rend(),
                                  [&](const auto& entry) { return entry.first == option; });
  return found == options_.rend() ? nullptr : &found->second;
}

std::vector<Json> Request::values(std::string_view option) const {
  std::vector<Json> result;
  for (const auto& [name, value] : options_) {
    if (name == option) result.push_back(value);
  }
  return result;
}

std::vector<std::string> Request::texts(std::string_view option) const {
  std::vector<std::string> result;
  for (const Json& value : values(option)) result.push_back(text_of(value));
  return result;
}

void Request::read(std::string_view option, double& number) const {
  if (const Json* value = last(option)) number = parse_finite(*value, option);
}

void Request::read(std::string_view option, int& number) const {
  if (const Json* value = last(option)) number = parse_whole(*value, option);
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& entry : value) {
    if (!text.empty()) text += ',';
    text += text_of(entry);
  }
  return text;
}

std::vector<Json> entries_of(const Json& value) {
  if (value.is_array()) return std::vector<Json>(value.begin(), value.end());
  if (!value.is_string()) return {value};
  std::vector<Json> entries;
  std::string_view text = value.get_ref<const std::string&>();
  for (std::size_t comma = text.find(','); comma != std::string_view::npos;
       comma = text.find(',')) {
    entries.emplace_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  entries.emplace_back(text);
  return entries;
}

double parse_finite(const Json& value, std::string_view what) {
  if (value.is_number()) return value.get<double>();
  const std::string text = text_of(value);
  const std::optional<double> number = parse_number(text);
  if (!number) throw usage_error(what, text, "is not a number");
  if (!std::isfinite(*number)) throw usage_error(what, text, "is not finite");
  return *number;
}

int parse_whole(const Json& value, std::string_view what) {
  const std::string text = text_of(value);
  int number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    throw usage_error(what, text, "is not a whole number");
  }
  return number;
}

PartRange parse_part(const std::string& text, std::size_t count) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw UsageError("--part: \"" + text + "\" is not K/N");
  const int part = parse_whole(text.substr(0, slash), "--part");
  const int parts = parse_whole(text.substr(slash + 1), "--part");
  if (part < 1 || part > parts) throw UsageError("--part: K of K/N must be from 1 to N");
  const auto k = static_cast<std::size_t>(part), n = static_cast<std::size_t>(parts);
  return {count * (k - 1) / n, count * k / n};
}

}  // namespace planish::workflow
