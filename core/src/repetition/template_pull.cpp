// SPDX-License-Identifier: MIT
#include "repetition/template_pull.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

#include "engines/coupling_graph.hpp"
#include "planish/fabrication/flat_panel.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kFlat = 1000.0;      ///< weight of what is out of a panel's plane
constexpr double kLimit = 1.0;        ///< weight of a limit's share, squared, below ...
constexpr double kWithin = 0.02;      ///< ... this
constexpr double kStay = 1e-4;        ///< weight of the displacements themselves
constexpr double kHeldBack = 1.0;     ///< weight of a displacement that is held back ...
constexpr double kStaysMore = 10.0;   ///< ... and, said again, so many times that
constexpr double kWall = 10.0;        ///< weight of what is beyond the farthest move
constexpr double kBeforeWall = 0.98;  ///< of it: where the wall begins
constexpr double kLongestStep = 0.5;  ///< mean edges
constexpr double kNoStep = 1e-4;      ///< mean edges

/// Calls visit(row) for the rows of `face`, of those that it shares where it is the first.
template <class Visit>
void for_each_own_row(const MeshLimits& limits, int face, const Visit& visit) {
  limits.for_each_row(face, [&](auto, const auto& row, int other, int) {
    if (other < 0 || face < other) visit(row);
  });
}

RaggedRows coupled_vertices(const Mesh& mesh, const MeshLimits& limits) {
  Cliques cliques;
  for (int f = 0; f < mesh.face_count(); ++f) {
    cliques.add(mesh.face(f));
    for_each_own_row(limits, f, [&](const auto& row) { cliques.add(row.vertices); });
  }
  return cliques.graph(mesh.vertex_count());
}

/// The way from each corner of the goal, laid where it fits `outline` best, to the outline's.
Eigen::Matrix2Xd off_goal(const Outline& outline, const FamilyShape& goal) {
  const Outline to = outline.colwise() - Eigen::Vector2d(outline.rowwise().mean());
  const FamilyShape from = goal.colwise() - Eigen::Vector2d(goal.rowwise().mean());
  double along = 0.0, across = 0.0;
  for (Eigen::Index k = 0; k < to.cols(); ++k) {
    along += from(0, k) * to(0, k) + from(1, k) * to(1, k);
    across += from(0, k) * to(1, k) - from(1, k) * to(0, k);
  }
  const double length = std::sqrt(along * along + across * across);
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  if (length > 0.0) turn << along / length, -across / length, across / length, along / length;
  return to - turn * from;
}

/// What is left of moves of corners in their plane once the panel as a whole has followed them.
Eigen::MatrixXd rigid_free_in_plane(const Outline& centred) {
  const Eigen::Index k = centred.cols();
  Eigen::VectorXd spin(2 * k);
  Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(2 * k, 2 * k);
  for (Eigen::Index i = 0; i < k; ++i) {
    spin.segment<2>(2 * i) << -centred(1, i), centred(0, i);
    for (Eigen::Index j = 0; j < k; ++j) {
      rest.block<2, 2>(2 * i, 2 * j) -= Eigen::Matrix2d::Identity() / static_cast<double>(k);
    }
  }
  const double square = spin.squaredNorm();
  if (square > 0.0) rest -= spin * spin.transpose() / square;
  return rest;
}

/// What is left of moves out of the plane once the panel follows them by tilting.
Eigen::MatrixXd rigid_free_out_of_plane(const Outline& centred) {
  const Eigen::Index k = centred.cols();
  Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(k, k);
  rest.array() -= 1.0 / static_cast<double>(k);
  const Eigen::Matrix2d spread = centred * centred.transpose();
  if (spread.determinant() > 0.0) {
    rest -= centred.transpose() * spread.inverse() * centred;
  }
  return rest;
}

}  // namespace

TemplatePull::TemplatePull(const Mesh& base, const std::vector<int>& pins, double farthest,
                           const MeshLimits& limits, VertexSlides* slides)
    : base_(base),
      farthest_(farthest),
      limits_(limits),
      slides_(slides),
      ways_(at(base.vertex_count()), Eigen::Matrix3d::Identity()),
      stays_(at(base.vertex_count()), kStay) {
  for (const int v : pins) ways_[at(v)].setZero();
  for (int v = 0; v < base.vertex_count(); ++v) {
    if (!ways_[at(v)].isZero(0.0)) movable_.push_back(v);
  }
  cholesky_.analyze(coupled_vertices(base, limits), 3);
}

void TemplatePull::add_block(int row, int column, const Eigen::Matrix3d& block) {
  if (cholesky_.position(row) < cholesky_.position(column)) return;
  const BlockSlot slot = cholesky_.slot(row, column);
  double* values = cholesky_.values().data() + slot.offset;
  for (Eigen::Index c = 0; c < 3; ++c) {
    for (Eigen::Index r = 0; r < 3; ++r) values[r + c * slot.stride] += block(r, c);
  }
}

