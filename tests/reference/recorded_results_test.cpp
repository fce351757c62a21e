// SPDX-License-Identifier: MIT
/// What designs on the samples gave when data/recorded_results.txt was written, to the last bit: a
/// change that is meant to keep results must keep these. One that is meant to change them writes
/// the file anew:
///   PLANISH_RECORD_RESULTS=1 build/native/tests/planish_tests --gtest_filter='RecordedResults.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <variant>

#include "planish/design/design.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr int kSide = 12;
const std::string kFile = testing::in_tree("tests/reference/data/recorded_results.txt");

using Record = std::map<std::string, std::uint32_t>;  ///< design → DesignMark::hash

Record read_record() {
  Record record;
  std::ifstream file(kFile);
  std::string name;
  std::uint32_t hash = 0;
  while (file >> name >> hash) record[name] = hash;
  return record;
}

Design lift(const std::string& sample, double height) {
  const Mesh mesh = testing::sample(sample, kSide);
  Design design;
  design.source = SampleSource{sample, kSide};
  design.targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.2 * height, 0.0, height});
  return design;
}

/// Every way through the engines: both of them, hard handles, fairness, sparsity, variations.
std::map<std::string, Design> designs_on(const std::string& sample) {
  std::map<std::string, Design> designs;
  const std::map<std::string, double> heights{{"low", 0.25}, {"high", 1.5}};
  for (const auto& entry : heights) {
    const std::string& size = entry.first;  // clang captures no structured binding
    const Design plain = lift(sample, entry.second);
    const auto add = [&](const std::string& what, const auto& change) {
      Design design = plain;
      change(design);
      designs[sample + "/" + size + "/" + what] = design;
    };
    add("plain", [](Design&) {});
    add("hard", [](Design& design) { design.options.hard_handles = true; });
    add("dense", [](Design& design) { design.options.sparsity = Sparsity::kL2; });
    add("laplacian", [](Design& design) { design.options.fairness = FairnessKind::kLaplacian; });
    add("slack", [](Design& design) { design.options.tolerance = 0.1; });
    add("alm", [](Design& design) { design.options.engine = Engine::kAugmentedLagrangian; });
    add("variation", [](Design& design) {
      design.variations.push_back({.options = {.dimension = 3}, .coefficients = {0.1, -0.2, 0.1}});
    });
  }
  return designs;
}

Record replay_all() {
  Record record;
  for (const char* sample : {"vault", "dome", "freeform", "hex", "trihex"}) {
    for (const auto& [name, design] : designs_on(sample)) {
      record[name] = std::get<Replay>(replay(design)).mark.hash;
    }
  }
  return record;
}

void write_record(const Record& record) {
  std::ofstream file(kFile);
  for (const auto& [name, hash] : record) file << name << ' ' << hash << '\n';
}

TEST(RecordedResults, AreKeptToTheLastBit) {
#ifdef __EMSCRIPTEN__
  GTEST_SKIP() << "tests/parity compares wasm with native";
#endif
  const Record now = replay_all();
  if (std::getenv("PLANISH_RECORD_RESULTS") != nullptr) write_record(now);
  EXPECT_EQ(now, read_record());
}

}  // namespace
}  // namespace planish
