// SPDX-License-Identifier: MIT
/// J: the gradients of a patch's rows at one state, and the products with them. Rows of every kind
/// look alike here. [CON-2]
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "planish/numeric/index.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

class RowJacobian {
 public:
  /// Takes the equations' vertices; gradients are unset until evaluate() or set().
  void attach(const Patch& patch) { attach(patch, patch.equations); }
  /// Takes the vertices of another batch of the patch; gradients are zero until set().
  template <class Batches>
  void attach(const Patch& patch, const Batches& rows) {
    vertices_.offsets.assign(1, 0);
    vertices_.values.clear();
    rows.for_each([&](int, const auto& row) {
      vertices_.values.insert(vertices_.values.end(), row.vertices.begin(), row.vertices.end());
      vertices_.offsets.push_back(static_cast<int>(vertices_.values.size()));
    });
    find_slides(patch);
  }

  /// ∇c of every row at points + displacement. @param displacement 3 × free
  void evaluate(const Patch& patch, const Eigen::Matrix3Xd& displacement);

  /// ∇c of one row, 3 × its vertices. After the last one: slide().
  template <class Gradient>
  void set(int row, const Gradient& gradient) {
    gradients_.middleCols(vertices_.offsets[at(row)], gradient.cols()) = gradient;
  }

  /// What set() brought, only along what vertices with supports may do: J P. [SUP-2]
  void slide();

  [[nodiscard]] int size() const { return vertices_.size(); }
  /// Local vertices of a row.
  [[nodiscard]] std::span<const int> vertices(int row) const { return vertices_[row]; }
  /// out = J δ. @param delta 3 × free
  void apply(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const;

  /// out += Jᵀ y. @param out 3 × free
  void add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& out) const;

  /// ∇c · δ of one row. @param delta 3 × free
  [[nodiscard]] double apply(int row, const Eigen::Matrix3Xd& delta) const;
  /// ∇c of one row over the free vertices: 3 × free.
  [[nodiscard]] Eigen::Matrix3Xd transposed(int row) const;

  /// `start` + ⟨∇c, ∇c'⟩ of two rows over the free vertices they share: an entry of ρI + J Jᵀ.
  [[nodiscard]] double product(int row, int other, double start = 0.0) const;

 private:
  void find_slides(const Patch& patch);

  RaggedRows vertices_;
  Eigen::Matrix3Xd gradients_;  ///< 3 × |vertices_.values|
  /// Where the gradients of a vertex with supports stand.
  struct SlideEntry {
    Eigen::Index column;
    Eigen::Matrix3d along;
  };
  std::vector<SlideEntry> slide_entries_;
  int free_count_ = 0;
};

}  // namespace planish
