// SPDX-License-Identifier: MIT
#include "edit/edit_verdict.hpp"

#include <algorithm>
#include <utility>

#include "planish/measures/panel_health.hpp"
#include "planish/problem/mesh_standing.hpp"

namespace planish {

std::function<Eigen::Vector3d(int)> EditVerdict::places(const ExactDesign& design) const {
  return [&design, &points = model_.points](int v) -> Eigen::Vector3d {
    const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), v);
    if (found == design.vertices.end() || *found != v) return points.col(v);
    return points.col(v) + design.displacement.col(found - design.vertices.begin());
  };
}

/// Whether panels keep their shape by the verdict that reports give.
bool EditVerdict::keeps_shape(const ExactDesign& design) const {
  const Mesh& base = model_.mesh;
  Positions before;
  Positions after;
  std::vector<int> outline;
  return std::all_of(design.faces.begin(), design.faces.end(), [&](int f) {
    const auto face = base.face(f);
    before = base.positions(Eigen::all, std::vector<int>(face.begin(), face.end()));
    after = before;
    outline.resize(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      outline[k] = static_cast<int>(k);
      const auto found = std::lower_bound(design.vertices.begin(), design.vertices.end(), face[k]);
      if (found == design.vertices.end() || *found != face[k]) continue;
      after.col(outline[k]) = design.positions.col(found - design.vertices.begin());
    }
    return panel_damage(before, after, outline) == PanelDamage::kNone;
  });
}

bool EditVerdict::keeps_limits(const ExactDesign& design) const {
  const auto standing = limit_standing(*bounds_.limits, design.faces, places(design));
  return std::all_of(standing.begin(), standing.end(),
                     [](const LimitStanding& one) { return one.least_share >= 0.0; });
}

/// Whether points are on their supports, to a billionth of the mean edge: a hard handle may have
/// been sent off its support.
bool EditVerdict::keeps_supports(const ExactDesign& design) const {
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    const Eigen::Vector3d d = design.displacement.col(static_cast<Eigen::Index>(k));
    if (!bounds_.slides->holds(design.vertices[k], d)) return false;
  }
  return true;
}

bool EditVerdict::is_exact(const ExactDesign& design) const {
  if (!design.positions.allFinite()) return false;
  bool exact = true;
  kept_.for_each([&](auto, std::size_t kind) {
    const double bound = std::max(kept_.tolerance(kind), base_.worst(kind).excess);
    exact = exact && design.worst[kind].excess <= bound;
  });
  return exact;
}

bool EditVerdict::is_acceptable(const ExactDesign& design) const {
  return is_exact(design) && (!bounds_.keep_shape || keeps_shape(design)) &&
         (bounds_.limits == nullptr || keeps_limits(design)) &&
         (bounds_.slides == nullptr || keeps_supports(design));
}

/// The worst of each kept kind over the whole mesh, with the design in place.
Violations EditVerdict::violations_with(const ExactDesign& design) const {
  Violations worst = design.worst;
  kept_.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    worst[kind].raise_to(base_.worst_outside(kind, design.touched(Kind::kElement)));
  });
  return worst;
}

SolveStatus EditVerdict::downgrade_if_base_violates(SolveStatus status,
                                                    const ExactDesign& design) const {
  return is_within(violations_with(design), kept_) ? status : SolveStatus::kToleranceNotMet;
}

void EditVerdict::add_to(SolveReport& report, const ExactDesign& design) const {
  const Violations after = violations_with(design);
  Violations before{};
  for (std::size_t kind = 0; kind < before.size(); ++kind) before[kind] = base_.worst(kind);
  report.violations = kind_violations(kept_, before, after);
  report.planarity_before = report.violations.front().before_max;
  report.planarity_after = report.violations.front().after_max;
  if (bounds_.limits == nullptr) return;
  for (LimitStanding& one : limit_standing(*bounds_.limits, design.faces, places(design))) {
    report.bounds.push_back({one.name, std::move(one.binding)});
  }
}

}  // namespace planish
