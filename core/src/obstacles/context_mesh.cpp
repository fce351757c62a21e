// SPDX-License-Identifier: MIT
#include "planish/obstacles/context_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planish/text/number.hpp"

namespace planish {
namespace {

/// What stands between marks: calls `take` with each part, until it returns false.
template <class Take>
bool for_each_part(std::string_view text, char mark, const Take& take) {
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(mark, begin);
    if (!take(text.substr(begin, end - begin))) return false;
    if (end == std::string_view::npos) return true;
    begin = end + 1;
  }
}

bool parse_point(std::string_view text, std::array<double, 3>& point) {
  std::size_t count = 0;
  const bool read = for_each_part(text, ',', [&](std::string_view word) {
    const auto number = parse_number(word);
    if (!number || count == point.size()) return false;
    point[count++] = *number;
    return true;
  });
  return read && count == point.size();
}

bool parse_panel(std::string_view text, std::vector<int>& panel) {
  return for_each_part(text, ',', [&](std::string_view word) {
    const auto vertex = parse_integer(word);
    if (!vertex || *vertex < 0 || *vertex > std::numeric_limits<int>::max()) return false;
    panel.push_back(static_cast<int>(*vertex));
    return true;
  });
}

}  // namespace

std::optional<ContextMesh> parse_context_mesh(std::string_view text) {
  ContextMesh mesh;
  const std::size_t stroke = text.find('/');
  if (stroke == std::string_view::npos) return std::nullopt;
  const bool points = for_each_part(text.substr(0, stroke), ';', [&](std::string_view part) {
    return parse_point(part, mesh.points.emplace_back());
  });
  const bool panels = points && for_each_part(text.substr(stroke + 1), ';', [&](auto part) {
                        return parse_panel(part, mesh.panels.emplace_back());
                      });
  return panels ? std::optional(std::move(mesh)) : std::nullopt;
}

void append_context_mesh(const ContextMesh& mesh, std::string& text) {
  char mark = '\0';
  for (const auto& point : mesh.points) {
    for (const double x : point) {
      if (mark != '\0') text += mark;
      append_exact(text, x);
      mark = ',';
    }
    mark = ';';
  }
  mark = '/';
  for (const std::vector<int>& panel : mesh.panels) {
    for (const int v : panel) {
      (text += mark) += std::to_string(v);
      mark = ',';
    }
    mark = ';';
  }
}

Refusal find_problem(const ContextMesh& mesh) {
  if (mesh.panels.empty()) return ": it has no panels";
  if (mesh.panels.size() > kMostContextPanels) {
    return ": at most " + std::to_string(kMostContextPanels) + " panels, here are " +
           std::to_string(mesh.panels.size());
  }
  const auto is_finite = [](const auto& point) {
    return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
  };
  if (!std::all_of(mesh.points.begin(), mesh.points.end(), is_finite)) {
    return " must be finite";
  }
  const int count = static_cast<int>(mesh.points.size());
  for (const std::vector<int>& panel : mesh.panels) {
    const bool known =
        std::all_of(panel.begin(), panel.end(), [&](int v) { return v >= 0 && v < count; });
    if (!known || panel.size() < 3) {
      return ": a panel has three or more of its " + std::to_string(count) + " points (from 0)";
    }
  }
  return std::nullopt;
}

}  // namespace planish
