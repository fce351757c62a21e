// SPDX-License-Identifier: MIT
/// The matrices of patches, factored by our block Cholesky, by Eigen's and by CHOLMOD.
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#ifdef PLANISH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include "engines/coupling_graph.hpp"
#include "engines/row_jacobian.hpp"
#include "engines/sparse_cholesky.hpp"
#include "planish/numeric/index.hpp"
#include "support/scenes.hpp"

namespace planish::bench {
namespace {

constexpr double kPenalty = 1e6;  // of NewtonOptions
constexpr double kNorm = 10.0;    // ω_s / ε halfway down
constexpr double kWorstResidual = 1e-12;

struct Block {
  int row = 0, column = 0;  ///< nodes
  Eigen::Matrix3d values;
};

/// μ JᵀJ + ω_f EᵀE + ω_s/ε I of a patch of `rings` rings: the pattern of PatchSystem's matrix, and
/// values like its own.
struct PatchMatrix {
  PatchMatrix(const char* sample, int size, int rings)
      : scene(testing::sample(sample, size)),
        patch(scene.cut(testing::ring_neighbourhood(
            scene.model.mesh, testing::middle_vertex(scene.model.mesh), rings))) {
    Cliques cliques;
    RowJacobian jacobian;
    jacobian.attach(patch);
    for (int v = 0; v < patch.free_count; ++v) {
      blocks.push_back({v, v, kNorm * Eigen::Matrix3d::Identity()});
    }
    patch.equations.for_each([&]<class Row>(int, const Row& row) {
      cliques.add(row.vertices);
      const auto g = gradient(row, corners(patch, row));
      for (Eigen::Index k = 0; k < g.cols(); ++k) {
        for (Eigen::Index l = 0; l < g.cols(); ++l) {
          add(row.vertices[at(k)], row.vertices[at(l)], kPenalty * g.col(k) * g.col(l).transpose());
        }
      }
    });
    patch.for_each_fairness_row([&](const FairnessRow& row) {
      cliques.add(row.vertices);
      for (std::size_t k = 0; k < row.vertices.size(); ++k) {
        for (std::size_t l = 0; l < row.vertices.size(); ++l) {
          add(row.vertices[k], row.vertices[l],
              row.weights[k] * row.weights[l] * Eigen::Matrix3d::Identity());
        }
      }
    });
    graph = cliques.graph(patch.free_count);
  }

  /// The same block is added several times, as rows add it.
  void add(int row, int column, const Eigen::Matrix3d& values) {
    if (row < patch.free_count && column < patch.free_count) {
      blocks.push_back({row, column, values});
    }
  }

  testing::ProblemOnMesh scene;
  Patch patch;
  RaggedRows graph;
  std::vector<Block> blocks;
};

/// Ours: blocks are added where the factor overwrites them.
class Ours {
 public:
  void analyze(const PatchMatrix& matrix) {
    factor_.analyze(matrix.graph, 3);
    places_.clear();
    for (const Block& block : matrix.blocks) {
      const bool stored = factor_.position(block.row) >= factor_.position(block.column);
      places_.push_back(stored ? factor_.slot(block.row, block.column) : BlockSlot{});
    }
  }
  void write(const PatchMatrix& matrix) {
    factor_.set_zero();
    double* const values = factor_.values().data();
    for (std::size_t b = 0; b < places_.size(); ++b) {
      const BlockSlot& place = places_[b];
      if (place.offset < 0) continue;
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
          values[place.offset + r + c * place.stride] += matrix.blocks[b].values(r, c);
        }
      }
    }
  }
  bool factorize() { return factor_.factorize(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) {
    Eigen::VectorXd x = right;
    factor_.solve(x);
    return x;
  }
  [[nodiscard]] double factor_entries() const { return static_cast<double>(factor_.factor_size()); }

 private:
  SparseCholesky factor_;
  std::vector<BlockSlot> places_;
};

/// Any of Eigen's solvers of the lower triangle, entry by entry.
template <class Solver>
class Scalar {
 public:
  void analyze(const PatchMatrix& matrix) {
    std::vector<Eigen::Triplet<double>> entries;
    for_each_entry(matrix, [&](int r, int c, double x) { entries.emplace_back(r, c, x); });
    const Eigen::Index size = 3 * matrix.patch.free_count;
    lower_.resize(size, size);
    lower_.setFromTriplets(entries.begin(), entries.end());
    places_.clear();
    for_each_entry(matrix, [&](int r, int c, double) {
      places_.push_back(&lower_.coeffRef(r, c) - lower_.valuePtr());
    });
    solver_->analyzePattern(lower_);
  }
  void write(const PatchMatrix& matrix) {
    lower_.coeffs().setZero();
    const std::ptrdiff_t* place = places_.data();
    for_each_entry(matrix, [&](int, int, double x) { lower_.valuePtr()[*place++] += x; });
  }
  bool factorize() {
    solver_->factorize(lower_);
    return solver_->info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) { return solver_->solve(right); }
  [[nodiscard]] double factor_entries() const {
    if constexpr (requires(const Solver& s) { s.matrixL(); }) {
      return static_cast<double>(solver_->matrixL().nestedExpression().nonZeros());
    } else {
      return 0.0;
    }
  }

