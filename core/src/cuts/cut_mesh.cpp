// SPDX-License-Identifier: MIT
#include "planish/cuts/cut_mesh.hpp"

#include <algorithm>
#include <utility>

#include "cuts/cut_operations.hpp"
#include "cuts/panel_net.hpp"
#include "planish/numeric/index.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// "a" for 0, "z" for 25, "aa" for 26.
std::string letters_of(int number) {
  std::string letters;
  for (int left = number + 1; left > 0; left = (left - 1) / 26) {
    letters.insert(letters.begin(), static_cast<char>('a' + (left - 1) % 26));
  }
  return letters;
}

}  // namespace

std::variant<CutMesh, std::string> cut_mesh(const Mesh& mesh, const std::vector<Cut>& cuts) {
  constexpr std::size_t kLongest = 48;
  PanelNet net(mesh);
  for (const Cut& cut : cuts) {
    if (Refusal problem = find_problem(cut)) return *problem;
    net.start(cut);
    const Refusal problem = std::visit([&](const auto& one) { return apply_cut(one, net); }, cut);
    if (problem) return printable(cut_text(cut), kLongest) + ": " + *problem;
  }
  return net.finished();
}

std::vector<std::string> part_letters(const std::vector<int>& parents) {
  std::vector<std::string> letters(parents.size());
  if (parents.empty()) return letters;
  std::vector<int> count(at(*std::max_element(parents.begin(), parents.end())) + 1, 0);
  for (const int parent : parents) ++count[at(parent)];
  std::vector<int> next(count.size(), 0);
  for (std::size_t f = 0; f < parents.size(); ++f) {
    const std::size_t parent = at(parents[f]);
    if (count[parent] > 1) letters[f] = letters_of(next[parent]++);
  }
  return letters;
}

}  // namespace planish
