// SPDX-License-Identifier: MIT
/// The baseline of the projection benchmark: local/global iteration with weak closeness, plain (the
/// iterates of ShapeOp and igl::shapeup) or Anderson-accelerated (as AASolver, Peng et al. 2018).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/sparse_cholesky.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::bench {

struct LocalGlobalOptions {
  double closeness = 1e-6;  ///< weight of ‖p − p⁰‖² beside the face terms' 1; mean edge 1
  int window = 0;           ///< m of Anderson acceleration; 0: plain
  double planarity = 1e-4;  ///< stop at max gap / longest edge
  int max_iterations = 20000;
  double max_seconds = 15.0;  ///< processor time
};

struct LocalGlobalRun {
  double planarity = 0.0;
  int iterations = 0;
  bool reached = false;
};

class LocalGlobal {
 public:
  explicit LocalGlobal(const Mesh& mesh, double closeness);
  [[nodiscard]] LocalGlobalRun run(const LocalGlobalOptions& options);
  [[nodiscard]] const Positions& positions() const { return positions_; }

 private:
  double project_faces(const Positions& at);
  void solve_poisson(Positions& out);
  void accelerate(int window, const Positions& mapped);
  [[nodiscard]] double worst_planarity(const Positions& at) const;

  const Mesh& mesh_;
  Positions base_, positions_, corners_;
  double closeness_;
  SparseCholesky factor_;
  std::vector<Eigen::Vector3d> normals_;
  // Anderson's history: differences of residuals and of mapped iterates, one a column.
  Eigen::MatrixXd residual_steps_, mapped_steps_;
  Eigen::VectorXd last_residual_, last_mapped_;
  int history_ = 0;
};

}  // namespace planish::bench
