// SPDX-License-Identifier: MIT
/// A solve under a symmetry: one handle and copies of it where its images are far away, all of them
/// together where they are near; evened out, and judged as every edit is. [SYM-2]
#include <algorithm>
#include <set>
#include <utility>

#include "edit/handle_edit_state.hpp"
#include "engines/working_set.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {
namespace {

/// Images that far away, in face rings, are tried one by one first: an edit without a reach is
/// certified on some ten rings and along the lines of the mesh.
int far_rings(const HandleEditOptions& options) {
  constexpr int kUnlimited = 24;
  return options.reach > 0 ? std::min(kUnlimited, 2 * options.reach + 2) : kUnlimited;
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

/// Whether two boxes are one, whichever of their halves is named first.
bool is_same_box(const KeptBox& a, const KeptBox& b) {
  constexpr double kSame = 1e-12;
  const double size = a.centre.cwiseAbs().maxCoeff() + a.halves.cwiseAbs().maxCoeff();
  if ((a.centre - b.centre).norm() > kSame * size) return false;
  for (int i = 0; i < 3; ++i) {
    bool found = false;
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d one = a.halves.col(i), other = b.halves.col(j);
      found = found || std::min((one - other).norm(), (one + other).norm()) <= kSame * size;
    }
    if (!found) return false;
  }
  return true;
}

bool is_same_side(const HalfSpace& a, const HalfSpace& b) {
  constexpr double kSame = 1e-12;
  return (a.normal - b.normal).norm() <= kSame &&
         std::abs(a.bound - b.bound) <= kSame * std::abs(a.bound);
}

/// What keep-outs and all their images leave free, each of them once.
FreeSpace with_images(const FreeSpace& free, const MeshSymmetry& symmetry) {
  FreeSpace all;
  all.apart = free.apart;
  all.wall_clearance = free.wall_clearance;
  const auto add = [](auto& list, const auto& image, const auto& is_same) {
    const bool known =
        std::any_of(list.begin(), list.end(), [&](const auto& one) { return is_same(one, image); });
    if (!known) list.push_back(image);
  };
  for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
    const Eigen::Matrix3d& turn = symmetry.operations[k].turn;
    for (const HalfSpace& side : free.sides) {
      const Eigen::Vector3d normal = turn * side.normal;
      const double shift = (normal - side.normal).dot(symmetry.centre);
      add(all.sides, HalfSpace{normal, side.bound + shift}, is_same_side);
    }
    for (const Positions& wall : free.walls) {
      Positions image = wall;
      for (auto corner : image.colwise()) corner = symmetry.moved(k, corner);
      all.walls.push_back(std::move(image));
    }
    for (const KeptBox& box : free.boxes) {
      const KeptBox image{symmetry.moved(k, box.centre), turn * box.halves, box.clearance};
      add(all.boxes, image, is_same_box);
    }
  }
  return all;
}

}  // namespace

/// The design at other positions, judged as it will be written.
ExactDesign HandleEditSolver::State::placed(const std::vector<int>& vertices,
                                            const Positions& shape) {
  Positions positions = shape(Eigen::all, vertices);
  ExactDesign design = finish_->measured(vertices, std::move(positions));
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const VertexTerm& term = problem_.terms[at(vertices[k])];
    if (term.fixed) design.displacement.col(static_cast<Eigen::Index>(k)) = term.target;
  }
  return design;
}

/// Every orbit of which more than `share` moves at the mean of its places, every other one at rest.
ExactDesign HandleEditSolver::State::evened(const ExactDesign& design, const MeshSymmetry& symmetry,
                                            double share) {
  Positions shape = model_->mesh.positions;
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
  return placed(vertices, shape);
}

/// A symmetric design near one that need not be, of the orbits of which more than `share` moves;
/// nullopt where none was found that is exact. What evening out takes from flatness is of the
/// second order, so that a few rounds make both.
std::optional<ExactDesign> HandleEditSolver::State::make_symmetric(const ExactDesign& found,
                                                                   const MeshSymmetry& symmetry,
                                                                   double share) {
  constexpr int kMostRounds = 4;
  ExactDesign even = evened(found, symmetry, share);
  for (int round = 0; round < kMostRounds && !is_acceptable(even); ++round) {
    trial_->clear();
    for (std::size_t k = 0; k < even.vertices.size(); ++k) {
      trial_->set_displacement(even.vertices[k],
                               even.displacement.col(static_cast<Eigen::Index>(k)));
    }
    even = evened(finish_->finish(problem_, even.vertices, *trial_, kept_), symmetry, share);
  }
  if (!is_acceptable(even)) return std::nullopt;
  return even;
}

/// Of the orbits that mostly move, so that few points do; of all that move at all where those
/// cannot be flat: a lop-sided support has hardly an orbit that mostly moves.
std::optional<ExactDesign> HandleEditSolver::State::make_symmetric(const ExactDesign& found,
                                                                   const MeshSymmetry& symmetry) {
  std::optional<ExactDesign> even = make_symmetric(found, symmetry, 0.5);
  return even ? std::move(even) : make_symmetric(found, symmetry, 0.0);
}

