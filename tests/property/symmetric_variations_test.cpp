// SPDX-License-Identifier: MIT
/// Variations of edits under a symmetry: they have it, too.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

#include "planish/edit/kept_by_variations.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/variations/exact_variation.hpp"
#include "planish/variations/subspace.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kSymmetricShape = 1e-9;  ///< mean edges

struct SymmetricScene {
  const char* sample;
  int size;
  int handle;
  const char* symmetry;
  std::size_t images;
};

class SymmetricVariations : public ::testing::TestWithParam<SymmetricScene> {
 protected:
  SymmetricVariations() : base(testing::sample(GetParam().sample, GetParam().size)) {
    auto found = find_symmetry(base, *parse_symmetry(GetParam().symmetry));
    symmetry = std::make_shared<const MeshSymmetry>(std::get<MeshSymmetry>(std::move(found)));
    const EditTargets one = testing::pull(base, GetParam().handle, {0.05, 0.02, 0.4});
    targets = std::get<EditTargets>(with_images(one, base, *symmetry));
    HandleEditSolver solver(base, {});
    edited = apply(base, solver.solve_symmetric(targets, *symmetry));
    family = compute_subspace(base, edited, {}, {.dimension = 3}, keeps());
  }

  [[nodiscard]] KeptByVariations keeps() const {
    return kept_by_variations(base, targets, {}, symmetry);
  }
  [[nodiscard]] Positions slid(double share) const {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(family.dimension());
    for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = share * (k % 2 == 0 ? 1.0 : -0.7);
    return testing::varied(edited, family, values);
  }

  Mesh base;
  std::shared_ptr<const MeshSymmetry> symmetry;
  EditTargets targets;
  Positions edited;
  Subspace family;
};

TEST_P(SymmetricVariations, HaveTheSymmetryOfTheirEdit) {
  ASSERT_EQ(symmetry->operations.size(), GetParam().images);
  ASSERT_EQ(family.dimension(), 3);
  EXPECT_LE(asymmetry(*symmetry, base, edited), kSymmetricShape);
  for (const double share : {-1.0, 0.3, 2.0}) {
    const Positions shown = slid(share);
    EXPECT_NE(shown, edited);
    EXPECT_LE(asymmetry(*symmetry, base, shown), kSymmetricShape) << share;
  }
}

/// Of the whole problem, not of its symmetric part alone.
TEST_P(SymmetricVariations, AreFirstOrderPoints) {
  EXPECT_EQ(family.report.status, SolveStatus::kConverged);
  for (const Optimality& one : family.report.certificates) EXPECT_TRUE(one.met());
  EXPECT_LE(family.report.tangency_error, 1e-10);
  EXPECT_LE(family.report.orthonormality_error, 1e-10);
}

TEST_P(SymmetricVariations, AreFlatAndSymmetricOnceMadeExact) {
  for (const double share : {0.5, -1.0}) {
    const Positions shown = slid(share);
    const ProjectionResult result = make_exact({base, edited, shown}, {}, 0.0, keeps());
    EXPECT_EQ(result.report.status, SolveStatus::kConverged) << share;
    Positions exact = shown;
    exact(Eigen::all, result.moved) = result.moved_positions;
    EXPECT_NE(exact, edited);
    EXPECT_LE(planarity_summary(base, exact).max, testing::kPromise);
    EXPECT_LE(asymmetry(*symmetry, base, exact), kSymmetricShape);
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SymmetricVariations,
                         ::testing::Values(SymmetricScene{"vault", 13, 20, "x", 2},
                                           SymmetricScene{"vault", 12, 65, "x", 2},
                                           SymmetricScene{"dome", 12, 30, "x", 2},
                                           SymmetricScene{"roof", 13, 48, "x", 2},
                                           SymmetricScene{"roof", 13, 48, "x,y", 4}),
                         [](const auto& of) {
                           return std::string(of.param.sample) + std::to_string(of.param.size) +
                                  "With" + std::to_string(of.param.images);
                         });

}  // namespace
}  // namespace planish
