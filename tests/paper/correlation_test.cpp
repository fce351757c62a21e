// SPDX-License-Identifier: MIT
/// What Sec. 2.2 and Appendix A state of the correlation ξ that (7) keeps its vectors close to the
/// edit with, held against what the product returns. Recorded as in claims_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/variations/subspace.hpp"
#include "support/record.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::record;

/// Two displacements of unit length, 3 × n.
struct Pair {
  Eigen::Matrix3Xd u, v;
};

/// Random pairs: from one vertex, where the bound is tight, to many; a third share few vertices.
std::vector<Pair> random_pairs() {
  std::vector<Pair> pairs;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Eigen::Index size = 1 + seed % 16;
    Pair pair{testing::random_points(seed, size), testing::random_points(seed + 1000, size)};
    pair.v.leftCols(seed % 3 == 0 ? size / 2 : 0).setZero();
    pair.u.normalize();
    pair.v.normalize();
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

/// An edit d̄ and one of the variations that (7) found for it, on all vertices.
struct EditAndVariation {
  Pair pair;
  double reported = 0.0;  ///< ξ(d̄, t), as the family's report has it
};

/// The edits of five samples with six variations each, at every commit of two.
std::vector<EditAndVariation> edits_and_variations() {
  std::vector<EditAndVariation> result;
  for (const std::string name : {"vault", "dome", "freeform", "trihex", "hex"}) {
    if (!testing::is_night() && name != "dome" && name != "hex") continue;
    const Mesh mesh = testing::sample(name, 16);
    const int handle = testing::middle_vertex(mesh);
    const Positions edited =
        apply(mesh, solve_handle_edit(mesh, testing::pull(mesh, handle, {0, 0, 0.6})));
    const Subspace family = compute_subspace(mesh, edited, {handle}, {.dimension = 6});
    for (Eigen::Index j = 0; j < family.dimension(); ++j) {
      EditAndVariation one;
      one.pair.u = (edited - mesh.positions).normalized();
      one.pair.v = Eigen::Matrix3Xd::Zero(3, mesh.vertex_count());
      for (std::size_t k = 0; k < family.support.size(); ++k) {
        one.pair.v.col(family.support[k]) =
            family.basis.col(j).segment<3>(3 * static_cast<Eigen::Index>(k));
      }
      one.reported = family.report.correlation[static_cast<std::size_t>(j)];
      result.push_back(std::move(one));
    }
  }
  return result;
}

/// Adds up `term` of (x, y) on the unit circle: ∮ term ds.
template <typename Term>
double around_circle(const Term& term) {
  constexpr int kSamples = 2048;
  const double step = 2.0 * std::acos(-1.0) / kSamples;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    sum += step * term(std::cos((k + 0.5) * step), std::sin((k + 0.5) * step));
  }
  return sum;
}

/// ‖x u_i‖ + ‖y v_i‖ and ‖x u_i + y v_i‖ of each vertex.
struct Lengths {
  Eigen::RowVectorXd apart, together;
};

Lengths lengths(const Pair& pair, double x, double y) {
  return {(x * pair.u).colwise().norm() + (y * pair.v).colwise().norm(),
          (x * pair.u + y * pair.v).colwise().norm()};
}

/// D(u, v) and the c of Proposition 1.
struct PropositionTerms {
  double gap = 0.0, factor = 0.0;
};

PropositionTerms proposition_terms(const Pair& pair) {
  double largest = 0.0;
  const double gap = around_circle([&](double x, double y) {
    const auto [apart, together] = lengths(pair, x, y);
    largest = std::max(largest, (apart + together).maxCoeff());
    return (apart - together).sum();
  });
  return {gap, 4.0 / largest};
}

TEST(PaperClaim, PropositionOneBoundsTheGap) {
  std::vector<Pair> pairs = random_pairs();
  record("random_pairs", static_cast<double>(pairs.size()));
  for (EditAndVariation& one : edits_and_variations()) pairs.push_back(std::move(one.pair));
  double tightest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const PropositionTerms terms = proposition_terms(pairs[k]);
    const double bound = terms.factor * correlation(pairs[k].u, pairs[k].v);
    EXPECT_GT(bound, 0.0) << "pair " << k;
    EXPECT_GE(terms.gap, bound * (1.0 - 1e-5)) << "pair " << k;
    tightest = std::min(tightest, terms.gap / bound);
  }
  record("pairs", static_cast<double>(pairs.size()));
  record("smallest_gap_over_bound", tightest);
}

TEST(PaperClaim, GapVanishesExactlyWithTheCorrelation) {
  double disjoint = 0.0;
  double touching = std::numeric_limits<double>::infinity();
  for (unsigned seed = 0; seed < 50; ++seed) {
    Pair pair{testing::random_points(seed, 12), testing::random_points(seed + 1000, 12)};
    pair.u.rightCols(6).setZero();
    pair.v.leftCols(6).setZero();
    pair.u.normalize();
    pair.v.normalize();
    EXPECT_EQ(correlation(pair.u, pair.v), 0.0);
    disjoint = std::max(disjoint, std::abs(proposition_terms(pair).gap));
    pair.v.col(0) = 0.1 * pair.u.col(1);  // one shared vertex is enough
    pair.v.normalize();
    EXPECT_GT(correlation(pair.u, pair.v), 0.0);
    touching = std::min(touching, proposition_terms(pair).gap);
  }
  EXPECT_LE(disjoint, 1e-12);
  EXPECT_GT(touching, 1e-6);
  record("largest_gap_of_disjoint_pairs", disjoint);
  record("smallest_gap_of_touching_pairs", touching);
}

/// Appendix A: ‖u_i‖‖v_i‖ = ¼ ∮ [(‖x u_i‖ + ‖y v_i‖)² − ‖x u_i + y v_i‖²] ds, summed over i.
double correlation_by_appendix_a(const Pair& pair) {
  return 0.25 * around_circle([&](double x, double y) {
           const auto [apart, together] = lengths(pair, x, y);
           return apart.squaredNorm() - together.squaredNorm();
         });
}

/// The correlation that (7) keeps low and its report states is the integral.
TEST(PaperClaim, TheIdentityOfAppendixA) {
  double largest = 0.0;
  for (const Pair& pair : random_pairs()) {
    largest = std::max(
        largest, std::abs(correlation_by_appendix_a(pair) / correlation(pair.u, pair.v) - 1.0));
  }
  const std::vector<EditAndVariation> variations = edits_and_variations();
  for (const EditAndVariation& one : variations) {
    largest = std::max(largest, std::abs(correlation_by_appendix_a(one.pair) / one.reported - 1.0));
  }
  EXPECT_EQ(variations.size(), testing::is_night() ? 30U : 12U);
  EXPECT_LE(largest, 1e-5);
  record("variations", static_cast<double>(variations.size()));
  record("largest_difference", largest);
}

}  // namespace
}  // namespace planish