void TemplatePull::add_panel(const Positions& positions, int f, const PanelGoal& goal) {
  const auto face = base_.face(f);
  const FlatPanel panel = flatten_panel(positions, face, longest_side(positions, face));
  const auto k = static_cast<Eigen::Index>(face.size());
  const Outline centred = panel.outline.colwise() - Eigen::Vector2d(panel.outline.rowwise().mean());
  const Eigen::Matrix2Xd off = off_goal(panel.outline, goal.corners);
  const Eigen::MatrixXd in_plane = goal.weight * rigid_free_in_plane(centred);
  const Eigen::MatrixXd out_of_plane = kFlat * rigid_free_out_of_plane(centred);
  const Eigen::Map<const Eigen::VectorXd> heights(panel.off_plane.data(), k);
  const Eigen::VectorXd lift = out_of_plane * heights;
  Eigen::Matrix<double, 3, 2> axes;
  axes << panel.frame.x, panel.frame.y;
  const Eigen::Matrix3d up = panel.frame.normal * panel.frame.normal.transpose();
  for (Eigen::Index i = 0; i < k; ++i) {
    const int v = face[at(i)];
    gradient_.segment<3>(3 * v) +=
        ways_[at(v)] * (goal.weight * axes * off.col(i) + lift(i) * panel.frame.normal);
    for (Eigen::Index j = 0; j < k; ++j) {
      const int w = face[at(j)];
      const Eigen::Matrix3d block =
          axes * in_plane.block<2, 2>(2 * i, 2 * j) * axes.transpose() + out_of_plane(i, j) * up;
      add_block(v, w, ways_[at(v)] * block * ways_[at(w)]);
    }
  }
}

void TemplatePull::hold_back(int vertex) {
  double& stay = stays_[at(vertex)];
  stay = stay < kHeldBack ? kHeldBack : kStaysMore * stay;
}

/// Adds the limits that are beyond their bound, or nearly: w ∇s ∇sᵀ and w (s − s₀) ∇s.
void TemplatePull::add_limits(const Positions& positions, int f) {
  for_each_own_row(limits_, f, [&]<class Row>(const Row& row) {
    const auto k = static_cast<Eigen::Index>(row.vertices.size());
    const auto points =
        placed_points(row, [&](int v) -> Eigen::Vector3d { return positions.col(v); });
    const double off = row.scale.share(value(row, points)) - kWithin;
    if (!(off < 0.0)) return;
    const RowPoints<Row::kArity> slope = row.scale.slope * gradient(row, points);
    for (Eigen::Index i = 0; i < k; ++i) {
      const int v = row.vertices[at(i)];
      const Eigen::Vector3d here = ways_[at(v)] * slope.col(i);
      gradient_.segment<3>(3 * v) += kLimit * off * here;
      for (Eigen::Index j = 0; j < k; ++j) {
        const int w = row.vertices[at(j)];
        add_block(v, w, kLimit * here * (ways_[at(w)] * slope.col(j)).transpose());
      }
    }
  });
}

/// Adds the pull of a vertex back to where it began, and the wall; where it may not go, the
/// identity.
void TemplatePull::add_vertex(int v, const Eigen::Vector3d& moved) {
  const Eigen::Matrix3d& way = ways_[at(v)];
  Eigen::Vector3d pull = stays_[at(v)] * moved;
  Eigen::Matrix3d block = stays_[at(v)] * Eigen::Matrix3d::Identity();
  const double distance = std::sqrt(moved.squaredNorm()), wall = kBeforeWall * farthest_;
  if (distance > wall) {
    const Eigen::Vector3d out = moved / distance;
    const Eigen::Matrix3d radial = out * out.transpose();
    pull += kWall * (distance - wall) * out;
    block += kWall * (radial + (1.0 - wall / distance) * (Eigen::Matrix3d::Identity() - radial));
  }
  gradient_.segment<3>(3 * v) += way * pull;
  add_block(v, v, way * block * way + Eigen::Matrix3d::Identity() - way);
}

/// Every point where its supports let it be that is nearest, and its way from there.
void TemplatePull::keep_to_supports(Eigen::Matrix3Xd& displacement) {
  if (slides_ == nullptr) return;
  for (const int v : movable_) displacement.col(v) = slides_->nearest(v, displacement.col(v));
  slides_->follow(movable_, displacement(Eigen::all, movable_));
  for (const int v : movable_) {
    const SlideTrack* track = slides_->track(v);
    if (track != nullptr) ways_[at(v)] = track->along;
  }
}

/// @returns the longest way of a vertex; 0 where there is no step
double TemplatePull::step(const std::vector<PanelGoal>& goals, Eigen::Matrix3Xd& displacement) {
  const Positions positions = base_.positions + displacement;
  cholesky_.set_zero();
  gradient_.setZero(3 * base_.vertex_count());
  for (int f = 0; f < base_.face_count(); ++f) {
    add_panel(positions, f, goals[at(f)]);
    add_limits(positions, f);
  }
  for (int v = 0; v < base_.vertex_count(); ++v) add_vertex(v, displacement.col(v));
  if (!cholesky_.factorize()) return 0.0;
  cholesky_.solve(gradient_);
  const Eigen::Map<const Eigen::Matrix3Xd> moves(gradient_.data(), 3, base_.vertex_count());
  const double longest = std::sqrt(moves.colwise().squaredNorm().maxCoeff());
  if (!std::isfinite(longest)) return 0.0;
  const double share = longest > kLongestStep ? kLongestStep / longest : 1.0;
  for (const int v : movable_) displacement.col(v) -= share * moves.col(v);
  return longest;
}

int TemplatePull::pull(const std::vector<PanelGoal>& goals, int steps,
                       Eigen::Matrix3Xd& displacement) {
  keep_to_supports(displacement);
  for (int made = 0; made < steps; ++made) {
    const double longest = step(goals, displacement);
    keep_to_supports(displacement);
    if (longest < kNoStep) return made + 1;
  }
  return steps;
}

}  // namespace planish
