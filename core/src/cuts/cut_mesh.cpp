// SPDX-License-Identifier: MIT
#include "planish/cuts/cut_mesh.hpp"

#include <utility>

#include "cuts/cut_operations.hpp"
#include "cuts/panel_net.hpp"
#include "text/sentence.hpp"

namespace planish {
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

}  // namespace planish
