// SPDX-License-Identifier: MIT
#include "analysis.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "kind_defects.hpp"
#include "planish/fabrication/remake.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/variations/slider_stops.hpp"

namespace planish {

Analysis::Analysis(Mesh base, Positions opened)
    : base_(std::move(base)),
      opened_(opened.cols() > 0 ? std::move(opened) : base_.positions),
      adjacency_(build_adjacency(base_)),
      current_(base_.positions) {}

void Analysis::show(std::vector<int> moved, const Positions& positions) {
  current_ = base_.positions;
  moved_ = std::move(moved);
  current_(Eigen::all, moved_) = positions;
}

std::vector<float> Analysis::panel_figures() const {
  std::vector<float> figures;
  figures.reserve(3 * static_cast<std::size_t>(base_.face_count()));
  for (int f = 0; f < base_.face_count(); ++f) {
    const FacePlanarity face = face_planarity(current_, base_.face(f));
    figures.push_back(static_cast<float>(face.gap));
    figures.push_back(static_cast<float>(face.mm_per_m));
    figures.push_back(static_cast<float>(face.excess));
  }
  return figures;
}

std::vector<float> Analysis::panel_health() const {
  const auto changes = panels_to_remake(base_, adjacency_, current_, moved_);
  std::vector<float> health;
  health.reserve(4 * static_cast<std::size_t>(base_.face_count()));
  for (int f = 0; f < base_.face_count(); ++f) {
    const auto face = base_.face(f);
    const PanelHealth panel = planish::panel_health(current_, face);
    health.insert(health.end(),
                  {static_cast<float>(panel.outline), static_cast<float>(panel.shortest_edge),
                   static_cast<float>(panel.smallest_angle),
                   static_cast<float>(changes[static_cast<std::size_t>(f)])});
  }
  return health;
}

std::array<int, 2> Analysis::nodes_to_remake() const {
  const auto changes = planish::nodes_to_remake(base_, adjacency_, current_, moved_);
  const auto count = [&](NodeChange change) {
    return static_cast<int>(std::count(changes.begin(), changes.end(), change));
  };
  return {count(NodeChange::kMoved), count(NodeChange::kArms)};
}

std::vector<unsigned char> Analysis::panel_damage() const {
  std::vector<unsigned char> damage;
  damage.reserve(static_cast<std::size_t>(base_.face_count()));
  for (int f = 0; f < base_.face_count(); ++f) {
    const auto face = base_.face(f);
    const bool changed = std::any_of(face.begin(), face.end(),
                                     [&](int v) { return current_.col(v) != opened_.col(v); });
    const PanelDamage here =
        changed ? planish::panel_damage(opened_, current_, face) : PanelDamage::kNone;
    const bool sliver =
        changed && here == PanelDamage::kNone && became_sliver(opened_, current_, face);
    damage.push_back(sliver ? kNewSliver : static_cast<unsigned char>(here));
  }
  return damage;
}

std::vector<float> Analysis::panel_folds() const {
  const std::vector<double> folds = face_folds(base_, current_);
  return {folds.begin(), folds.end()};
}

std::vector<float> Analysis::defects(const std::string& kind) const {
  std::vector<float> degrees;
  for (const auto& defect : kind_defects(kind, base_, adjacency_, current_)) {
    degrees.push_back(defect ? static_cast<float>(defect->measure) : -1.0F);
  }
  return degrees;
}

std::vector<float> Analysis::vertex_bending(FairnessKind kind) const {
  const Positions displacement = current_ - base_.positions;
  const auto bends = bending(fairness_operator(base_, adjacency_, kind), displacement);
  return {bends.begin(), bends.end()};
}

void Analysis::set_family(const std::vector<int>& moved, const Positions& positions,
                          std::vector<int> support, Eigen::MatrixXd moves) {
  edited_ = base_.positions;
  edited_(Eigen::all, moved) = positions;
  family_ = {};
  family_.support = std::move(support);
  family_.origin = edited_(Eigen::all, family_.support);
  family_.scale = Eigen::VectorXd::Ones(moves.cols());
  family_.basis = std::move(moves);
}

std::vector<double> Analysis::slider_stops(const Eigen::VectorXd& values) const {
  std::vector<double> stops;
  if (values.size() != family_.dimension()) return stops;
  for (const SliderRange& range : slider_ranges(base_, edited_, family_, values)) {
    stops.insert(stops.end(), {range.lower.value, static_cast<double>(range.lower.face),
                               range.upper.value, static_cast<double>(range.upper.face)});
  }
  return stops;
}

std::optional<EditFreedom> Analysis::freedom(const EditTargets& targets) const {
  std::vector<int> free = moved_;
  std::vector<Pull> pulls;
  for (const Handle& handle : targets.handles) {
    pulls.push_back({handle.vertex, handle.target - current_.col(handle.vertex)});
    free.push_back(handle.vertex);
  }
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  const auto pinned = [&](int v) {
    return std::find(targets.pins.begin(), targets.pins.end(), v) != targets.pins.end();
  };
  free.erase(std::remove_if(free.begin(), free.end(), pinned), free.end());
  return measure_freedom(base_, adjacency_, current_, free, pulls);
}

}  // namespace planish
