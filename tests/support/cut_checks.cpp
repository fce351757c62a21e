// SPDX-License-Identifier: MIT
#include "support/cut_checks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "planish/mesh/mesh_check.hpp"
#include "support/mesh_builders.hpp"

namespace planish::testing {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;
using CornerList = std::vector<int>;
using EdgeEnds = std::pair<int, int>;

CornerList corners_of(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  return {face.begin(), face.end()};
}

std::set<EdgeEnds> edges_of(const Mesh& mesh) {
  std::set<EdgeEnds> edges;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const CornerList face = corners_of(mesh, f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
    }
  }
  return edges;
}

/// Neighbours that run along their common side the same way.
int clashes(const Mesh& mesh) {
  std::map<EdgeEnds, int> runs;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const CornerList face = corners_of(mesh, f);
    for (std::size_t k = 0; k < face.size(); ++k) ++runs[{face[k], face[(k + 1) % face.size()]}];
  }
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.second > 1; }));
}

Eigen::Matrix3Xd points_of(const Mesh& mesh, const CornerList& corners) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) = mesh.positions.col(corners[k]);
  }
  return points;
}

/// Half the sum of cross products about the centroid.
Eigen::Vector3d area_of(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d middle = points.rowwise().mean();
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    const Eigen::Vector3d a = points.col(k) - middle;
    area += 0.5 * a.cross(points.col((k + 1) % points.cols()) - middle);
  }
  return area;
}

double size_of(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// The largest distance of a point from the plane through the middle, across the area.
double out_of_plane(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d normal = area_of(points).normalized(), middle = points.rowwise().mean();
  double largest = 0.0;
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    largest = std::max(largest, std::abs(normal.dot(points.col(k) - middle)));
  }
  return largest;
}

bool starts_with_bits(const Mesh& mesh, const Mesh& cut) {
  return cut.vertex_count() >= mesh.vertex_count() &&
         same_bits(Positions(cut.positions.leftCols(mesh.vertex_count())), mesh.positions);
}

/// Panels that records name as parts, and as such with a straight corner.
std::pair<std::set<int>, std::set<int>> named_panels(const CutMesh& cut) {
  std::pair<std::set<int>, std::set<int>> named;
  for (const CutRecord& record : cut.records) {
    named.first.insert(record.panels.begin(), record.panels.end());
    named.second.insert(record.straight.begin(), record.straight.end());
  }
  return named;
}

/// Of what no record names as a part: corners, added points left out.
AssertionResult keeps_panels(const Mesh& mesh, const CutMesh& cut) {
  const auto [parts, straight] = named_panels(cut);
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (parts.count(f) > 0) continue;
    CornerList corners = corners_of(cut.mesh, f);
    const auto added = std::remove_if(corners.begin(), corners.end(),
                                      [&](int v) { return v >= mesh.vertex_count(); });
    const bool has_added = added != corners.end();
    corners.erase(added, corners.end());
    if (cut.parents[static_cast<std::size_t>(f)] != f || corners != corners_of(mesh, f)) {
      return AssertionFailure() << "panel " << f << " is not as it was";
    }
    if (has_added != (straight.count(f) > 0)) {
      return AssertionFailure() << "panel " << f << ": its straight corners are not told";
    }
  }
  return AssertionSuccess();
}

/// Raises `figures` by the parts of panel `f`.
AssertionResult parts_of(const Mesh& mesh, const CutMesh& cut, int f, const std::vector<int>& parts,
                         CutFigures& figures) {
  const Eigen::Matrix3Xd panel = points_of(mesh, corners_of(mesh, f));
  const Eigen::Vector3d area = area_of(panel);
  const double size = size_of(panel);
  double sum = 0.0;
  for (const int part : parts) {
    const Eigen::Matrix3Xd points = points_of(cut.mesh, corners_of(cut.mesh, part));
    const double along = area_of(points).dot(area.normalized());
    if (!(along > 0.0)) return AssertionFailure() << "part " << part << " faces the other way";
    sum += along;
    figures.flatness = std::max(figures.flatness, out_of_plane(points) / size);
  }
  figures.bent = std::max(figures.bent, out_of_plane(panel) / size);
  figures.area = std::max(figures.area, std::abs(sum - area.norm()) / area.norm());
  return AssertionSuccess();
}

