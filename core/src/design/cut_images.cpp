// SPDX-License-Identifier: MIT
#include "planish/design/cut_images.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Shares and planes nearer than this are one.
constexpr double kSameCut = 1e-9;

/// What one motion makes of the numbers and places of a cut.
class CutImage {
 public:
  CutImage(const Mesh& mesh, const MeshSymmetry& symmetry, std::size_t k)
      : mesh_(mesh), symmetry_(symmetry), k_(k) {}

  [[nodiscard]] SplitCut of(const SplitCut& cut) const {
    return {panel(cut.panel), place(cut.start), place(cut.end)};
  }
  [[nodiscard]] StripCut of(const StripCut& cut) const {
    return {vertex(cut.from), vertex(cut.to), cut.share};
  }
  [[nodiscard]] CornerCut of(const CornerCut& cut) const {
    return {panel(cut.panel), vertex(cut.vertex), cut.share};
  }
  [[nodiscard]] RefineCut of(RefineCut cut) const {
    for (int& f : cut.panels) f = panel(f);
    return cut;
  }
  /// A point p is beyond the plane where its image is beyond the image.
  [[nodiscard]] TrimCut of(const TrimCut& cut) const {
    const auto& [a, b, c, d] = cut.plane;
    const Eigen::Vector3d normal(a, b, c);
    const Eigen::Vector3d turned = symmetry_.operations[k_].turn * normal;
    const double distance = d + (turned - normal).dot(symmetry_.centre);
    return {{turned.x(), turned.y(), turned.z(), distance}};
  }

 private:
  [[nodiscard]] int vertex(int v) const { return symmetry_.operations[k_].image[at(v)]; }

  [[nodiscard]] OutlinePlace place(OutlinePlace spot) const {
    spot.vertex = vertex(spot.vertex);
    if (spot.to >= 0) spot.to = vertex(spot.to);
    return spot;
  }

  /// The panel at the images of panel f's corners.
  [[nodiscard]] int panel(int f) const {
    const auto corners = mesh_.face(f);
    for (int other = 0; other < mesh_.face_count(); ++other) {
      const auto there = mesh_.face(other);
      const auto has = [&](int v) {
        return std::find(there.begin(), there.end(), vertex(v)) != there.end();
      };
      if (there.size() == corners.size() && std::all_of(corners.begin(), corners.end(), has)) {
        return other;
      }
    }
    return f;
  }

  const Mesh& mesh_;
  const MeshSymmetry& symmetry_;
  std::size_t k_;
};

/// A side with its lower end first.
OutlinePlace upwards(const OutlinePlace& spot) {
  if (spot.to < 0 || spot.vertex < spot.to) return spot;
  return {spot.to, spot.vertex, 1.0 - spot.share};
}

bool same_place(const OutlinePlace& a, const OutlinePlace& b) {
  const OutlinePlace one = upwards(a), other = upwards(b);
  return one.vertex == other.vertex && one.to == other.to &&
         std::abs(one.share - other.share) < kSameCut;
}

bool is_same(const SplitCut& a, const SplitCut& b) {
  if (a.panel != b.panel) return false;
  return (same_place(a.start, b.start) && same_place(a.end, b.end)) ||
         (same_place(a.start, b.end) && same_place(a.end, b.start));
}

bool is_same(const CornerCut& a, const CornerCut& b) {
  return a.panel == b.panel && a.vertex == b.vertex;
}

bool is_same(const TrimCut& a, const TrimCut& b) {
  double size = 0.0, off = 0.0;
  for (std::size_t k = 0; k < a.plane.size(); ++k) {
    size = std::max(size, std::abs(a.plane[k]));
    off = std::max(off, std::abs(a.plane[k] - b.plane[k]));
  }
  return off <= kSameCut * size;
}

/// A place of the given mesh on the mesh that cuts made of it: their points may stand on its side,
/// and one of them there.
OutlinePlace on_made(const OutlinePlace& spot, const Mesh& mesh, const CutMesh& made) {
  if (spot.to < 0) return spot;
  const auto ends = std::minmax(spot.vertex, spot.to);
  const Eigen::Vector3d from = mesh.positions.col(spot.vertex);
  const Eigen::Vector3d side = mesh.positions.col(spot.to) - from;
  int before = spot.vertex, after = spot.to;
  double low = 0.0, high = 1.0;
  for (const AddedPoint& point : made.added) {
    if (point.from != ends.first || point.to != ends.second) continue;
    const Eigen::Vector3d place = made.mesh.positions.col(point.vertex);
    const double share = (place - from).dot(side) / side.squaredNorm();
    if (std::abs(share - spot.share) < kLeastShare) return {point.vertex};
    if (share < spot.share && share > low) std::tie(before, low) = std::pair(point.vertex, share);
    if (share > spot.share && share < high) std::tie(after, high) = std::pair(point.vertex, share);
  }
  if (before == spot.vertex && after == spot.to) return spot;
  return {before, after, (spot.share - low) / (high - low)};
}

