// SPDX-License-Identifier: MIT
/// Cuts at random places: no point moves, and what is not cut keeps its bits. On the samples, and
/// on the shared meshes made flat.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/projection/planarising.hpp"
#include "support/cut_checks.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kOfSize = 1e-12;
constexpr int kOfEach = 20;

/// What happened to the cuts of a mesh.
struct CutTally {
  int made = 0;
  std::map<std::string, int> refused;  ///< by the sentence, numbers left out
  testing::CutFigures figures;
};

std::string without_numbers(const std::string& sentence) {
  std::string text = sentence.substr(sentence.find(": ") + 2);
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }),
             text.end());
  return text;
}

/// The mesh after cuts; nullopt, and counted, where they are refused.
std::optional<CutMesh> tried_cuts(const Mesh& mesh, const std::vector<Cut>& cuts, CutTally& tally) {
  auto made = cut_mesh(mesh, cuts);
  if (const auto* why = std::get_if<std::string>(&made)) {
    ++tally.refused[without_numbers(*why)];
    return std::nullopt;
  }
  ++tally.made;
  return std::get<CutMesh>(std::move(made));
}

void cut_at(const Mesh& mesh, const Cut& cut, CutTally& tally) {
  const auto made = tried_cuts(mesh, {cut}, tally);
  if (!made) return;
  EXPECT_TRUE(testing::is_valid_cut(mesh, *made, kOfSize, tally.figures)) << cut_text(cut);
}

void trim_both_ways(const Mesh& mesh, TrimCut cut, CutTally& tally) {
  const auto before = tried_cuts(mesh, {cut}, tally);
  const std::string text = cut_text(cut);
  for (double& number : cut.plane) number = -number;
  const auto beyond = tried_cuts(mesh, {cut}, tally);
  EXPECT_EQ(before.has_value(), beyond.has_value()) << text;
  if (!before || !beyond) return;
  EXPECT_TRUE(testing::are_two_halves(mesh, *before, *beyond, kOfSize, tally.figures)) << text;
}

/// Eight cuts in one list, each at a random place of the mesh that the ones before it left.
void cut_in_turn(const Mesh& mesh, testing::RandomCuts& random, CutTally& tally) {
  std::vector<Cut> cuts;
  CutMesh last{mesh, {}, {}, {}};
  for (int k = 0; k < 8; ++k) {
    cuts.push_back(random.any(last.mesh));
    if (auto made = tried_cuts(mesh, cuts, tally)) {
      last = std::move(*made);
    } else {
      cuts.pop_back();
    }
  }
  if (cuts.empty()) return;
  EXPECT_TRUE(testing::is_valid_cut(mesh, last, kOfSize, tally.figures)) << cuts.size() << " cuts";
}

/// Twenty of each kind, and five lists.
CutTally cut_at_random(const Mesh& mesh, std::uint64_t seed) {
  CutTally tally;
  testing::RandomCuts random(seed);
  for (int k = 0; k < kOfEach; ++k) {
    cut_at(mesh, random.split(mesh), tally);
    cut_at(mesh, random.strip(mesh), tally);
    cut_at(mesh, random.corner(mesh), tally);
    cut_at(mesh, random.refine(mesh), tally);
    trim_both_ways(mesh, random.trim(mesh), tally);
    if (k % 4 == 0) cut_in_turn(mesh, random, tally);
  }
  return tally;
}

/// Says what happened. Where panels are convex, and there are quads for strips, few are refused:
/// lines along sides that straight corners divide.
void tell_cuts(const std::string& name, const CutTally& tally) {
  std::cout << "  " << name << ": " << tally.made << " made, out of flat " << tally.figures.flatness
            << " (before " << tally.figures.bent << "), areas " << tally.figures.area << "\n";
  int others = 0;
  for (const auto& [why, count] : tally.refused) {
    std::cout << "    " << count << " × " << why << "\n";
    const bool is_of_mesh =
        why.find("no quad") != std::string::npos || why.find("not convex") != std::string::npos;
    if (!is_of_mesh) others += count;
  }
  EXPECT_LE(20 * others, tally.made) << name;
}

TEST(Cuts, MoveNothingOnTheSamples) {
  for (const char* name : {"roof", "vault", "dome", "freeform", "hex", "trihex"}) {
    SCOPED_TRACE(name);
    Mesh mesh = testing::sample(name, 12);
    mesh.positions = testing::apply(mesh, planarise(mesh, {}));
    for (const unsigned seed : testing::seeds()) tell_cuts(name, cut_at_random(mesh, seed));
  }
}

/// Four of the shared meshes have no flat and sound one nearby; to look for that of quad_pillow
/// takes most of the time: every night.
std::vector<std::string> meshes_to_cut() {
  const std::filesystem::path folder = testing::in_shared_meshes("");
  if (!std::filesystem::exists(folder)) return {""};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".obj" || name == "quad_heart" || name == "quad_wein99" ||
        name == "quad_helical_minimal" || name == "hex_minsurface_messy" ||
        (name == "quad_pillow" && !testing::is_night())) {
      continue;
    }
    names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class CutSharedMeshes : public ::testing::TestWithParam<std::string> {};

TEST_P(CutSharedMeshes, MoveNothing) {
  if (GetParam().empty()) GTEST_SKIP() << "skipped: no shared meshes";
  const ReadResult read =
      read_mesh(*testing::shared_mesh_bytes(GetParam() + ".obj"), MeshFormat::kObj);
  Mesh mesh = std::get<MeshFile>(read).mesh;
  ProjectionResult flat = planarise(mesh, {});
  if (!flat.report.usable()) flat = planarise(mesh, kNearestFlat);
  mesh.positions = testing::apply(mesh, flat);
  tell_cuts(GetParam(), cut_at_random(mesh, 1));
}

INSTANTIATE_TEST_SUITE_P(Cuts, CutSharedMeshes, ::testing::ValuesIn(meshes_to_cut()));

}  // namespace
}  // namespace planish