double total_area(const Mesh& mesh) {
  double sum = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    sum += area_of(points_of(mesh, corners_of(mesh, f))).norm();
  }
  return sum;
}

using PointBits = std::array<double, 3>;

PointBits place_of(const Mesh& mesh, int v) {
  return {mesh.positions(0, v), mesh.positions(1, v), mesh.positions(2, v)};
}

std::set<PointBits> used_places(const Mesh& mesh) {
  std::set<PointBits> places;
  for (const int v : mesh.face_vertices) places.insert(place_of(mesh, v));
  return places;
}

std::set<std::pair<PointBits, PointBits>> edge_places(const Mesh& mesh) {
  std::set<std::pair<PointBits, PointBits>> places;
  for (const auto& [a, b] : edges_of(mesh)) {
    places.insert(std::minmax(place_of(mesh, a), place_of(mesh, b)));
  }
  return places;
}

template <class Set>
int common_count(const Set& a, const Set& b) {
  return static_cast<int>(
      std::count_if(a.begin(), a.end(), [&](const auto& one) { return b.count(one) > 0; }));
}

}  // namespace

int euler_characteristic(const Mesh& mesh) {
  const std::set<int> used(mesh.face_vertices.begin(), mesh.face_vertices.end());
  return static_cast<int>(used.size()) - static_cast<int>(edges_of(mesh).size()) +
         mesh.face_count();
}

AssertionResult is_valid_cut(const Mesh& mesh, const CutMesh& cut, double largest,
                             CutFigures& figures) {
  const auto checked = check_mesh(cut.mesh);
  if (const std::string error = error_text(checked); !error.empty()) {
    return AssertionFailure() << error;
  }
  if (!starts_with_bits(mesh, cut.mesh)) return AssertionFailure() << "a point is not as it was";
  if (euler_characteristic(cut.mesh) != euler_characteristic(mesh)) {
    return AssertionFailure() << "the Euler characteristic is another";
  }
  if (clashes(mesh) == 0 && clashes(cut.mesh) > 0) {
    return AssertionFailure() << "a panel is turned over";
  }
  if (const auto kept = keeps_panels(mesh, cut); !kept) return kept;
  std::map<int, std::vector<int>> parts;
  for (const int f : named_panels(cut).first) {
    parts[cut.parents[static_cast<std::size_t>(f)]].push_back(f);
  }
  CutFigures own;
  for (const auto& [parent, panels] : parts) {
    if (const auto fine = parts_of(mesh, cut, parent, panels, own); !fine) return fine;
  }
  figures = {std::max(figures.flatness, own.flatness), std::max(figures.bent, own.bent),
             std::max(figures.area, own.area)};
  const double allowed = std::max(largest, 2.0 * own.bent);
  if (own.flatness > allowed || own.area > allowed) {
    return AssertionFailure() << "out of flat by " << own.flatness << ", areas by " << own.area
                              << " of what is out of flat by " << own.bent << " itself";
  }
  return AssertionSuccess();
}

