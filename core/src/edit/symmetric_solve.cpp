// SPDX-License-Identifier: MIT
#include "edit/symmetric_solve.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "engines/working_set.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Images that far away, in face rings, are tried one by one first: an edit without a reach is
/// certified on some ten rings and along the lines of the mesh.
int far_rings(const HandleEditOptions& options) {
  constexpr int kEverywhere = 24;
  return options.reach > 0 ? std::min(kEverywhere, 2 * options.reach + 2) : kEverywhere;
}

/// The first handle of each orbit.
std::vector<Handle> first_handles(const std::vector<Handle>& handles,
                                  const MeshSymmetry& symmetry) {
  std::vector<Handle> first;
  std::set<int> seen;
  for (const Handle& handle : handles) {
    if (seen.count(handle.vertex) != 0) continue;
    first.push_back(handle);
    for (const SymmetryOperation& one : symmetry.operations)
      seen.insert(one.image[at(handle.vertex)]);
  }
  return first;
}

std::vector<int> vertices_of(const std::vector<Handle>& handles) {
  std::vector<int> vertices;
  vertices.reserve(handles.size());
  for (const Handle& handle : handles) vertices.push_back(handle.vertex);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Ascending.
std::vector<int> images_of(const std::vector<int>& vertices, const SymmetryOperation& operation) {
  std::vector<int> images;
  images.reserve(vertices.size());
  for (const int v : vertices) images.push_back(operation.image[at(v)]);
  std::sort(images.begin(), images.end());
  return images;
}

bool are_disjoint(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both.empty();
}

/// The part of the group that keeps a set of vertices, as a symmetry of its own.
MeshSymmetry keeping(const MeshSymmetry& symmetry, const std::vector<int>& vertices) {
  MeshSymmetry part{symmetry.elements, symmetry.centre, {}};
  for (const SymmetryOperation& one : symmetry.operations) {
    if (images_of(vertices, one) == vertices) part.operations.push_back(one);
  }
  return part;
}

/// Operations that take `vertices` to different places, the identity first: one for each copy.
std::vector<std::size_t> copies_of(const MeshSymmetry& symmetry, const std::vector<int>& vertices) {
  std::vector<std::size_t> copies;
  std::set<std::vector<int>> places;
  for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
    if (places.insert(images_of(vertices, symmetry.operations[k])).second) copies.push_back(k);
  }
  return copies;
}

}  // namespace

/// Every orbit of which more than `share` moves at the mean of its places, every other one at rest.
ExactDesign SymmetricSolve::evened(const ExactDesign& design, const MeshSymmetry& symmetry,
                                   double share) {
  Positions shape = model_.mesh_model().mesh.positions;
  shape(Eigen::all, design.vertices) = design.positions;
  std::set<int> orbits;
  for (const int v : design.vertices) {
    std::vector<int> orbit;
    for (const SymmetryOperation& one : symmetry.operations) orbit.push_back(one.image[at(v)]);
    const auto moves = std::count_if(orbit.begin(), orbit.end(), [&](int image) {
      return std::binary_search(design.vertices.begin(), design.vertices.end(), image);
    });
    if (static_cast<double>(moves) > share * static_cast<double>(orbit.size())) {
      orbits.insert(orbit.begin(), orbit.end());
    }
  }
  const std::vector<int> vertices(orbits.begin(), orbits.end());
  even_out(symmetry, vertices, shape);
  return model_.placed(vertices, shape);
}

/// A symmetric design near one that need not be, of the orbits of which more than `share` moves;
/// nullopt where none was found that is exact. What evening out takes from flatness is of the
/// second order, so that a few rounds make both.
std::optional<ExactDesign> SymmetricSolve::make_symmetric(const ExactDesign& found,
                                                          const MeshSymmetry& symmetry,
                                                          double share) {
  constexpr int kMostRounds = 4;
  ExactDesign even = evened(found, symmetry, share);
  solve_until_steady(
      even, kMostRounds, [&] { return evened(search_.corrected(even), symmetry, share); },
      [&](const ExactDesign& last) { return !model_.is_acceptable(last); });
  if (!model_.is_acceptable(even)) return std::nullopt;
  return even;
}