// An image on the mesh that those before it left; nullopt where they made it.

std::optional<Cut> next_cut(const SplitCut& image, const Mesh& mesh, const CutMesh& made) {
  return SplitCut{image.panel, on_made(image.start, mesh, made), on_made(image.end, mesh, made)};
}

std::optional<Cut> next_cut(const StripCut& image, const Mesh& mesh, const CutMesh& made) {
  const OutlinePlace spot = on_made({image.from, image.to, image.share}, mesh, made);
  if (spot.to < 0) return std::nullopt;
  return StripCut{spot.vertex, spot.to, spot.share};
}

/// A split where points stand on its sides: shares of what is left of these are others.
std::optional<Cut> next_cut(const CornerCut& image, const Mesh& mesh, const CutMesh& made) {
  const auto corners = mesh.face(image.panel);
  const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), image.vertex) -
                                          corners.begin());
  const auto towards = [&](std::size_t neighbour) -> OutlinePlace {
    const int to = corners[neighbour % corners.size()];
    return image.share == 1.0 ? OutlinePlace{to} : OutlinePlace{image.vertex, to, image.share};
  };
  const OutlinePlace next = towards(k + 1), last = towards(k + corners.size() - 1);
  const OutlinePlace start = on_made(next, mesh, made), end = on_made(last, mesh, made);
  if (start == next && end == last) return image;
  return SplitCut{image.panel, start, end};
}

std::optional<Cut> next_cut(const TrimCut& image, const Mesh&, const CutMesh&) { return image; }

bool is_same(const StripCut& a, const StripCut& b) { return a == b; }

template <class Kind>
std::vector<Cut> each_image(const Kind& cut, const Mesh& mesh, const MeshSymmetry& symmetry) {
  std::vector<Cut> all = {cut};
  std::vector<Kind> images = {cut};
  for (std::size_t k = 1; k < symmetry.operations.size(); ++k) {
    const Kind image = CutImage(mesh, symmetry, k).of(cut);
    const auto is_there = [&](const Kind& one) { return is_same(one, image); };
    if (std::any_of(images.begin(), images.end(), is_there)) continue;
    images.push_back(image);
    const auto made = cut_mesh(mesh, all);
    if (!std::holds_alternative<CutMesh>(made)) return all;
    if (const auto next = next_cut(image, mesh, std::get<CutMesh>(made))) all.push_back(*next);
  }
  return all;
}

std::vector<Cut> each_image(const RefineCut& cut, const Mesh& mesh, const MeshSymmetry& symmetry) {
  RefineCut all = cut;
  for (std::size_t k = 1; k < symmetry.operations.size(); ++k) {
    for (const int f : CutImage(mesh, symmetry, k).of(cut).panels) {
      const bool is_new = std::find(all.panels.begin(), all.panels.end(), f) == all.panels.end();
      if (is_new) all.panels.push_back(f);
    }
  }
  return {all};
}

}  // namespace

std::vector<Cut> cut_with_images(const Mesh& mesh, const Cut& cut, const MeshSymmetry& symmetry) {
  // What it names is there only if it can be made.
  if (!std::holds_alternative<CutMesh>(cut_mesh(mesh, {cut}))) return {cut};
  return std::visit([&](const auto& one) { return each_image(one, mesh, symmetry); }, cut);
}

std::vector<Cut> cuts_with_images(const Mesh& mesh, const std::vector<Cut>& cuts,
                                  const MeshSymmetry& symmetry, double tolerance) {
  std::optional<MeshSymmetry> whole = symmetry, now = symmetry;
  if (std::holds_alternative<CutMesh>(cut_base(mesh, cuts, whole, tolerance))) return cuts;
  std::vector<Cut> all;
  Mesh left = mesh;
  for (const Cut& cut : cuts) {
    const std::vector<Cut> images = cut_with_images(left, cut, *now);
    all.insert(all.end(), images.begin(), images.end());
    auto made = cut_base(left, images, now, tolerance);
    if (std::holds_alternative<std::string>(made)) return all;
    left = std::get<CutMesh>(std::move(made)).mesh;
  }
  return all;
}

}  // namespace planish