AssertionResult are_two_halves(const Mesh& mesh, const CutMesh& before, const CutMesh& beyond,
                               double largest, CutFigures& figures) {
  for (const CutMesh* half : {&before, &beyond}) {
    if (const std::string error = error_text(check_mesh(half->mesh)); !error.empty()) {
      return AssertionFailure() << error;
    }
    if (!starts_with_bits(mesh, half->mesh)) return AssertionFailure() << "a point moved";
  }
  const int meeting = common_count(used_places(before.mesh), used_places(beyond.mesh)) -
                      common_count(edge_places(before.mesh), edge_places(beyond.mesh));
  const int sum = euler_characteristic(before.mesh) + euler_characteristic(beyond.mesh) - meeting;
  if (sum != euler_characteristic(mesh)) {
    return AssertionFailure() << "Euler characteristics add up to " << sum << ", not "
                              << euler_characteristic(mesh);
  }
  const double all = total_area(mesh);
  const double off = std::abs(total_area(before.mesh) + total_area(beyond.mesh) - all) / all;
  figures.area = std::max(figures.area, off);
  if (off > largest) return AssertionFailure() << "areas are off by " << off;
  return AssertionSuccess();
}

int RandomCuts::below(int count) {
  // Knuth's multiplier; the high bits are the random ones.
  state_ = state_ * 6364136223846793005u + 1442695040888963407u;
  return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(std::max(count, 1)));
}

int RandomCuts::panel(const Mesh& mesh, std::size_t corners) {
  int f = 0;
  for (int tries = 0; tries < 1000; ++tries) {
    f = below(mesh.face_count());
    const std::size_t count = mesh.face(f).size();
    if (corners == 0 ? count > 3 : count == corners) break;
  }
  return f;
}

SplitCut RandomCuts::split(const Mesh& mesh) {
  const int f = panel(mesh, 0);
  const CornerList face = corners_of(mesh, f);
  const int count = static_cast<int>(face.size());
  const auto corner = [&](int k) { return face[static_cast<std::size_t>(k % count)]; };
  const auto place = [&](int k) {
    if (below(2) == 0) return OutlinePlace{corner(k)};
    return OutlinePlace{corner(k), corner(k + 1), share()};
  };
  const int k = below(count);
  return {f, place(k), place(k + 2 + below(std::max(count - 3, 1)))};
}

StripCut RandomCuts::strip(const Mesh& mesh) {
  const CornerList face = corners_of(mesh, panel(mesh, 4));
  const auto k = static_cast<std::size_t>(below(static_cast<int>(face.size())));
  return {face[k], face[(k + 1) % face.size()], share()};
}

CornerCut RandomCuts::corner(const Mesh& mesh) {
  const int f = panel(mesh, 0);
  const CornerList face = corners_of(mesh, f);
  const int v = face[static_cast<std::size_t>(below(static_cast<int>(face.size())))];
  return {f, v, below(2) == 0 && face.size() > 3 ? 1.0 : share()};
}

RefineCut RandomCuts::refine(const Mesh& mesh) {
  RefineCut cut{{below(mesh.face_count())}, below(2) == 0};
  // Neighbours, so that sides are shared.
  const CornerList face = corners_of(mesh, cut.panels.front());
  for (int f = 0; f < mesh.face_count() && cut.panels.size() < 3; ++f) {
    const CornerList other = corners_of(mesh, f);
    const bool meets = std::find(other.begin(), other.end(), face[0]) != other.end();
    if (meets && f != cut.panels.front() && below(2) == 0) cut.panels.push_back(f);
  }
  return cut;
}

TrimCut RandomCuts::trim(const Mesh& mesh) {
  const Eigen::Matrix3Xd points = points_of(mesh, corners_of(mesh, below(mesh.face_count())));
  const Eigen::Vector3d normal(share() - 0.5, share() - 0.5, share() - 0.5);
  const Eigen::Vector3d middle = points.rowwise().mean();
  return {{normal.x(), normal.y(), normal.z(), normal.dot(middle)}};
}

Cut RandomCuts::any(const Mesh& mesh) {
  switch (below(4)) {
    case 0:
      return split(mesh);
    case 1:
      return strip(mesh);
    case 2:
      return corner(mesh);
    default:
      return refine(mesh);
  }
}

Cut parsed_cut(const std::string& text) {
  auto cut = parse_cut(text);
  if (const auto* why = std::get_if<std::string>(&cut)) ADD_FAILURE() << *why;
  return std::get<Cut>(cut);
}

}  // namespace planish::testing
