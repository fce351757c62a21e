// SPDX-License-Identifier: MIT
#include "planish/problem/problem.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "planish/constraints/elements.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
MeshModel::MeshModel(const Mesh& given, FairnessKind kind, const KeptKinds& kinds)
    : mesh(given), adjacency(build_adjacency(given)), kept(kinds) {
  const double edge = mean_edge_length(mesh);
  unit_ = edge > 0.0 ? edge : 1.0;
  // Relative to a vertex first: the mean of coordinates far from the origin loses digits.
  const Eigen::Vector3d origin =
      mesh.vertex_count() > 0 ? mesh.positions.col(0).eval() : Eigen::Vector3d::Zero().eval();
  points = mesh.positions.colwise() - origin;
  if (mesh.vertex_count() > 0) points.colwise() -= points.rowwise().mean().eval();
  points /= unit_;
  fairness = fairness_operator(mesh, adjacency, kind);
  fairness_columns = fairness.transpose();
  MeshElements elements(mesh, adjacency);
  kept.for_each([&](auto tag, std::size_t index) {
    using Kind = typename decltype(tag)::type;
    constexpr Element kElement = Kind::kElement;
    static_assert(kElement == Element::kFace || kElement == Element::kVertex,
                  "patches cut rows face by face and star by star");
    static_assert(Kind::kSense == Sense::kZero, "engines take rows as equalities");
    std::vector<int>& offsets = element_offsets[index];
    offsets.assign(1, 0);
    for (int e = 0; e < elements.count(kElement); ++e) {
      Kind::append_rows(points, elements.of(kElement, e), equations.of<Kind>());
      offsets.push_back(static_cast<int>(equations.of<Kind>().size()));
    }
  });
  if (kept.keeps_bends()) keep_bends();
}

/// Rounding bends no panel: what is flat stays so.
void MeshModel::keep_bends() {
  constexpr std::size_t kPlanar = ConstraintKinds::index_of<PlanarPolygon>();
  std::vector<FlatnessEquation>& rows = equations.of<PlanarPolygon>();
  const std::vector<int>& offsets = element_offsets[kPlanar];
  bends_.assign(at(mesh.face_count()), 0.0);
  bent_rows_.assign(rows.size(), 0.0);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double excess = violation_of<PlanarPolygon>(mesh.positions, mesh.face(f)).excess;
    if (!(excess > PlanarPolygon::kTolerance)) continue;
    bends_[at(f)] = excess;
    for (int e = offsets[at(f)]; e < offsets[at(f) + 1]; ++e) {
      rows[at(e)] = bent_equation(points, rows[at(e)], mesh.face(f).size() == 4);
      bent_rows_[at(e)] = rows[at(e)].bend;
    }
  }
}

void MeshModel::ease_bend(int face, double share) {
  const std::vector<int>& offsets = element_offsets[ConstraintKinds::index_of<PlanarPolygon>()];
  for (int e = offsets[at(face)]; e < offsets[at(face) + 1]; ++e) {
    equations.of<PlanarPolygon>()[at(e)].bend *= share;
  }
  eased_.push_back(face);
}

void MeshModel::restore_bends() {
  const std::vector<int>& offsets = element_offsets[ConstraintKinds::index_of<PlanarPolygon>()];
  for (const int f : eased_) {
    for (int e = offsets[at(f)]; e < offsets[at(f) + 1]; ++e) {
      equations.of<PlanarPolygon>()[at(e)].bend = bent_rows_[at(e)];
    }
  }
  eased_.clear();
}

bool MeshModel::has_star_rows(int vertex) const {
  bool any = false;
  kept.for_each([&](auto tag, std::size_t index) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kElement != Element::kVertex) return;
    const std::vector<int>& offsets = element_offsets[index];
    any = any || offsets[at(vertex) + 1] > offsets[at(vertex)];
  });
  return any;
}

std::span<const int> MeshModel::face(int f) const { return mesh.face(f); }

PatchCutter::PatchCutter(const MeshModel& model)
    : local_of_(at(model.vertex_count()), -1),
      face_mark_(at(model.mesh.face_count()), 0),
      row_mark_(static_cast<std::size_t>(model.fairness.rows()), 0) {}

