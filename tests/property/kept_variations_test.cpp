// SPDX-License-Identifier: MIT
/// Variations of edits that keep more than planarity, kinds or stated limits: tangent to what is an
/// equation, and exact after (8). Measured without the product's code.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/exact_variation.hpp"
#include "planish/variations/slider_stops.hpp"
#include "planish/variations/subspace.hpp"
#include "support/circles.hpp"
#include "support/cones.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kTolerance = 1e-9;  ///< degrees

class KeptVariations : public ::testing::TestWithParam<const char*> {
 protected:
  KeptVariations() : base(testing::sample("dome", 17)), handle(testing::middle_vertex(base)) {
    options.constraints = {{GetParam(), kTolerance}};
    const EditTargets targets = testing::pull(base, handle, {0.0, 0.0, 0.3});
    edited = apply(base, solve_handle_edit(base, targets, options));
  }

  [[nodiscard]] Subspace family(const KeptKinds& kept) const {
    return compute_subspace(base, edited, {handle}, {.dimension = 3}, {.kinds = kept});
  }

  /// The edit with slider `k` at `value`.
  [[nodiscard]] Positions slid(const Subspace& subspace, int k, double value) const {
    return testing::varied(edited, subspace,
                           value * Eigen::VectorXd::Unit(subspace.dimension(), k));
  }

  [[nodiscard]] double defect(const Positions& positions) const {
    return std::string(GetParam()) == "circular" ? testing::inscribed_defect(base, positions)
                                                 : testing::worst_cone_defect(base, positions);
  }

  /// How the defect falls where a slider goes half as far: 1/4 along a tangent, 1/2 across.
  [[nodiscard]] double fall(const Subspace& subspace, int k) const {
    constexpr double kFar = 0.02;
    return defect(slid(subspace, k, 0.5 * kFar)) / defect(slid(subspace, k, kFar));
  }

  Mesh base;
  int handle;
  HandleEditOptions options;
  Positions edited;
};

TEST_P(KeptVariations, AreTangentToWhatTheEditKeeps) {
  ASSERT_LE(defect(edited), kTolerance);
  const Subspace kept = family(kept_kinds(options.tolerance, options.constraints));
  ASSERT_EQ(kept.dimension(), 3) << status_name(kept.report.status);
  EXPECT_LT(kept.report.tangency_error, 1e-8);
  EXPECT_LT(kept.report.orthonormality_error, 1e-8);
  for (int k = 0; k < 3; ++k) EXPECT_LT(fall(kept, k), 0.3) << "vector " << k;
  const Subspace flat = family(KeptKinds());
  ASSERT_EQ(flat.dimension(), 3);
  double worst = 0.0;
  for (int k = 0; k < 3; ++k) worst = std::max(worst, fall(flat, k));
  EXPECT_GT(worst, 0.4) << "flat panels alone would do";
}

TEST_P(KeptVariations, MadeExactKeepItAndLeaveTheRest) {
  const KeptKinds kinds = kept_kinds(options.tolerance, options.constraints);
  const Subspace subspace = family(kinds);
  ASSERT_EQ(subspace.dimension(), 3);
  for (int k = 0; k < 3; ++k) {
    Mesh shown = base;
    shown.positions = slid(subspace, k, 0.3);
    EXPECT_GT(defect(shown.positions), kTolerance);
    ProjectionOptions exact;
    exact.constraints = options.constraints;
    const ProjectionResult result = project_to_planar(shown, base.positions, exact);
    ASSERT_TRUE(result.report.usable()) << status_name(result.report.status);
    Positions after = shown.positions;
    after(Eigen::all, result.moved) = result.moved_positions;
    EXPECT_LE(defect(after), kTolerance) << "vector " << k;
    EXPECT_LE(planarity_summary(base, after).max_excess, testing::kPromise);
    EXPECT_NE(after, edited) << "the slider is lost";
    EXPECT_LT((after - shown.positions).norm(), 0.5 * (shown.positions - edited).norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, KeptVariations, ::testing::Values("circular", "conical"));

/// Of every edge that two panels share, degrees.
std::vector<double> folds_of(const Mesh& mesh, const Positions& p) {
  std::map<std::pair<int, int>, std::vector<int>> sides;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      sides[{std::min(a, b), std::max(a, b)}].push_back(f);
    }
  }
  std::vector<double> folds;
  for (const auto& [edge, faces] : sides) {
    if (faces.size() != 2) continue;
    const Eigen::Vector3d a = area_vector(p, mesh.face(faces[0])).normalized();
    const Eigen::Vector3d b = area_vector(p, mesh.face(faces[1])).normalized();
    folds.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::acos(-1.0));
  }
  return folds;
}

double most_sharpened(const Mesh& base, const Positions& after) {
  const std::vector<double> was = folds_of(base, base.positions), is = folds_of(base, after);
  double most = 0.0;
  for (std::size_t k = 0; k < was.size(); ++k) most = std::max(most, is[k] - was[k]);
  return most;
}

class LimitedVariations : public ::testing::TestWithParam<const char*> {
 protected:
  static constexpr double kGrowth = 4.0;        ///< degrees that folds may sharpen by
  static constexpr double kSlack = 0.1 + 1e-6;  ///< what a relative limit adds [LIM-2]
  /// Of each sample; 200 in all every night.
  const int settings = testing::by_night(50, 12);

  LimitedVariations() : base(testing::sample(GetParam(), 10)) {
    const int handle = testing::middle_vertex(base);
    // An edit that is at its limit all around leaves its variations no room.
    options.bounds = {{.name = "fold", .least = 0.0, .most = 0.8 * kGrowth, .relative = true}};
    edited =
        apply(base, solve_handle_edit(base, testing::pull(base, handle, {0.0, 0.0, 0.3}), options));
    options.bounds[0].most = kGrowth;
    subspace = compute_subspace(base, edited, {handle}, {.dimension = 4});
  }

