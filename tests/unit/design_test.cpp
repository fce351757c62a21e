// SPDX-License-Identifier: MIT
#include "planish/design/design.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "planish/design/design_text.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/shapes/shapes.hpp"
#include "support/circles.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::same_bits;

constexpr int kSize = 13;
constexpr int kLifted = 6 * kSize + 6;

Design lifted_vault(double height) {
  Design design;
  design.source = SampleSource{"vault", kSize};
  Eigen::Vector3d target = make_sample("vault", kSize)->positions.col(kLifted);
  target.z() += height;
  design.targets.handles = {{kLifted, target}};
  return design;
}

Replay replay_or_fail(const Design& design, const Mesh* given = nullptr) {
  auto result = replay(design, given);
  if (auto* sentence = std::get_if<std::string>(&result)) {
    ADD_FAILURE() << *sentence;
    return {};
  }
  return std::move(std::get<Replay>(result));
}

std::string refusal_of(const Design& design, const Mesh* given = nullptr) {
  const auto result = replay(design, given);
  const auto* sentence = std::get_if<std::string>(&result);
  return sentence != nullptr ? *sentence : "";
}

TEST(Design, ReplaysToTheSameBits) {
  Design design = lifted_vault(0.6);
  design.variations = {{{.dimension = 3}, {0.4, 0.0, -0.3}, true}, {{.dimension = 2}, {0.2}, true}};
  const Replay first = replay_or_fail(design);
  EXPECT_FALSE(first.verified);  // nothing was recorded yet
  design.result = first.mark;
  const Replay again = replay_or_fail(design);
  EXPECT_TRUE(again.verified);
  EXPECT_EQ(again.deviation, 0.0);
  EXPECT_TRUE(same_bits(again.shape, first.shape));
  EXPECT_GT(first.mark.moved, 0);
  EXPECT_FALSE(first.mark.probes.empty());
}

TEST(Design, ASecondVariationStartsFromTheFirst) {
  Design design = lifted_vault(0.6);
  design.variations = {{{.dimension = 2}, {0.5, 0.1}, true}};
  const Replay one = replay_or_fail(design);
  design.variations.push_back({{.dimension = 2}, {0.0, 0.0}, true});
  EXPECT_TRUE(same_bits(replay_or_fail(design).shape, one.shape));
}

TEST(Design, SaysHowFarItIsFromWhatWasRecorded) {
  Design design = lifted_vault(0.6);
  design.result = replay_or_fail(design).mark;
  for (DesignProbe& probe : design.result->probes) probe.position.z() += 0.25;
  design.result->hash ^= 1;
  const Replay replayed = replay_or_fail(design);
  EXPECT_FALSE(replayed.verified);
  EXPECT_NEAR(replayed.deviation, 0.25, 1e-9);
}

TEST(Design, PlanarisesItsFileAndKnowsIt) {
  Mesh bumpy = *make_sample("dome", kSize);
  for (int v = 0; v < bumpy.vertex_count(); ++v) bumpy.positions(2, v) += 0.02 * (v % 3);
  Design design;
  design.planarised = kNearestFlat;
  design.source = FileSource{"bumpy.obj", {}, "obj", write_mesh(bumpy, MeshFormat::kObj)};
  Replay opened = replay_or_fail(design);
  const Eigen::Vector3d up(0.0, 0.0, 0.3);
  design.targets.handles = {{kLifted, opened.base.positions.col(kLifted) + up}};
  auto& file = std::get<FileSource>(design.source);
  file.hash = mesh_hash(opened.base);
  design.result = replay_or_fail(design).mark;
  // The same without the bytes: from the file beside it, or from the flat base itself (a GLB's).
  file.bytes.clear();
  EXPECT_TRUE(replay_or_fail(design, &bumpy).verified);
  EXPECT_TRUE(replay_or_fail(design, &opened.base).verified);
  EXPECT_NE(refusal_of(design), "");
  file.hash = 0U;  // of a flat mesh that another machine rounded otherwise
  EXPECT_TRUE(replay_or_fail(design, &bumpy).verified);
  file.hash.reset();  // not known
  EXPECT_TRUE(replay_or_fail(design, &bumpy).verified);
  bumpy.positions(2, kLifted) += 0.05;
  const Replay other = replay_or_fail(design, &bumpy);
  EXPECT_FALSE(other.verified);
  EXPECT_GT(other.deviation, 1e-4);
}

TEST(Design, RefusesAnotherFileWhereItTookOneAsItWas) {
  Mesh vault = *make_sample("vault", kSize);
  Design design = lifted_vault(0.6);
  design.source = FileSource{"vault.obj", mesh_hash(vault), "obj", {}};
  EXPECT_EQ(replay_or_fail(design, &vault).base.vertex_count(), vault.vertex_count());
  vault.positions(2, 0) += 1e-9;
  EXPECT_NE(refusal_of(design, &vault).find("not the one"), std::string::npos);
}