int PatchCutter::local(int vertex, Patch& patch) {
  int& found = local_of_[at(vertex)];
  if (found < 0) {
    found = patch.local_count();
    patch.vertices.push_back(vertex);
  }
  return found;
}

/// The rows of the patch's faces and stars that touch a free vertex, kind by kind.
void PatchCutter::cut_equations(const MeshModel& model, Patch& patch) {
  int first = 0;
  model.kept.for_each([&](auto tag, std::size_t index) {
    using Kind = typename decltype(tag)::type;
    const auto& rows = model.equations.of<Kind>();
    const std::vector<int>& offsets = model.element_offsets[index];
    for (const int id : Kind::kElement == Element::kFace ? patch.face_ids : patch.star_ids) {
      for (int e = offsets[at(id)]; e < offsets[at(id) + 1]; ++e) {
        typename Kind::Row row = rows[at(e)];
        if (!localise(row.vertices, local_of_, patch.free_count)) continue;
        patch.equations.of<Kind>().push_back(row);
        patch.equation_ids.push_back(first + e);
      }
    }
    first += static_cast<int>(rows.size());
  });
}

void PatchCutter::begin(const EditProblem& problem, std::span<const int> free, Patch& patch) {
  patch.vertices.clear();
  patch.equations.clear();
  patch.equation_ids.clear();
  patch.face_ids.clear();
  patch.star_ids.clear();
  patch.faces.offsets.assign(1, 0);
  patch.faces.values.clear();
  patch.fairness_vertices.offsets.assign(1, 0);
  patch.fairness_vertices.values.clear();
  patch.fairness_values.clear();
  patch.inequalities.clear();
  patch.fairness_weight = problem.fairness_weight;
  patch.shape_weight = problem.shape_weight;
  patch.keep_out_weight = problem.keep_out_weight;
  patch.inequality_ids.clear();
  for (std::vector<int>& numbers : limit_numbers_) numbers.clear();
  straight_places_.clear();
  ++stamp_;
  for (const int v : free) {
    if (!problem.terms[at(v)].fixed) (void)local(v, patch);
  }
  patch.free_count = patch.local_count();
}

/// The outline of one face, and its corners that touch a free vertex.
void PatchCutter::add_face(const EditProblem& problem, int f, Patch& patch) {
  const MeshModel& model = *problem.model;
  if (model.face(f).size() >= 4) {
    patch.face_ids.push_back(f);
    for (const int w : model.face(f)) patch.faces.values.push_back(local(w, patch));
    patch.faces.offsets.push_back(static_cast<int>(patch.faces.values.size()));
  }
  if (problem.shape_weight > 0.0) add_corners(problem, f, patch);
  if (problem.limits != nullptr) add_limits(*problem.limits, f, patch);
}

/// The shape bound's rows of one face.
void PatchCutter::add_corners(const EditProblem& problem, int f, Patch& patch) {
  const MeshModel& model = *problem.model;
  std::vector<CornerShape>& corners = patch.inequalities.of<ShapeBound>();
  std::size_t kept = corners.size();
  append_corner_shapes(model.points, model.face(f), corners);
  for (std::size_t k = kept; k < corners.size(); ++k) {
    CornerShape corner = corners[k];
    if (problem.limits_straight_corners && is_straight(corner)) {
      add_straight(model, f, straight_corner(corner), patch);
    } else if (enter(corner.vertices, patch)) {
      corners[kept++] = corner;
    }
  }
  corners.resize(kept);
}

void PatchCutter::add_straight(const MeshModel& model, int f, StraightCorner corner, Patch& patch) {
  const auto outline = model.face(f);
  const auto place = std::find(outline.begin(), outline.end(), corner.vertices[1]);
  if (!enter(corner.vertices, patch)) return;
  straight_places_.push_back(model.mesh.face_offsets[at(f)] +
                             static_cast<int>(place - outline.begin()));
  patch.inequalities.of<StraightBound>().push_back(corner);
}

/// Gives a row's vertices local numbers, new ones to those that have none.
/// @returns whether one of them is free
bool PatchCutter::enter(std::span<int> vertices, Patch& patch) {
  bool touches = false;
  for (int& v : vertices) {
    v = local(v, patch);
    touches = touches || v < patch.free_count;
  }
  return touches;
}

