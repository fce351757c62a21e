// SPDX-License-Identifier: MIT
#include "planish/shapes/shapes.hpp"

#include "shapes/grid_shapes.hpp"
#include "shapes/lattice_shapes.hpp"

namespace planish {
namespace {

struct Sample {
  std::string_view name;
  Mesh (*make)(int size);
};

constexpr Sample kSamples[] = {{"roof", make_roof},     {"vault", make_vault},
                               {"dome", make_dome},     {"freeform", make_freeform},
                               {"hex", make_hex_shell}, {"trihex", make_trihex_shell}};
constexpr int kSmallest = 3, kLargest = 2000;

}  // namespace

std::vector<std::string_view> sample_names() {
  std::vector<std::string_view> names;
  for (const Sample& sample : kSamples) names.push_back(sample.name);
  return names;
}

std::optional<Mesh> make_sample(std::string_view name, int size) {
  if (size < kSmallest || size > kLargest) return std::nullopt;
  for (const Sample& sample : kSamples) {
    if (sample.name == name) return sample.make(size);
  }
  return std::nullopt;
}

}  // namespace planish