TEST(Design, MakesItsMeshCircularBeforeAnEditThatKeepsIt) {
  Design design = lifted_vault(0.3);
  design.options.constraints = {{"circular", 1e-9}};
  EXPECT_NE(refusal_of(design).find("not circular"), std::string::npos) << refusal_of(design);
  design.planarised = Planarising{.constraints = {{"circular", 1e-9}}};
  design.result = replay_or_fail(design).mark;
  const auto again = read_design(write_design(design));
  ASSERT_TRUE(std::holds_alternative<Design>(again));
  EXPECT_EQ(std::get<Design>(again).planarised, design.planarised);
  EXPECT_TRUE(replay_or_fail(std::get<Design>(again)).verified);
}

TEST(Design, RefusesInWords) {
  Design design = lifted_vault(0.6);
  design.source = SampleSource{"castle", kSize};
  EXPECT_NE(refusal_of(design).find("castle"), std::string::npos);
  design = lifted_vault(0.6);
  design.targets.handles[0].vertex = 9999;
  EXPECT_NE(refusal_of(design).find("9999"), std::string::npos);
  design = lifted_vault(0.6);
  design.unit = "furlong";
  EXPECT_NE(refusal_of(design).find("unit"), std::string::npos);
  design = lifted_vault(0.6);
  design.variations = {{{.dimension = 1}, {0.1, 0.2}, true}};
  EXPECT_NE(refusal_of(design).find("variations[0]"), std::string::npos);
  design = lifted_vault(0.6);
  design.source = FileSource{"broken.obj", 0, "obj", "v 0 0 0\nf 1 2 3\n"};
  EXPECT_NE(refusal_of(design).find("line 2"), std::string::npos);
}

TEST(Design, KeepsItsConstraintsWhenReplayed) {
  Design design = lifted_vault(0.3);
  design.options.constraints = {{"circular", 1e-9}};
  EXPECT_NE(refusal_of(design).find("not circular"), std::string::npos) << refusal_of(design);
  design.source = SampleSource{"dome", kSize};
  design.targets.handles[0].target = make_sample("dome", kSize)->positions.col(kLifted);
  design.targets.handles[0].target.z() += 0.3;
  const Replay first = replay_or_fail(design);
  ASSERT_EQ(first.report.violations.size(), 2u);
  EXPECT_LE(first.report.violations[1].after_max, 1e-9);
  design.result = first.mark;
  EXPECT_TRUE(replay_or_fail(design).verified);
  design.options.constraints.clear();
  EXPECT_FALSE(replay_or_fail(design).verified);
}

TEST(Design, KeepsItsConstraintsInVariationsWhenReplayed) {
  Design design = lifted_vault(0.3);
  design.source = SampleSource{"dome", kSize};
  design.targets.handles[0].target = make_sample("dome", kSize)->positions.col(kLifted);
  design.targets.handles[0].target.z() += 0.3;
  design.options.constraints = {{"circular", 1e-9}};
  const Positions edited = replay_or_fail(design).shape;
  design.variations = {{{.dimension = 2}, {0.3, -0.2}, true}};
  const Replay varied = replay_or_fail(design);
  EXPECT_GT((varied.shape - edited).norm(), 0.01);
  EXPECT_LE(testing::inscribed_defect(varied.base, varied.shape), 1e-9);
  design.result = varied.mark;
  EXPECT_TRUE(replay_or_fail(design).verified);
}

TEST(Design, WithoutAnEditIsItsBase) {
  Design design = lifted_vault(0.6);
  design.targets.handles.clear();
  design.variations = {{{.dimension = 2}, {1.0, 1.0}, true}};  // there is nothing to vary
  const Replay replayed = replay_or_fail(design);
  EXPECT_TRUE(same_bits(replayed.shape, replayed.base.positions));
  EXPECT_EQ(replayed.mark.moved, 0);
}

TEST(Design, AnotherMeshHasAnotherHash) {
  const Mesh mesh = *make_sample("trihex", 6);
  Mesh moved = mesh, turned = mesh;
  moved.positions(1, 2) += 1e-12;
  std::swap(turned.face_vertices[0], turned.face_vertices[1]);
  EXPECT_EQ(mesh_hash(mesh), mesh_hash(*make_sample("trihex", 6)));
  EXPECT_NE(mesh_hash(mesh), mesh_hash(moved));
  EXPECT_NE(mesh_hash(mesh), mesh_hash(turned));
}

}  // namespace
}  // namespace planish
