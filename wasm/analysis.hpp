// SPDX-License-Identifier: MIT
/// What is measured on a finished design for its tables, legends and explanations. A module of its
/// own in the browser: nothing of it is needed to drag.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/energies.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/edit_freedom.hpp"
#include "planish/variations/subspace.hpp"

namespace planish {

/// In panel_damage(), after the last PanelDamage.
inline constexpr unsigned char kNewSliver = 5;

/// One base mesh and the design shown on it.
class Analysis {
 public:
  /// @param base as a session gave it out, so checked
  /// @param opened 3 × n, the base before it was planarised; 3 × 0 if it was not
  explicit Analysis(Mesh base, Positions opened = Positions(3, 0));

  /// The design to be measured: `moved` ascending, everything else at the base.
  void show(std::vector<int> moved, const Positions& positions);

  /// Gap (model units), mm/m and excess (mm/m) of every face, interleaved, see FacePlanarity.
  [[nodiscard]] std::vector<float> panel_figures() const;
  /// The health of every face, interleaved: outline (0 convex, 1 concave, 2 crossing), shortest
  /// edge (model units), smallest angle (degrees), and its PanelChange (0 unchanged, 1 outline, 2
  /// bevel).
  [[nodiscard]] std::vector<float> panel_health() const;
  /// How many nodes moved since the base, and how many only have another axis or arm, see
  /// nodes_to_remake().
  [[nodiscard]] std::array<int, 2> nodes_to_remake() const;
  /// What became of every face since the mesh was opened: a PanelDamage for each, or kNewSliver
  /// where it is none but became a sliver.
  [[nodiscard]] std::vector<unsigned char> panel_damage() const;
  /// The sharpest fold of every face with a neighbour, degrees, see face_folds().
  [[nodiscard]] std::vector<float> panel_folds() const;
  /// How far every face or vertex is from the kind of this name, degrees, see kind_defects(); -1
  /// where it bounds nothing. Empty for a name that is none.
  [[nodiscard]] std::vector<float> defects(const std::string& kind) const;
  /// How sharply the edit bends at each vertex, model units, see bending().
  [[nodiscard]] std::vector<float> vertex_bending(FairnessKind kind) const;
  /// A family of variations, whatever design is shown.
  /// @param moved, positions the edit that it is around
  /// @param support ascending, r vertices
  /// @param moves 3r × s: what each slider does to them at value 1, model units
  void set_family(const std::vector<int>& moved, const Positions& positions,
                  std::vector<int> support, Eigen::MatrixXd moves);
  /// The stops of each slider of the family: lower stop, the panel that makes it, upper stop, its
  /// panel; ±∞ and -1 for none, see slider_ranges(). Empty where there are not as many sliders as
  /// values.
  [[nodiscard]] std::vector<double> slider_stops(const Eigen::VectorXd& values) const;
  /// nullopt where there are too many points, see measure_freedom().
  [[nodiscard]] std::optional<EditFreedom> freedom(const EditTargets& targets) const;

 private:
  Mesh base_;
  Positions opened_;  ///< 3 × n
  Adjacency adjacency_;
  Positions current_;  ///< 3 × n
  std::vector<int> moved_;
  Positions edited_;  ///< 3 × n, the edit that family_ is around
  Subspace family_;
};

}  // namespace planish
