// SPDX-License-Identifier: MIT
/// Symmetries as text. Apart from what finds them, so that whoever reads designs needs no finder.
#include <algorithm>

#include "planish/symmetry/symmetry.hpp"

namespace planish {
namespace {

constexpr std::string_view kAxisNames = "xyz";

/// 0 to 2; nullopt for any other text.
std::optional<int> parse_axis(std::string_view text) {
  const std::size_t axis =
      text.size() == 1 ? kAxisNames.find(text.front()) : std::string_view::npos;
  if (axis == std::string_view::npos) return std::nullopt;
  return static_cast<int>(axis);
}

/// 2 to kMostFolds.
std::optional<int> parse_order(std::string_view digits) {
  constexpr std::size_t kMostDigits = 3;
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  int order = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    order = 10 * order + (c - '0');
  }
  if (order < 2 || order > kMostFolds) return std::nullopt;
  return order;
}

/// "x", "axis:4" or "axis:x:4".
std::optional<SymmetryElement> parse_element(std::string_view text) {
  constexpr std::string_view kAxis = "axis:";
  if (text.substr(0, kAxis.size()) != kAxis) {
    const auto axis = parse_axis(text);
    if (!axis) return std::nullopt;
    return SymmetryElement{*axis, 0};
  }
  text.remove_prefix(kAxis.size());
  const std::size_t colon = text.find(':');
  const bool named = colon != std::string_view::npos;
  const auto axis = named ? parse_axis(text.substr(0, colon)) : std::optional<int>(2);
  const auto order = parse_order(named ? text.substr(colon + 1) : text);
  if (!axis || !order) return std::nullopt;
  return SymmetryElement{*axis, *order};
}

}  // namespace

std::optional<StatedSymmetry> parse_symmetry(std::string_view text) {
  StatedSymmetry stated;
  if (text == "off") return stated;
  stated.automatic = text == "auto";
  if (stated.automatic) return stated;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(',');
    const auto element = parse_element(text.substr(0, end));
    if (!element) return std::nullopt;
    auto& known = stated.elements;
    if (std::find(known.begin(), known.end(), *element) == known.end()) known.push_back(*element);
    if (end != std::string_view::npos) text.remove_prefix(end + 1);
  }
  return stated;
}

std::string symmetry_text(const SymmetryElement& element) {
  const std::string axis(1, kAxisNames[static_cast<std::size_t>(element.axis)]);
  return element.order == 0 ? axis : "axis:" + axis + ":" + std::to_string(element.order);
}

std::string_view known_symmetries() {
  return "auto, off, or some of x, y, z, axis:N and axis:x|y|z:N (N from 2 to 360), joined by "
         "commas";
}

}  // namespace planish