/// The rows of one face's stated limits and keep-outs. Those of two panels come with the first of
/// the two.
void PatchCutter::add_limits(const MeshLimits& limits, int f, Patch& patch) {
  limits.for_each_row(f, [&](auto tag, const auto& row, int other, int number) {
    using Kind = typename decltype(tag)::type;
    if (other >= 0 && face_mark_[at(other)] == stamp_) return;
    typename Kind::Row here = row;
    if (!enter(here.vertices, patch)) return;
    patch.inequalities.of<Kind>().push_back(std::move(here));
    limit_numbers_[LimitKinds::index_of<Kind>()].push_back(number);
  });
  if (limits.keep_outs() == nullptr) return;
  for (KeepOutRow row : limits.keep_outs()->of(f)) {
    if (enter(row.vertices, patch)) patch.inequalities.of<KeepOutPlane>().push_back(row);
  }
}

/// The stars with rows that a vertex is part of: its own and its neighbours'.
void PatchCutter::add_stars(const MeshModel& model, int vertex, Patch& patch) {
  star_mark_.resize(local_of_.size(), 0);
  const auto add = [&](int centre) {
    if (star_mark_[at(centre)] == stamp_ || !model.has_star_rows(centre)) return;
    star_mark_[at(centre)] = stamp_;
    patch.star_ids.push_back(centre);
    (void)local(centre, patch);
    for (const int w : model.adjacency.neighbours[centre]) (void)local(w, patch);
  };
  add(vertex);
  for (const int w : model.adjacency.neighbours[vertex]) add(w);
}

void PatchCutter::add_fairness_rows(const EditProblem& problem, int vertex, Patch& patch) {
  const MeshModel& model = *problem.model;
  for (FairnessOperator::InnerIterator row(model.fairness_columns, vertex); row; ++row) {
    const auto r = static_cast<int>(row.col());
    if (row_mark_[at(r)] == stamp_) continue;
    row_mark_[at(r)] = stamp_;
    for (FairnessOperator::InnerIterator entry(model.fairness, r); entry; ++entry) {
      const int w = local(static_cast<int>(entry.col()), patch);
      patch.fairness_vertices.values.push_back(w);
      patch.fairness_values.push_back(entry.value());
    }
    patch.fairness_vertices.offsets.push_back(
        static_cast<int>(patch.fairness_vertices.values.size()));
  }
}

/// What the first `owners` vertices take part in.
void PatchCutter::add_rows(const EditProblem& problem, int owners, Patch& patch) {
  const MeshModel& model = *problem.model;
  for (int k = 0; k < owners; ++k) {
    const int v = patch.vertices[at(k)];
    for (const int f : model.adjacency.faces[v]) {
      const bool bare =
          model.face(f).size() < 4 && problem.shape_weight <= 0.0 && problem.limits == nullptr;
      if (face_mark_[at(f)] == stamp_ || bare) continue;
      face_mark_[at(f)] = stamp_;
      add_face(problem, f, patch);
    }
    if (model.kept.has_element(Element::kVertex)) add_stars(model, v, patch);
    if (problem.fairness_weight > 0.0) add_fairness_rows(problem, v, patch);
  }
  cut_equations(model, patch);
}

namespace {

/// A track for displacements that begin where the model's points are.
SlideTrack seen_from(const EditProblem& problem, int vertex, SlideTrack track) {
  if (problem.slides_from == nullptr) return track;
  const Eigen::Vector3d to_track = track.offset - problem.slides_from->col(vertex);
  track.offset = to_track - track.along * to_track;
  return track;
}

}  // namespace

/// Points, terms and the constant displacement of the halo; forgets the local numbers.
void PatchCutter::place(const EditProblem& problem, Patch& patch) {
  patch.points.resize(3, patch.local_count());
  patch.displacement.setZero(3, patch.local_count());
  patch.terms.resize(at(patch.free_count));
  patch.slides.clear();
  for (int k = 0; k < patch.local_count(); ++k) {
    const int v = patch.vertices[at(k)];
    patch.points.col(k) = problem.model->points.col(v);
    const VertexTerm& term = problem.terms[at(v)];
    if (k < patch.free_count) {
      patch.terms[at(k)] = term;
      const SlideTrack* track = problem.slides ? problem.slides->track(v) : nullptr;
      if (track != nullptr) patch.slides.push_back({k, seen_from(problem, v, *track)});
    }
    if (term.fixed) patch.displacement.col(k) = term.target;
    local_of_[at(v)] = -1;
  }
  if (problem.slides != nullptr && problem.slides->has_feet()) add_surface_rows(problem, patch);
  number_inequalities(*problem.model, patch);
}