/// Evens out the orbits that mostly move, so that few points do; all that move at all where those
/// cannot be flat: a lop-sided support has hardly an orbit that mostly moves.
std::optional<ExactDesign> SymmetricSolve::make_symmetric(const ExactDesign& found,
                                                          const MeshSymmetry& symmetry) {
  std::optional<ExactDesign> even = make_symmetric(found, symmetry, 0.5);
  return even ? std::move(even) : make_symmetric(found, symmetry, 0.0);
}

/// Whether no other handle is near those at `vertices`.
bool SymmetricSolve::are_far_apart(const EditTargets& targets, const std::vector<int>& vertices) {
  WorkingSetGrower grower(model_.mesh_model());
  const std::vector<int> near = grower.grow(vertices, far_rings(model_.options()));
  return std::none_of(targets.handles.begin(), targets.handles.end(), [&](const Handle& handle) {
    return !std::binary_search(vertices.begin(), vertices.end(), handle.vertex) &&
           std::binary_search(near.begin(), near.end(), handle.vertex);
  });
}

/// What one copy moves, at the places of all.
ExactDesign SymmetricSolve::copied(const ExactDesign& one, const std::vector<std::size_t>& copies) {
  Positions shape = model_.mesh_model().mesh.positions;
  std::vector<int> moved;
  for (const std::size_t k : copies) {
    for (std::size_t c = 0; c < one.vertices.size(); ++c) {
      const int image = symmetry_.operations[k].image[at(one.vertices[c])];
      shape.col(image) = symmetry_.moved(k, one.positions.col(static_cast<Eigen::Index>(c)));
      moved.push_back(image);
    }
  }
  std::sort(moved.begin(), moved.end());
  even_out(symmetry_, moved, shape);
  return model_.placed(moved, shape);
}

/// Handles that are far from all their images, solved alone and copied: where what one copy's
/// certificate is about touches no other copy's, together they are certified. nullopt where not.
std::optional<ExactDesign> SymmetricSolve::solve_by_copies(const EditTargets& targets,
                                                           const Progress& progress,
                                                           SolveReport& report) {
  EditTargets one = targets;
  one.handles = first_handles(targets.handles, symmetry_);
  const std::vector<int> vertices = vertices_of(one.handles);
  const std::vector<std::size_t> copies = copies_of(symmetry_, vertices);
  if (copies.size() < 2 || model_.has_limits()) return std::nullopt;
  if (!are_far_apart(targets, vertices)) return std::nullopt;
  model_.set_targets(one);
  const ExactDesign design = search_.find(progress, report);
  if (report.status != SolveStatus::kConverged) return std::nullopt;
  const auto even = make_symmetric(design, keeping(symmetry_, vertices));
  if (!even) return std::nullopt;
  report.optimality = search_.optimality(*even);
  const std::vector<int> certified = search_.newton().certified_set();
  for (std::size_t k = 1; k < copies.size(); ++k) {
    if (!are_disjoint(certified, images_of(certified, symmetry_.operations[copies[k]]))) {
      return std::nullopt;
    }
  }
  model_.set_targets(targets);
  ExactDesign all = copied(*even, copies);
  if (!model_.is_acceptable(all) || !report.optimality->met()) return std::nullopt;
  report.optimality->certified_vertices *= static_cast<int>(copies.size());
  return all;
}

/// Solves for all images in one problem.
ExactDesign SymmetricSolve::solve_together(const Progress& progress, SolveReport& report) {
  const ExactDesign found = search_.find(progress, report);
  std::optional<ExactDesign> even = make_symmetric(found, symmetry_);
  if (!even) {
    report.optimality.reset();
    if (report.status != SolveStatus::kCancelled) report.status = SolveStatus::kInfeasibleHandles;
    return EditModel::unmoved();
  }
  if (report.optimality) {
    report.optimality = search_.optimality(*even);
    if (!report.optimality->met() && report.status == SolveStatus::kConverged) {
      report.status = SolveStatus::kIterationLimit;
    }
  }
  return std::move(*even);
}

ExactDesign SymmetricSolve::find(const EditTargets& targets, const Progress& progress,
                                 SolveReport& report) {
  if (auto design = solve_by_copies(targets, progress, report)) return std::move(*design);
  SolveReport together;
  together.cost = report.cost;
  report = std::move(together);
  model_.set_targets(targets);
  return solve_together(progress, report);
}

}  // namespace planish
