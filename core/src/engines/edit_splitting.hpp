// SPDX-License-Identifier: MIT
/// (3) and (8) in the split form (11): y = d, z = M(p + d). Each step is in closed form, but for
/// rows of kinds beside planarity, which a few steps of Newton's method project on.
#pragma once

#include <Eigen/Core>
#include <map>
#include <type_traits>
#include <vector>

#include "engines/sparse_cholesky.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// The Splitting of run_alm() for an edit on a patch. M centres the corners of a block: a face, or
/// a row of another kind than planarity. For faces of more than kLargeFace corners it subtracts the
/// last corner as in (9), which keeps MᵀM sparse.
class EditSplitting {
 public:
  static constexpr int kLargeFace = 32;

  /// Keeps a reference to `patch`; its displacement is the start point.
  explicit EditSplitting(Patch& patch);

  [[nodiscard]] bool set_penalty(double penalty);
  void update_auxiliaries();
  void update_primal();
  [[nodiscard]] double dual_residual() const { return dual_residual_; }
  [[nodiscard]] double update_multipliers();
  [[nodiscard]] double objective() const;

  /// Free vertices with y_i ≠ 0, local numbers. [ALM-6]
  [[nodiscard]] std::vector<int> support() const;
  [[nodiscard]] int factorizations() const { return static_cast<int>(factors_.size()); }

 private:
  template <class Visit>
  void for_each_row_beside_planarity(const Visit& visit) const {
    ConstraintKinds::for_each([&](auto tag) {
      using Kind = typename decltype(tag)::type;
      if constexpr (!std::is_same_v<Kind, PlanarPolygon>) {
        for (const auto& row : patch_.equations.of<Kind>()) visit(row);
      }
    });
  }

  void add_row_blocks();
  [[nodiscard]] RaggedRows graph() const;
  void assemble(double penalty, SparseCholesky& factor) const;
  void apply_map(const Positions& displacement, Positions& out) const;
  void add_transposed_map(const Positions& corners, Positions& out) const;
  void shrink_vertices();
  void project_faces();
  void project_rows();
  [[nodiscard]] bool is_large(int block) const {
    return static_cast<int>(blocks_[block].size()) > kLargeFace;
  }

  Patch& patch_;
  RaggedRows blocks_;  ///< local vertices: the patch's faces, then rows of other kinds
  std::map<double, SparseCholesky> factors_;  ///< by penalty, each made once (Sec. 3.5)
  SparseCholesky analysed_;
  SparseCholesky* factor_ = nullptr;
  double penalty_ = 0.0;
  double rows_ = 1.0;
  Positions halo_fairness_;     ///< −ω_f Eᵀ E (halo part), 3 × free
  Positions mapped_;            ///< M(p + d), 3 × corners
  Positions y_, y_multiplier_;  ///< 3 × free
  Positions z_, z_multiplier_;  ///< 3 × corners
  Positions right_, previous_, change_, corner_work_;
  std::vector<Eigen::Vector3d> normals_;  ///< last normals, a start for the next projection
  double dual_residual_ = 0.0;
};

}  // namespace planish
