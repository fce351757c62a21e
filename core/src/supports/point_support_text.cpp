// SPDX-License-Identifier: MIT
/// Supports as text, and the rules that hold on whatever mesh: who reads designs needs no more.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planish/supports/point_support.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

constexpr std::string_view kAxes = "xyz";

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = text.find(',', begin);
    words.push_back(text.substr(begin, comma - begin));
    if (comma == std::string_view::npos) return words;
    begin = comma + 1;
  }
}

bool parse_points(std::string_view text, PointSupport& support) {
  if (text == "boundary" || text == "all") {
    support.points = text == "all" ? PointSupport::Points::kAll : PointSupport::Points::kBoundary;
    return true;
  }
  for (const std::string_view word : split_at_commas(text)) {
    const auto vertex = parse_integer(word);
    if (!vertex || *vertex < 0 || *vertex > std::numeric_limits<int>::max()) return false;
    support.vertices.push_back(static_cast<int>(*vertex));
  }
  return true;
}

bool parse_numbers(std::string_view text, std::size_t count, PointSupport& support) {
  for (const std::string_view word : split_at_commas(text)) {
    const auto number = parse_number(word);
    if (!number) return false;
    support.numbers.push_back(*number);
  }
  return support.numbers.size() == count;
}

/// "level", "level=x", "plane=…" or "line=…".
bool parse_form(std::string_view text, PointSupport& support) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const bool bare = equals == std::string_view::npos;
  const std::string_view value = bare ? std::string_view() : text.substr(equals + 1);
  if (name == "level") {
    if (bare) return true;
    const std::size_t axis = value.size() == 1 ? kAxes.find(value.front()) : kAxes.npos;
    if (axis == kAxes.npos) return false;
    support.axis = static_cast<int>(axis);
    return true;
  }
  if (text == "outline" || text == "polyline") {
    support.kind = text == "outline" ? PointSupport::Kind::kOutline : PointSupport::Kind::kPolyline;
    return true;
  }
  if (name == "surface") {
    support.kind = PointSupport::Kind::kSurface;
    if (bare) return true;
    auto surface = parse_context_mesh(value);
    if (surface) support.surface = std::move(*surface);
    return surface.has_value();
  }
  if (name == "spring") {
    support.kind = PointSupport::Kind::kSpring;
    return parse_numbers(value, 1, support);
  }
  support.kind = name == "plane" ? PointSupport::Kind::kPlane : PointSupport::Kind::kLine;
  if (name == "plane") return parse_numbers(value, 4, support);
  return name == "line" && parse_numbers(value, 6, support);
}

std::string form_text(const PointSupport& support) {
  if (support.kind == PointSupport::Kind::kLevel) {
    return std::string("level=") + kAxes[static_cast<std::size_t>(support.axis)];
  }
  if (support.kind == PointSupport::Kind::kOutline) return "outline";
  if (support.kind == PointSupport::Kind::kPolyline) return "polyline";
  if (support.kind == PointSupport::Kind::kSurface) {
    std::string form = "surface";
    if (!support.surface.points.empty()) append_context_mesh(support.surface, form += '=');
    return form;
  }
  std::string text = is_spring(support)                           ? "spring="
                     : support.kind == PointSupport::Kind::kPlane ? "plane="
                                                                  : "line=";
  for (std::size_t k = 0; k < support.numbers.size(); ++k) {
    if (k > 0) text += ',';
    append_exact(text, support.numbers[k]);
  }
  return text;
}

/// The length of a plane's normal or a line's direction.
double direction_length(const PointSupport& support) {
  const std::size_t first = support.kind == PointSupport::Kind::kPlane ? 0 : 3;
  return Eigen::Map<const Eigen::Vector3d>(support.numbers.data() + first).norm();
}

Refusal find_problem(const PointSupport& support) {
  if (!support.surface.points.empty()) {
    auto problem = find_problem(support.surface);
    return problem ? "supports: surface" + *problem : std::optional<std::string>();
  }
  const std::string name = "supports: " + form_text(support);
  const auto& numbers = support.numbers;
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) {
    return name + " must be finite";
  }
  if (support.numbers.empty()) return std::nullopt;
  if (is_spring(support)) {
    const bool in_range = numbers[0] >= kSoftestSpring && numbers[0] <= kStiffestSpring;
    return in_range ? std::nullopt
                    : std::optional(name + ": its stiffness must be from 0.01 to 1000");
  }
  const double length = direction_length(support);
  if (!(length > 0.0) || !std::isfinite(length)) return name + ": its direction has no length";
  return std::nullopt;
}

}  // namespace

std::string_view known_supports() {
  return "level:POINTS, level=AXIS:POINTS, plane=a,b,c,d:POINTS, line=x,y,z,dx,dy,dz:POINTS, "
         "outline:POINTS, polyline:V,V,..., surface:POINTS, surface=FILE:POINTS, "
         "spring=STIFFNESS:POINTS; "
         "POINTS is V,V,... or boundary or all";
}

std::optional<PointSupport> parse_point_support(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  PointSupport support;
  if (!parse_form(text.substr(0, colon), support)) return std::nullopt;
  if (!parse_points(text.substr(colon + 1), support)) return std::nullopt;
  const bool is_listed = support.points == PointSupport::Points::kListed;
  if (support.kind == PointSupport::Kind::kPolyline && !is_listed) return std::nullopt;
  return support;
}

std::string point_support_text(const PointSupport& support) {
  std::string text = form_text(support) + ":";
  if (support.points == PointSupport::Points::kAll) return text + "all";
  if (support.points == PointSupport::Points::kBoundary) return text + "boundary";
  for (std::size_t k = 0; k < support.vertices.size(); ++k) {
    if (k > 0) text += ',';
    text += std::to_string(support.vertices[k]);
  }
  return text;
}

Refusal find_problem(const std::vector<PointSupport>& supports) {
  constexpr std::size_t kMost = 1000;
  if (supports.size() > kMost) return "supports: at most 1000";
  for (const PointSupport& support : supports) {
    if (auto problem = find_problem(support)) return problem;
  }
  return std::nullopt;
}

}  // namespace planish
