// SPDX-License-Identifier: MIT
#include "planish/constraints/stated_limit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planish/constraints/limit_kinds.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

/// What a limit's numbers are: MAX, MIN:MAX or WxH.
enum class Form { kMost, kRange, kSides };

Form form_of(std::string_view name) {
  if (name == SheetLimit::kName) return Form::kSides;
  const bool range = name == AngleLimit::kName || name == EdgeLimit::kName;
  return range ? Form::kRange : Form::kMost;
}

bool is_known(std::string_view name) {
  bool found = false;
  LimitKinds::for_each([&](auto tag) { found = found || decltype(tag)::type::kName == name; });
  return found;
}

/// "1:2" or "1x2".
bool parse_two(std::string_view text, char mark, StatedLimit& limit) {
  const std::size_t place = text.find(mark);
  if (place == std::string_view::npos) return false;
  const auto first = parse_number(text.substr(0, place));
  const auto second = parse_number(text.substr(place + 1));
  if (!first || !second) return false;
  limit.least = *first;
  limit.most = *second;
  return true;
}

Refusal find_problem(const StatedLimit& limit) {
  const std::string name = "bounds: " + limit.name;
  if (!is_known(limit.name)) return "bounds: a limit must be one of " + known_limits();
  if (!std::isfinite(limit.least) || !std::isfinite(limit.most)) return name + " must be finite";
  if (!(limit.most > 0.0) || limit.least < 0.0) return name + " must be greater than 0";
  if (limit.least > limit.most || (limit.least == limit.most && limit.name != SheetLimit::kName)) {
    return name + ": the first number must be less than the second";
  }
  const bool degrees = limit.name == FoldLimit::kName || limit.name == AngleLimit::kName;
  if (degrees && limit.most > 180.0) return name + " must be at most 180 degrees";
  if (limit.relative && limit.name != FoldLimit::kName) return name + " cannot be relative";
  return std::nullopt;
}

}  // namespace

std::string known_limits() {
  std::string known;
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (!known.empty()) known += ", ";
    known += Kind::kName;
    known += '=';
    known += Kind::kForm;
  });
  return known;
}

std::optional<std::string> limit_form(std::string_view name) {
  std::optional<std::string> form;
  LimitKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == name) form = std::string(Kind::kForm);
  });
  return form;
}

Refusal find_problem(const std::vector<StatedLimit>& limits) {
  constexpr std::size_t kMost = 16;
  if (limits.size() > kMost) return "bounds: at most 16";
  for (const StatedLimit& limit : limits) {
    if (auto problem = find_problem(limit)) return problem;
  }
  return std::nullopt;
}

bool has_limit(const std::vector<StatedLimit>& limits, std::string_view name) {
  return std::any_of(limits.begin(), limits.end(),
                     [&](const StatedLimit& limit) { return limit.name == name; });
}

void add_unstated(std::vector<StatedLimit>& limits, const std::vector<StatedLimit>& usual) {
  for (const StatedLimit& one : usual) {
    if (!has_limit(limits, one.name)) limits.push_back(one);
  }
}

std::optional<StatedLimit> parse_stated_limit(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  StatedLimit limit;
  limit.name = text.substr(0, equals);
  if (!is_known(limit.name)) return std::nullopt;
  std::string_view value = text.substr(equals + 1);
  const Form form = form_of(limit.name);
  if (form == Form::kRange)
    return parse_two(value, ':', limit) ? std::optional(limit) : std::nullopt;
  if (form == Form::kSides) {
    if (!parse_two(value, 'x', limit)) return std::nullopt;
    if (limit.least > limit.most) std::swap(limit.least, limit.most);
    return limit;
  }
  limit.relative = !value.empty() && value.front() == '+';
  if (limit.relative) value.remove_prefix(1);
  const auto most = parse_number(value);
  if (!most) return std::nullopt;
  limit.most = *most;
  return limit;
}

std::string stated_limit_text(const StatedLimit& limit) {
  std::string text = limit.name + "=";
  const Form form = form_of(limit.name);
  if (form != Form::kMost) {
    append_exact(text, limit.least);
    text += form == Form::kSides ? 'x' : ':';
  } else if (limit.relative) {
    text += '+';
  }
  append_exact(text, limit.most);
  return text;
}

}  // namespace planish
