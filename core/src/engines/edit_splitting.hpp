// SPDX-License-Identifier: MIT
/// (3) and (8) in the split form (11): y = d, z = M(p + d). Each step is in closed form, but for
/// rows of kinds beside planarity, which a few steps of Newton's method project on.
#pragma once

#include <Eigen/Core>
#include <map>
#include <type_traits>
#include <vector>

#include "engines/sparse_cholesky.hpp"
#include "planish/numeric/executor.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// The Splitting of run_alm() for an edit on a patch. M centres the corners of a block: a face, or
/// a row of another kind than planarity. For faces of more than kLargeFace corners it subtracts the
/// last corner as in (9), which keeps MᵀM sparse.
class EditSplitting {
 public:
  static constexpr int kLargeFace = 32;

  /// Keeps references to `patch`, whose displacement is the start point, and to `executor`.
  /// @param executor of the parallel steps (Sec. 3.5); the bits are the same
  explicit EditSplitting(Patch& patch, Executor* executor = nullptr);

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
  /// Calls visit(rows) for the rows of each kind.
  template <class Visit>
  void for_each_kind_beside_planarity(const Visit& visit) const {
    ConstraintKinds::for_each([&](auto tag) {
      using Kind = typename decltype(tag)::type;
      if constexpr (!std::is_same_v<Kind, PlanarPolygon>) visit(patch_.equations.of<Kind>());
    });
  }
  /// Calls visit(k) for all k < count, in parts.
  template <class Visit>
  void for_each(int count, const Visit& visit) const {
    for_each_part(executor_, count, kPart, [&](int begin, int end) {
      for (int k = begin; k < end; ++k) visit(k);
    });
  }

  void add_row_blocks();
  void find_corners();
  [[nodiscard]] RaggedRows graph() const;
  void assemble(double penalty, SparseCholesky& factor) const;
  void apply_map(const Positions& displacement, int block, Positions& out) const;
  void add_transposed_map(const Positions& corners, int vertex, Positions& out) const;
  void shrink(int vertex);
  void project_face(int face);
  template <class Row>
  void project_row(const Row& row, int block);
  [[nodiscard]] bool is_large(int block) const {
    return static_cast<int>(blocks_[block].size()) > kLargeFace;
  }

  static constexpr int kPart = 256;  ///< vertices or blocks that are worth a task

  Patch& patch_;
  Executor* executor_;
  RaggedRows blocks_;          ///< local vertices: the patch's faces, then rows of other kinds
  RaggedRows corners_;         ///< of each free vertex, ascending: its places in blocks_.values
  std::vector<int> block_of_;  ///< of each place
  std::map<double, SparseCholesky> factors_;  ///< by penalty, each made once (Sec. 3.5)
  SparseCholesky analysed_;
  SparseCholesky* factor_ = nullptr;
  double penalty_ = 0.0;
  double rows_ = 1.0;
  Positions halo_fairness_;               ///< −ω_f Eᵀ E (halo part), 3 × free
  Positions halo_mapped_;                 ///< M(p + halo part), 3 × corners
  Positions mapped_;                      ///< M(p + d), 3 × corners
  Positions y_, y_multiplier_;            ///< 3 × free
  Positions z_, z_multiplier_;            ///< 3 × corners
  Positions right_, vertex_change_;       ///< work space, 3 × free
  Positions pull_, corner_change_;        ///< work space, 3 × corners
  Positions taken_;                       ///< by Mᵀ off pull_: means, or sums; 3 × blocks
  std::vector<Eigen::Vector3d> normals_;  ///< last normals, a start for the next projection
  double dual_residual_ = 0.0;
};

}  // namespace planish
