// SPDX-License-Identifier: MIT
#include "splitting/split_lines.hpp"

#include <algorithm>
#include <cstddef>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Up to so many corners every line of a panel is tried.
constexpr int kFewCorners = 5;

bool has_corners(std::span<const int> corners, int a, int b) {
  return std::find(corners.begin(), corners.end(), a) != corners.end() &&
         std::find(corners.begin(), corners.end(), b) != corners.end();
}

bool is_tried(int count, int apart, bool from_given) {
  if (count <= kFewCorners || from_given) return true;
  return apart == 2 || apart == count - 2 || apart == count / 2;
}

}  // namespace

std::vector<SplitLine> split_lines(const Mesh& mesh, std::span<const int> panels,
                                   std::span<const int> from) {
  std::vector<SplitLine> lines;
  const auto is_given = [&](int v) { return std::binary_search(from.begin(), from.end(), v); };
  for (const int f : panels) {
    const auto corners = mesh.face(f);
    const int count = static_cast<int>(corners.size());
    for (int a = 0; a < count; ++a) {
      for (int b = a + 2; b < count; ++b) {
        if (a == 0 && b == count - 1) continue;
        const int start = corners[at(a)], end = corners[at(b)];
        if (is_tried(count, b - a, is_given(start) || is_given(end))) {
          lines.push_back({f, start, end});
        }
      }
    }
  }
  return lines;
}

SplitCut split_along(const Mesh& mesh, const SplitLine& line, int panels) {
  SplitCut cut{-1, {line.from}, {line.to}};
  if (has_corners(mesh.face(line.panel), line.from, line.to)) {
    cut.panel = line.panel;
    return cut;
  }
  for (int f = panels; f < mesh.face_count(); ++f) {
    if (has_corners(mesh.face(f), line.from, line.to)) cut.panel = f;
  }
  return cut;
}

}  // namespace planish