/// Their multipliers come after those of all equations and surface rows, those of straight corners
/// first. Without stated limits and straight corners there are none, and nothing to number.
void PatchCutter::number_inequalities(const MeshModel& model, Patch& patch) const {
  if (straight_places_.empty() &&
      std::all_of(limit_numbers_.begin(), limit_numbers_.end(),
                  [](const std::vector<int>& numbers) { return numbers.empty(); })) {
    return;
  }
  const int first_straight = static_cast<int>(model.equations.size()) +
                             kMostSurfaceRows * static_cast<int>(local_of_.size());
  const int first = first_straight + model.mesh.face_offsets.back();
  patch.inequality_ids.assign(patch.inequalities.of<ShapeBound>().size(), -1);
  for (const std::vector<int>& numbers : limit_numbers_) {
    for (const int number : numbers) patch.inequality_ids.push_back(first + number);
  }
  patch.inequality_ids.resize(patch.inequalities.size() - straight_places_.size(), -1);
  for (const int place : straight_places_) patch.inequality_ids.push_back(first_straight + place);
}

/// Adds rows of the free vertices that stand on a surface. Their multipliers have the numbers after
/// all others.
void PatchCutter::add_surface_rows(const EditProblem& problem, Patch& patch) {
  for (int k = 0; k < patch.free_count; ++k) {
    const int v = patch.vertices[at(k)];
    int number = static_cast<int>(problem.model->equations.size()) + kMostSurfaceRows * v;
    for (SurfaceRow row : problem.slides->surface_rows(v)) {
      row.vertices = {k};
      if (problem.slides_from != nullptr) row.centre -= problem.slides_from->col(v);
      row.centre += patch.points.col(k);
      patch.equations.of<SurfacePoint>().push_back(row);
      patch.equation_ids.push_back(number++);
    }
  }
}

void PatchCutter::cut(const EditProblem& problem, std::span<const int> free, Patch& patch) {
  begin(problem, free, patch);
  add_rows(problem, patch.free_count, patch);
  place(problem, patch);
}

void PatchCutter::cut_open(const EditProblem& problem, std::span<const int> inner, Patch& patch) {
  cut(problem, inner, patch);
  const int owners = patch.free_count;
  const std::vector<int> reached = std::move(patch.vertices);
  begin(problem, reached, patch);
  add_rows(problem, owners, patch);
  place(problem, patch);
}

void put_on_tracks(const Patch& patch, Eigen::Matrix3Xd& displacement) {
  for (const Slide& slide : patch.slides) {
    const Eigen::Vector3d d = displacement.col(slide.vertex);
    displacement.col(slide.vertex) = slide.track.nearest(d);
  }
}

Eigen::Matrix3Xd on_tracks(const Patch& patch) {
  Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Zero(3, patch.free_count);
  put_on_tracks(patch, displacement);
  return displacement;
}

ObjectiveTerms objective(const Patch& patch) {
  ObjectiveTerms result;
  for (int k = 0; k < patch.free_count; ++k) {
    const VertexTerm& term = patch.terms[at(k)];
    const Eigen::Vector3d d = patch.displacement.col(k);
    const double square = 0.5 * term.square_weight * (d - term.target).squaredNorm();
    (term.handle ? result.handle : result.sparsity) += square;
    result.sparsity += 0.5 * term.norm_weight * d.norm();
  }
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    const Eigen::Vector3d sum = row.sum([&](int v) { return patch.displacement.col(v); });
    result.fairness += 0.5 * patch.fairness_weight * sum.squaredNorm();
  });
  return result;
}

bool localise(std::span<int> vertices, const std::vector<int>& local, int free_count) {
  bool touches = false;
  for (int& v : vertices) {
    v = local[at(v)];
    touches = touches || v < free_count;
  }
  return touches;
}

void residuals_at(const Patch& patch, const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) {
  out.resize(static_cast<Eigen::Index>(patch.equations.size()));
  patch.equations.for_each([&](int e, const auto& row) {
    out[e] = residual(row, corners_at(patch, displacement, row));
  });
}

}  // namespace planish
