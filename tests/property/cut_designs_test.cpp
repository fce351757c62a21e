// SPDX-License-Identifier: MIT
/// Designs with cuts, on samples and shared meshes, with handles, supports and limits: each replays
/// to the bit from its text, and gives what an edit of the mesh that the cuts leave gives.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "planish/design/cut_base.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_text.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/cut_checks.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A source and the mesh in it; nullopt where the shared meshes are absent.
std::optional<std::pair<DesignSource, Mesh>> cut_source(const std::string& name) {
  if (name.find('.') == std::string::npos) {
    Mesh mesh = testing::sample(name, 12);
    return std::pair(DesignSource{SampleSource{name, 12}}, std::move(mesh));
  }
  const auto bytes = testing::shared_mesh_bytes(name);
  if (!bytes) return std::nullopt;
  const ReadResult read = read_mesh(*bytes, MeshFormat::kObj);
  const Mesh& mesh = std::get<MeshFile>(read).mesh;
  return std::pair(DesignSource{FileSource{name, std::nullopt, "obj", *bytes}}, mesh);
}

/// `count` cuts, each somewhere on what the ones before it left.
void add_random_cuts(Design& design, const Mesh& flat, testing::RandomCuts& random,
                     std::size_t count) {
  constexpr int kTries = 100;
  Mesh last = flat;
  for (int k = 0; k < kTries && design.cuts.size() < count; ++k) {
    design.cuts.push_back(random.any(last));
    auto made = cut_mesh(flat, design.cuts);
    if (auto* cut = std::get_if<CutMesh>(&made)) {
      last = std::move(cut->mesh);
    } else {
      design.cuts.pop_back();
    }
  }
}

/// The recipe's own words; each is one of four ways to edit.
void state_edit(Design& design, const Mesh& cut, int way) {
  const double edge = mean_edge_length(cut);
  const int vertex = testing::middle_vertex(cut);
  design.targets = testing::pull(cut, vertex, {0.0, 0.1 * edge, 0.4 * edge});
  design.options.keep_shape = true;
  design.options.softness = 3.0;
  if (way == 1) design.targets.supports = {*parse_point_support("outline:boundary")};
  if (way == 2) design.options.bounds = {*parse_stated_limit("fold=+8")};
  if (way == 3) design.options.reach = 3;
}

void expect_same_bits_again(const Design& design, const Replay& first) {
  const auto read = read_design(write_design(design));
  ASSERT_TRUE(std::holds_alternative<Design>(read)) << std::get<std::string>(read);
  const Design& again = std::get<Design>(read);
  EXPECT_EQ(again.cuts, design.cuts);
  EXPECT_EQ(write_design(again), write_design(design));
  const auto replayed = replay(again);
  ASSERT_TRUE(std::holds_alternative<Replay>(replayed)) << std::get<std::string>(replayed);
  const Replay& second = std::get<Replay>(replayed);
  EXPECT_TRUE(second.verified);
  EXPECT_TRUE(testing::same_bits(second.base, first.base));
  EXPECT_TRUE(testing::same_bits(second.shape, first.shape));
}

/// What the edit alone gives on the mesh after the cuts.
void expect_edit_of_cut_mesh(const Design& design, const Replay& replayed) {
  Design plain = design;
  plain.cuts.clear();
  plain.planarised.reset();
  plain.targets.supports = replayed.supports;
  const auto edited = replay_on(replayed.base, nullptr, plain);
  ASSERT_TRUE(std::holds_alternative<Replay>(edited)) << std::get<std::string>(edited);
  EXPECT_TRUE(testing::same_bits(std::get<Replay>(edited).shape, replayed.shape));
}

class CutDesigns : public ::testing::TestWithParam<std::string> {};

TEST_P(CutDesigns, ReplayToTheBit) {
  const auto opened = cut_source(GetParam());
  if (!opened) GTEST_SKIP() << "no shared meshes here";
  Design design;
  design.source = opened->first;
  if (std::holds_alternative<FileSource>(design.source)) design.planarised = Planarising{};
  const auto flat = replay(design);
  ASSERT_TRUE(std::holds_alternative<Replay>(flat)) << std::get<std::string>(flat);
  const Mesh& base = std::get<Replay>(flat).base;
  testing::RandomCuts random(static_cast<std::uint64_t>(base.vertex_count()));
  int moved = 0;
  const bool all = testing::is_night() || std::holds_alternative<SampleSource>(design.source);
  for (int way = 0; way < 4; ++way) {
    if (!all && way != base.vertex_count() % 4) continue;  // samples go all ways
    SCOPED_TRACE(way);
    design.cuts.clear();
    const auto count = static_cast<std::size_t>(1 + way);
    add_random_cuts(design, base, random, count);
    ASSERT_EQ(design.cuts.size(), count);
    const auto cut = cut_mesh(base, design.cuts);
    state_edit(design, std::get<CutMesh>(cut).mesh, way);
    design.result.reset();
    const auto replayed = replay(design);
    ASSERT_TRUE(std::holds_alternative<Replay>(replayed)) << std::get<std::string>(replayed);
    const Replay& first = std::get<Replay>(replayed);
    EXPECT_TRUE(testing::same_bits(first.base, std::get<CutMesh>(cut).mesh));
    design.result = first.mark;
    moved += first.mark.moved;
    expect_same_bits_again(design, first);
    expect_edit_of_cut_mesh(design, first);
  }
  EXPECT_GT(moved, 0);
}

INSTANTIATE_TEST_SUITE_P(Meshes, CutDesigns,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex",
                                           "pq_gitter.obj", "pq_static_roof.obj",
                                           "pq_six_planarized.obj", "hex_enneper_concave.obj",
                                           "pq_lifted_small.obj"));

}  // namespace
}  // namespace planish