  [[nodiscard]] Positions shape(const Eigen::VectorXd& values) const {
    return testing::varied(edited, subspace, values);
  }

  [[nodiscard]] Positions exact(const Positions& shown, const HandleEditOptions& keeps) const {
    const ProjectionResult result = make_exact({base, edited, shown}, keeps, 0.0, {});
    EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
    Positions after = shown;
    after(Eigen::all, result.moved) = result.moved_positions;
    return after;
  }

  Mesh base;
  HandleEditOptions options;
  Positions edited;
  Subspace subspace;
};

TEST_P(LimitedVariations, KeepTheLimitsWhereverTheSlidersStand) {
  ASSERT_GT(subspace.dimension(), 0);
  ASSERT_LE(most_sharpened(base, edited), kGrowth + kSlack);
  std::mt19937 random(7);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(subspace.dimension());
  int held_back = 0, moved = 0;
  for (int setting = 0; setting < settings; ++setting) {
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const SliderRange range =
          slider_ranges(base, edited, subspace, values)[static_cast<std::size_t>(k)];
      const double low = std::max(range.lower.value, -2.0), high = std::min(range.upper.value, 2.0);
      const double share = static_cast<double>(random() % 1000) / 1000.0;
      values[k] = low + share * (high - low);
    }
    const Positions after = exact(shape(values), options);
    EXPECT_LE(most_sharpened(base, after), kGrowth + kSlack) << "setting " << setting;
    EXPECT_LE(planarity_summary(base, after).max_excess, testing::kPromise);
    if (held_back == 0) {
      held_back += most_sharpened(base, exact(shape(values), {})) > kGrowth + kSlack ? 1 : 0;
    }
    moved += after != edited ? 1 : 0;
  }
  EXPECT_GT(held_back, 0) << "no setting would exceed the limit without it";
  EXPECT_GT(moved, 0) << "every setting came back all the way";
}

TEST_P(LimitedVariations, ThatKeepThemAlreadyAreTheSameBits) {
  ASSERT_GT(subspace.dimension(), 0);
  HandleEditOptions wide;
  wide.bounds = {{.name = "fold", .least = 0.0, .most = 40.0, .relative = true}};
  const Positions shown = shape(0.01 * Eigen::VectorXd::Ones(subspace.dimension()));
  EXPECT_TRUE(exact(shown, wide) == exact(shown, {}));
}

/// Beyond their stops the sliders show spoilt panels; what is made exact of that has none.
class FarVariations : public ::testing::TestWithParam<std::tuple<const char*, unsigned>> {
 protected:
  /// Of each sample and seed; 100 in all every night.
  const int settings = testing::by_night(10, 4);

  FarVariations() : base(testing::sample(std::get<0>(GetParam()), testing::by_night(10, 8))) {
    const int handle = testing::middle_vertex(base);
    edited = apply(base, solve_handle_edit(base, testing::pull(base, handle, {0.0, 0.0, 0.3})));
    subspace = compute_subspace(base, edited, {handle}, {.dimension = 4});
  }

  /// The edit with one slider up to four times as far as its stop, or ten where it has none.
  [[nodiscard]] Positions far(int k, double share) const {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(subspace.dimension());
    const SliderRange range =
        slider_ranges(base, edited, subspace, none)[static_cast<std::size_t>(k)];
    const double stop = share < 0.0 ? range.lower.value : range.upper.value;
    const double value = std::isfinite(stop) ? 4.0 * std::abs(share) * stop : 10.0 * share;
    return testing::varied(edited, subspace,
                           value * Eigen::VectorXd::Unit(subspace.dimension(), k));
  }

  Mesh base;
  Positions edited;
  Subspace subspace;
};

TEST_P(FarVariations, MadeExactKeepTheShapeOfPanels) {
  ASSERT_GT(subspace.dimension(), 0);
  ASSERT_EQ(testing::spoilt_count(base, edited), 0);
  std::mt19937 random(std::get<1>(GetParam()));
  int came_back = 0, stayed = 0;
  for (int setting = 0; setting < settings; ++setting) {
    const double share = static_cast<double>(random() % 1001) / 500.0 - 1.0;
    const Positions shown = far(setting % static_cast<int>(subspace.dimension()), share);
    const ProjectionResult result = make_exact({base, edited, shown}, {}, 0.0, {});
    ASSERT_TRUE(result.report.usable()) << status_name(result.report.status);
    Positions after = shown;
    after(Eigen::all, result.moved) = result.moved_positions;
    EXPECT_EQ(testing::spoilt_count(base, after), 0) << "setting " << setting;
    EXPECT_LE(planarity_summary(base, after).max_excess, testing::kPromise);
    const bool back = result.confined_because == ConfinedBecause::kSpoiltByVariation;
    (back ? came_back : stayed) += 1;
    EXPECT_EQ(back, !result.report.bounds.empty()) << "the panels are named";
  }
  RecordProperty("came_back", came_back);
  EXPECT_GT(stayed, 0);
}

INSTANTIATE_TEST_SUITE_P(Samples, FarVariations,
                         ::testing::Combine(::testing::Values("roof", "vault", "dome", "hex",
                                                              "trihex"),
                                            ::testing::Values(7U, 8U)),
                         [](const auto& each) {
                           std::string name = std::get<0>(each.param);
                           name += '_';
                           return name += std::to_string(std::get<1>(each.param));
                         });

INSTANTIATE_TEST_SUITE_P(Samples, LimitedVariations,
                         ::testing::Values("roof", "vault", "dome", "hex"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace planish