 private:
  template <class Visit>
  static void for_each_entry(const PatchMatrix& matrix, const Visit& visit) {
    for (const Block& block : matrix.blocks) {
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
          const int row = 3 * block.row + r, column = 3 * block.column + c;
          if (row >= column) visit(row, column, block.values(r, c));
        }
      }
    }
  }

  Eigen::SparseMatrix<double> lower_;
  std::vector<std::ptrdiff_t> places_;
  std::unique_ptr<Solver> solver_ = std::make_unique<Solver>();
};

/// ‖A x − b‖ / (‖A‖ ‖x‖ + ‖b‖), A by its blocks.
double backward_error(const PatchMatrix& matrix, const Eigen::VectorXd& x,
                      const Eigen::VectorXd& right) {
  Eigen::VectorXd rest = -right;
  double squares = 0.0;
  for (const Block& block : matrix.blocks) {
    rest.segment<3>(3 * block.row) += block.values * x.segment<3>(3 * block.column);
    squares += block.values.squaredNorm();
  }
  return rest.norm() / (std::sqrt(squares) * x.norm() + right.norm());
}

/// kFactorize writes the values first: ours overwrites them.
enum class Step { kAnalyze, kWrite, kFactorize, kSolve };

template <class Solver>
void run(benchmark::State& state, const PatchMatrix& matrix, Step step) {
  Solver solver;
  solver.analyze(matrix);
  solver.write(matrix);
  const bool positive = solver.factorize();
  const Eigen::VectorXd right = testing::random_vector(1, 3 * matrix.patch.free_count);
  Eigen::VectorXd x = solver.solve(right);
  if (!positive || !(backward_error(matrix, x, right) <= kWorstResidual)) {
    state.SkipWithError("the system was not solved");
    return;
  }
  for (auto _ : state) {
    if (step == Step::kAnalyze) solver.analyze(matrix);
    if (step == Step::kWrite || step == Step::kFactorize) solver.write(matrix);
    if (step == Step::kFactorize) benchmark::DoNotOptimize(solver.factorize());
    if (step == Step::kSolve) benchmark::DoNotOptimize(x = solver.solve(right));
  }
  state.counters["vertices"] = matrix.patch.free_count;
  state.counters["factor_entries"] = solver.factor_entries();
}

template <class Solver>
void enlist(const std::string& scene, const char* solver,
            const std::shared_ptr<PatchMatrix>& matrix) {
  for (const auto& [step, name] : {std::pair{Step::kAnalyze, "analyze"},
                                   {Step::kWrite, "write"},
                                   {Step::kFactorize, "factorize"},
                                   {Step::kSolve, "solve"}}) {
    benchmark::RegisterBenchmark(
        ("Cholesky/" + scene + "/" + solver + "/" + name).c_str(),
        [matrix, step = step](benchmark::State& state) { run<Solver>(state, *matrix, step); })
        ->Unit(benchmark::kMillisecond);
  }
}

const bool kRegistered = [] {
  using Matrix = Eigen::SparseMatrix<double>;
  for (const auto& [sample, size] : {std::pair{"dome", 64}, {"hex", 40}}) {
    for (const int rings : {2, 5, 10, 20}) {
      const auto matrix = std::make_shared<PatchMatrix>(sample, size, rings);
      const std::string scene = std::string(sample) + "/" + std::to_string(rings);
      enlist<Ours>(scene, "planish", matrix);
      enlist<Scalar<Eigen::SimplicialLLT<Matrix>>>(scene, "simplicial", matrix);
#ifdef PLANISH_CHOLMOD
      enlist<Scalar<Eigen::CholmodSimplicialLLT<Matrix>>>(scene, "cholmod_simplicial", matrix);
      enlist<Scalar<Eigen::CholmodSupernodalLLT<Matrix>>>(scene, "cholmod_supernodal", matrix);
#endif
    }
  }
  return true;
}();

}  // namespace
}  // namespace planish::bench
