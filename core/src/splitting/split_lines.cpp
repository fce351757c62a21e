// SPDX-License-Identifier: MIT
#include "splitting/split_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// The most corners of a panel of which every line is tried.
constexpr int kFewCorners = 5;

bool has_corners(std::span<const int> corners, int a, int b) {
  return std::find(corners.begin(), corners.end(), a) != corners.end() &&
         std::find(corners.begin(), corners.end(), b) != corners.end();
}

bool is_tried(int count, int apart, bool from_given) {
  if (count <= kFewCorners || from_given) return true;
  return apart == 2 || apart == count - 2 || apart == count / 2;
}

/// The image of a line, its corners in ascending order, so that a line is the same both ways.
SplitLine image_of(const Mesh& mesh, const Adjacency& adjacency, const SplitLine& line,
                   const std::vector<int>& image) {
  const auto corners = mesh.face(line.panel);
  const auto [from, to] = std::minmax(image[at(line.from)], image[at(line.to)]);
  for (const int f : adjacency.faces[from]) {
    const auto there = mesh.face(f);
    const auto has = [&](int v) {
      return std::find(there.begin(), there.end(), image[at(v)]) != there.end();
    };
    if (there.size() == corners.size() && std::all_of(corners.begin(), corners.end(), has)) {
      return {f, from, to};
    }
  }
  return {line.panel, from, to};
}

}  // namespace

std::vector<LineImages> lines_with_images(const Mesh& mesh, const Adjacency& adjacency,
                                          std::span<const SplitLine> lines,
                                          const MeshSymmetry* symmetry) {
  std::vector<LineImages> all;
  std::set<std::tuple<int, int, int>> seen;
  for (const SplitLine& line : lines) {
    LineImages images;
    if (symmetry == nullptr) images.push_back(line);
    for (std::size_t k = 0; symmetry != nullptr && k < symmetry->operations.size(); ++k) {
      const SplitLine image = image_of(mesh, adjacency, line, symmetry->operations[k].image);
      if (seen.insert({image.panel, image.from, image.to}).second) images.push_back(image);
    }
    if (!images.empty()) all.push_back(std::move(images));
  }
  return all;
}

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