/// Handles that are far from all their images, solved alone and copied: where what one copy's
/// certificate is about touches no other copy's, together they are certified. nullopt where not.
std::optional<ExactDesign> HandleEditSolver::State::solve_by_copies(const EditTargets& targets,
                                                                    const MeshSymmetry& symmetry,
                                                                    const Progress& progress,
                                                                    SolveReport& report) {
  EditTargets one = targets;
  one.handles = first_handles(targets.handles, symmetry);
  const std::vector<int> vertices = vertices_of(one.handles);
  const std::vector<std::size_t> copies = copies_of(symmetry, vertices);
  if (copies.size() < 2 || limits_ != nullptr) return std::nullopt;
  WorkingSetGrower grower(*model_);
  const std::vector<int> near = grower.grow(vertices, far_rings(options_));
  for (const Handle& handle : targets.handles) {
    const bool own = std::binary_search(vertices.begin(), vertices.end(), handle.vertex);
    if (!own && std::binary_search(near.begin(), near.end(), handle.vertex)) return std::nullopt;
  }
  set_targets(one);
  open_tracks();
  ExactDesign design = find_design(progress, report);
  if (report.status != SolveStatus::kConverged) return std::nullopt;
  const MeshSymmetry own = keeping(symmetry, vertices);
  const auto even = make_symmetric(design, own);
  if (!even) return std::nullopt;
  report.optimality = newton_->optimality(problem_, even->vertices, even->displacement);
  std::vector<int> certified = newton_->certified_set();
  for (std::size_t k = 1; k < copies.size(); ++k) {
    if (!are_disjoint(certified, images_of(certified, symmetry.operations[copies[k]]))) {
      return std::nullopt;
    }
  }
  Positions shape = model_->mesh.positions;
  std::vector<int> moved;
  for (const std::size_t k : copies) {
    for (std::size_t c = 0; c < even->vertices.size(); ++c) {
      const int image = symmetry.operations[k].image[at(even->vertices[c])];
      shape.col(image) = symmetry.moved(k, even->positions.col(static_cast<Eigen::Index>(c)));
      moved.push_back(image);
    }
  }
  std::sort(moved.begin(), moved.end());
  even_out(symmetry, moved, shape);
  set_targets(targets);
  ExactDesign all = placed(moved, shape);
  if (!is_acceptable(all) || !report.optimality->met()) return std::nullopt;
  report.optimality->certified_vertices *= static_cast<int>(copies.size());
  return all;
}

/// All images in one problem.
ExactDesign HandleEditSolver::State::solve_together(const MeshSymmetry& symmetry,
                                                    const Progress& progress, SolveReport& report) {
  const ExactDesign found = find_design(progress, report);
  std::optional<ExactDesign> even = make_symmetric(found, symmetry);
  if (!even) {
    report.optimality.reset();
    if (report.status != SolveStatus::kCancelled) report.status = SolveStatus::kInfeasibleHandles;
    return unmoved();
  }
  if (report.optimality) {
    report.optimality = newton_->optimality(problem_, even->vertices, even->displacement);
    if (!report.optimality->met() && report.status == SolveStatus::kConverged) {
      report.status = SolveStatus::kIterationLimit;
    }
  }
  return std::move(*even);
}

ExactDesign HandleEditSolver::State::find_symmetric(const EditTargets& targets,
                                                    const MeshSymmetry& symmetry,
                                                    const Progress& progress, SolveReport& report) {
  if (auto design = solve_by_copies(targets, symmetry, progress, report)) return std::move(*design);
  SolveReport together;
  together.cost = report.cost;
  report = std::move(together);
  set_targets(targets);
  open_tracks();
  return solve_together(symmetry, progress, report);
}

HandleEditResult HandleEditSolver::State::solve_symmetric(const EditTargets& targets,
                                                          const MeshSymmetry& symmetry,
                                                          const Progress& progress) {
  const Stopwatch watch;
  set_targets(targets);
  SolveReport report;
  if (nothing_to_do()) {
    report.status = SolveStatus::kConverged;
    report.solve_seconds = watch.seconds();
    return result_of(unmoved(), std::move(report));
  }
  if (has_keep_outs()) {
    keep_out(with_images(free_space(options_.keep_outs, options_.clearance), symmetry));
  }
  const auto find = [&](SolveReport& found) {
    return find_symmetric(targets, symmetry, progress, found);
  };
  ExactDesign design = find(report);
  if (has_keep_outs()) part_panels(find, design, report);
  HandleEditResult result = result_of(design, std::move(report));
  if (has_keep_outs()) keep_out();
  result.report.solve_seconds = watch.seconds();
  return result;
}

HandleEditResult HandleEditSolver::solve_symmetric(const EditTargets& targets,
                                                   const MeshSymmetry& symmetry,
                                                   const Progress& progress) {
  return state_->solve_symmetric(targets, symmetry, progress);
}

}  // namespace planish
