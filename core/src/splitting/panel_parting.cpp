// SPDX-License-Identifier: MIT
#include "splitting/panel_parting.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/cuts/cut_mesh.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A line of a panel or a part of it, by the corners' places in the panel; `part` counts the lines
/// before it of this panel, 0 being the panel itself.
struct PartingLine {
  int part = 0;
  int from = 0, to = 0;
  double length = 0.0;
};

/// The panel as a mesh of its own.
Mesh mesh_of(const Mesh& mesh, int f) {
  const auto corners = mesh.face(f);
  Mesh alone;
  alone.positions.resize(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    alone.positions.col(static_cast<Eigen::Index>(k)) = mesh.positions.col(corners[k]);
    alone.face_vertices.push_back(static_cast<int>(k));
  }
  alone.face_offsets.push_back(static_cast<int>(corners.size()));
  return alone;
}

bool are_neighbours(const Adjacency& adjacency, int a, int b) {
  const auto around = adjacency.neighbours[a];
  return std::find(around.begin(), around.end(), b) != around.end();
}

/// Lines that halve a panel before others, and of those alike the shorter first.
std::vector<PartingLine> lines_by_worth(const Mesh& part, int f) {
  const auto corners = part.face(f);
  const int count = static_cast<int>(corners.size());
  std::vector<std::pair<int, PartingLine>> rated;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 2; b < count; ++b) {
      if (a == 0 && b == count - 1) continue;
      const int from = corners[at(a)], to = corners[at(b)];
      const double length = (part.positions.col(from) - part.positions.col(to)).norm();
      rated.push_back({std::abs(count - 2 * (b - a)), {f, from, to, length}});
    }
  }
  std::stable_sort(rated.begin(), rated.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first / 2 < b.first / 2 : a.second.length < b.second.length;
  });
  std::vector<PartingLine> lines;
  lines.reserve(rated.size());
  for (const auto& [rank, line] : rated) lines.push_back(line);
  return lines;
}

/// The mesh of one panel with the best line that it allows made; nullopt where none does.
std::optional<std::pair<PartingLine, Mesh>> part_once(const Mesh& alone, int part,
                                                      std::span<const int> corners,
                                                      const Adjacency& adjacency) {
  for (const PartingLine& line : lines_by_worth(alone, part)) {
    if (are_neighbours(adjacency, corners[at(line.from)], corners[at(line.to)])) continue;
    auto made = cut_mesh(alone, {SplitCut{part, {line.from}, {line.to}}});
    if (auto* cut = std::get_if<CutMesh>(&made)) return std::pair{line, std::move(cut->mesh)};
  }
  return std::nullopt;
}

std::vector<PartingLine> parting_lines(const Mesh& mesh, const Adjacency& adjacency, int f,
                                       Parting parting) {
  std::vector<PartingLine> lines;
  Mesh alone = mesh_of(mesh, f);
  for (int part = 0; part < alone.face_count(); ++part) {
    while (alone.face(part).size() > 3) {
      auto parted = part_once(alone, part, mesh.face(f), adjacency);
      if (!parted) break;
      lines.push_back(parted->first);
      alone = std::move(parted->second);
      if (parting == Parting::kInTwo) return lines;
    }
  }
  return lines;
}

bool has_side_with(const Mesh& mesh, const Adjacency& adjacency, int f,
                   const std::vector<char>& marked) {
  const auto corners = mesh.face(f);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto others = adjacency.faces[corners[(k + 1) % corners.size()]];
    for (const int g : adjacency.faces[corners[k]]) {
      if (g != f && marked[at(g)] != 0 &&
          std::find(others.begin(), others.end(), g) != others.end()) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<Cut> parting_cuts(const Mesh& mesh, const Adjacency& adjacency,
                              std::span<const int> panels, Parting parting) {
  std::vector<Cut> cuts;
  for (const int f : panels) {
    const auto corners = mesh.face(f);
    const int before = mesh.face_count() + static_cast<int>(cuts.size());
    for (const PartingLine& line : parting_lines(mesh, adjacency, f, parting)) {
      cuts.emplace_back(SplitCut{line.part == 0 ? f : before + line.part - 1,
                                 {corners[at(line.from)]},
                                 {corners[at(line.to)]}});
    }
  }
  return cuts;
}

std::vector<int> parting_order(const Mesh& mesh, const Adjacency& adjacency,
                               std::span<const int> first) {
  std::vector<int> order;
  std::vector<char> marked(at(mesh.face_count()), 0);
  for (const int f : first) {
    if (mesh.face(f).size() <= 3) continue;
    marked[at(f)] = 1;
    order.push_back(f);
  }
  std::vector<std::pair<double, int>> bent;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (marked[at(f)] != 0 || mesh.face(f).size() <= 3) continue;
    bent.emplace_back(face_planarity(mesh.positions, mesh.face(f)).mm_per_m, f);
  }
  std::stable_sort(bent.begin(), bent.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<int> others;
  for (const auto& [height, f] : bent) {
    if (has_side_with(mesh, adjacency, f, marked)) {
      others.push_back(f);
      continue;
    }
    marked[at(f)] = 1;
    order.push_back(f);
  }
  order.insert(order.end(), others.begin(), others.end());
  return order;
}

}  // namespace planish
