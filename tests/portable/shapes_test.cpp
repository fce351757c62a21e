// SPDX-License-Identifier: MIT
#include "planish/shapes/shapes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "planish/measures/metrics.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

TEST(Shapes, KnowsItsNamesAndRefusesTheRest) {
  EXPECT_EQ(sample_names(),
            (std::vector<std::string_view>{"roof", "vault", "dome", "freeform", "hex", "trihex"}));
  EXPECT_FALSE(make_sample("teapot", 10));
  EXPECT_FALSE(make_sample("vault", 2));
  EXPECT_FALSE(make_sample("vault", 2001));
  EXPECT_TRUE(make_sample("vault", 3));
}

/// The two public scenes of docs/math.md, computed here with the library's own sine.
TEST(Shapes, VaultAndDomeFollowTheirFormulas) {
  const Mesh vault = *make_sample("vault", 32), dome = *make_sample("dome", 32);
  const double pi = std::acos(-1.0);
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) {
      const double u = i / 31.0, v = j / 31.0;
      const double height =
          31 * (0.12 * std::sin(pi * u) + 0.10 * std::sin(pi * v) + 0.02 * std::sin(4 * pi * v));
      const double theta = 2 * u - 1, r = 31 * (0.6 + 0.25 * std::sin(2.5 * v));
      const int k = j * 32 + i;
      EXPECT_LT((vault.positions.col(k) - Eigen::Vector3d(31 * u, 31 * v, height)).norm(), 1e-13);
      EXPECT_LT((dome.positions.col(k) -
                 Eigen::Vector3d(r * std::sin(theta), r * std::cos(theta), 37.2 * v))
                    .norm(),
                1e-13);
    }
  }
  EXPECT_EQ(vault.face_count(), 961);
  EXPECT_EQ(std::vector<int>(vault.face(0).begin(), vault.face(0).end()),
            (std::vector<int>{0, 1, 33, 32}));
  EXPECT_NEAR(mean_edge_length(vault), 1.0366, 5e-5);
  EXPECT_NEAR(mean_edge_length(dome), 1.4081, 5e-5);
}

struct EdgeSpread {
  double shortest = 1e300, longest = 0.0;
};

EdgeSpread edge_spread(const Mesh& mesh) {
  EdgeSpread spread;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const double length =
          (mesh.positions.col(face[k]) - mesh.positions.col(face[(k + 1) % face.size()])).norm();
      spread.shortest = std::min(spread.shortest, length);
      spread.longest = std::max(spread.longest, length);
    }
  }
  return spread;
}

/// Smallest sine of a turn around a face: positive for a strictly convex one.
double sharpest_turn(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const auto side = [&](std::size_t k) {
    return Eigen::Vector3d(mesh.positions.col(face[(k + 1) % face.size()]) -
                           mesh.positions.col(face[k % face.size()]));
  };
  for (std::size_t k = 0; k < face.size(); ++k) normal += side(k).cross(side(k + 1));
  normal.normalize();
  double sharpest = 1.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const double turn =
        normal.dot(side(k).cross(side(k + 1))) / (side(k).norm() * side(k + 1).norm());
    sharpest = std::min(sharpest, turn);
  }
  return sharpest;
}

class EverySample : public ::testing::TestWithParam<std::tuple<std::string_view, int>> {};

TEST_P(EverySample, IsACleanFlatConvexDisk) {
  const auto [name, size] = GetParam();
  const Mesh mesh = *make_sample(name, size);
  EXPECT_EQ(testing::warning_text(check_mesh(mesh)), "");
  const MeshSummary summary = summarize(mesh);
  EXPECT_EQ(summary.boundary_loops, 1);
  EXPECT_EQ(summary.components, 1);
  EXPECT_LT(planarity_summary(mesh).max, 1e-6);
  const double count = mesh.vertex_count(), wanted = static_cast<double>(size) * size;
  EXPECT_GT(count, 0.7 * wanted);
  EXPECT_LT(count, 1.5 * wanted + 20);
  for (int f = 0; f < mesh.face_count(); ++f)
    EXPECT_GT(sharpest_turn(mesh, f), 0.2) << "face " << f;
  const EdgeSpread spread = edge_spread(mesh);
  EXPECT_LT(spread.longest / spread.shortest, 3.5);
  if (name != "dome") {
    EXPECT_NEAR(summary.mean_edge, 1.0, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, EverySample,
                         ::testing::Combine(::testing::Values("roof", "vault", "dome", "freeform",
                                                              "hex", "trihex"),
                                            ::testing::Values(10, 32, 101)));

/// Every night; at a commit a tenth of that.
TEST(Shapes, StayFlatWithAMillionVertices) {
  for (const std::string_view name : sample_names()) {
    const PlanaritySummary planarity =
        planarity_summary(*make_sample(name, testing::by_night(1000, 320)));
    EXPECT_LT(planarity.max, 1e-6) << name;
    RecordProperty(std::string(name), std::to_string(planarity.max));
  }
}

/// FNV-1a of the coordinates' bytes.
std::uint64_t fingerprint(const Positions& positions) {
  std::uint64_t hash = 14695981039346656037u;
  for (Eigen::Index k = 0; k < positions.size(); ++k) {
    unsigned char bytes[sizeof(double)];
    std::memcpy(bytes, positions.data() + k, sizeof bytes);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211u;
  }
  return hash;
}

/// Shared links rebuild a sample from its name: native and wasm must agree to the last bit.
TEST(Shapes, HaveTheSameBitsOnEveryPlatform) {
  const std::uint64_t expected[] = {4938618250860736530u,  10321117945600688182u,
                                    10921236294740059089u, 6703126293268417846u,
                                    9374817436665464385u,  133475846086015987u};
  for (std::size_t k = 0; k < sample_names().size(); ++k) {
    const std::string_view name = sample_names()[k];
    EXPECT_EQ(fingerprint(make_sample(name, 32)->positions), expected[k]) << name;
  }
}

TEST(Shapes, TheSmallestOnesAreValid) {
  for (const std::string_view name : sample_names()) {
    EXPECT_EQ(testing::warning_text(check_mesh(*make_sample(name, 3))), "") << name;
  }
}

TEST(Shapes, HexagonsAndTrianglesAreWhatTheNamesSay) {
  const auto sizes = [](std::string_view name) {
    return summarize(*make_sample(name, 30)).face_sizes;
  };
  EXPECT_EQ(sizes("hex").size(), 1u);
  EXPECT_EQ(sizes("hex").count(6), 1u);
  const std::map<int, int> trihex = sizes("trihex");
  EXPECT_EQ(trihex.size(), 2u);
  EXPECT_GT(trihex.at(3), trihex.at(6));
}

}  // namespace
}  // namespace planish
