// SPDX-License-Identifier: MIT
#include "engines/displacement_field.hpp"

#include <algorithm>
#include <map>

#include "planish/numeric/index.hpp"

namespace planish {
DisplacementField::DisplacementField(int vertex_count, int equation_count)
    : displacement_(Eigen::Matrix3Xd::Zero(3, vertex_count)),
      norm_dual_(Eigen::Matrix3Xd::Zero(3, vertex_count)),
      multipliers_(Eigen::VectorXd::Zero(equation_count)),
      vertex_touched_(at(vertex_count), 0),
      equation_touched_(at(equation_count), 0) {}

void DisplacementField::touch_vertex(int vertex) {
  if (vertex_touched_[at(vertex)]) return;
  vertex_touched_[at(vertex)] = 1;
  vertices_.push_back(vertex);
}

void DisplacementField::touch_equation(int equation) {
  if (equation >= multipliers_.size()) make_room(equation);
  if (equation_touched_[at(equation)]) return;
  equation_touched_[at(equation)] = 1;
  equations_.push_back(equation);
}

/// Makes room for the multipliers of surface rows and of limits: few problems have any.
void DisplacementField::make_room(int equation) {
  const Eigen::Index before = multipliers_.size();
  multipliers_.conservativeResize(std::max<Eigen::Index>(equation + 1, 2 * before));
  multipliers_.tail(multipliers_.size() - before).setZero();
  equation_touched_.resize(static_cast<std::size_t>(multipliers_.size()), 0);
}

double DisplacementField::multiplier(int equation) const {
  return equation < multipliers_.size() ? multipliers_[equation] : 0.0;
}

void DisplacementField::clear() {
  for (const int v : vertices_) {
    reset_vertex(v);
    vertex_touched_[at(v)] = 0;
  }
  for (const int e : equations_) {
    multipliers_[e] = 0.0;
    equation_touched_[at(e)] = 0;
  }
  vertices_.clear();
  equations_.clear();
}

void DisplacementField::load(const Patch& patch, PatchState& state) const {
  state.displacement.resize(3, patch.free_count);
  state.norm_dual.resize(3, patch.free_count);
  state.multipliers.resize(static_cast<Eigen::Index>(patch.equations.size()));
  for (int k = 0; k < patch.free_count; ++k) {
    state.displacement.col(k) = displacement_.col(patch.vertices[at(k)]);
    state.norm_dual.col(k) = norm_dual_.col(patch.vertices[at(k)]);
  }
  put_on_tracks(patch, state.displacement);  // they may be new
  for (std::size_t e = 0; e < patch.equation_ids.size(); ++e) {
    const int id = patch.equation_ids[e];
    state.multipliers[static_cast<Eigen::Index>(e)] = multiplier(id);
  }
  state.limit_multipliers.resize(static_cast<Eigen::Index>(patch.inequality_ids.size()));
  for (std::size_t e = 0; e < patch.inequality_ids.size(); ++e) {
    const int id = patch.inequality_ids[e];
    state.limit_multipliers[static_cast<Eigen::Index>(e)] = id < 0 ? 0.0 : multiplier(id);
  }
}

void DisplacementField::store(const Patch& patch, const PatchState& state) {
  for (int k = 0; k < patch.free_count; ++k) {
    const int v = patch.vertices[at(k)];
    touch_vertex(v);
    displacement_.col(v) = state.displacement.col(k);
    norm_dual_.col(v) = state.norm_dual.col(k);
  }
  for (std::size_t e = 0; e < patch.equation_ids.size(); ++e) {
    touch_equation(patch.equation_ids[e]);
    multipliers_[patch.equation_ids[e]] = state.multipliers[static_cast<Eigen::Index>(e)];
  }
  for (std::size_t e = 0; e < patch.inequality_ids.size(); ++e) {
    const int id = patch.inequality_ids[e];
    const double pressure = state.limit_multipliers[static_cast<Eigen::Index>(e)];
    if (id < 0 || (pressure == 0.0 && multiplier(id) == 0.0)) continue;
    touch_equation(id);
    multipliers_[id] = pressure;
  }
}

void DisplacementField::reset_vertex(int vertex) {
  displacement_.col(vertex).setZero();
  norm_dual_.col(vertex).setZero();
}

void DisplacementField::set_displacement(int vertex, const Eigen::Vector3d& value) {
  touch_vertex(vertex);
  displacement_.col(vertex) = value;
}

void DisplacementField::scale(double factor) {
  for (const int v : vertices_) displacement_.col(v) *= factor;
}

DisplacementField::Snapshot DisplacementField::snapshot() const {
  Snapshot result;
  result.vertices = vertices_;
  result.equations = equations_;
  result.displacement.resize(3, static_cast<Eigen::Index>(vertices_.size()));
  result.norm_dual.resize(3, static_cast<Eigen::Index>(vertices_.size()));
  result.multipliers.resize(static_cast<Eigen::Index>(equations_.size()));
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    result.displacement.col(static_cast<Eigen::Index>(k)) = displacement_.col(vertices_[k]);
    result.norm_dual.col(static_cast<Eigen::Index>(k)) = norm_dual_.col(vertices_[k]);
  }
  for (std::size_t k = 0; k < equations_.size(); ++k) {
    result.multipliers[static_cast<Eigen::Index>(k)] = multipliers_[equations_[k]];
  }
  return result;
}

void DisplacementField::restore(const Snapshot& snapshot) {
  clear();
  for (std::size_t k = 0; k < snapshot.vertices.size(); ++k) {
    touch_vertex(snapshot.vertices[k]);
    displacement_.col(snapshot.vertices[k]) =
        snapshot.displacement.col(static_cast<Eigen::Index>(k));
    norm_dual_.col(snapshot.vertices[k]) = snapshot.norm_dual.col(static_cast<Eigen::Index>(k));
  }
  for (std::size_t k = 0; k < snapshot.equations.size(); ++k) {
    touch_equation(snapshot.equations[k]);
    multipliers_[snapshot.equations[k]] = snapshot.multipliers[static_cast<Eigen::Index>(k)];
  }
}

double farthest_apart(const DisplacementField::Snapshot& a, const DisplacementField::Snapshot& b) {
  std::map<int, Eigen::Vector3d> apart;
  const auto add = [&](const DisplacementField::Snapshot& state, double sign) {
    for (std::size_t k = 0; k < state.vertices.size(); ++k) {
      const auto place = apart.try_emplace(state.vertices[k], Eigen::Vector3d::Zero()).first;
      place->second += sign * state.displacement.col(static_cast<Eigen::Index>(k));
    }
  };
  add(a, 1.0);
  add(b, -1.0);
  double farthest = 0.0;
  for (const auto& [vertex, difference] : apart) farthest = std::max(farthest, difference.norm());
  return farthest;
}

}  // namespace planish
