// SPDX-License-Identifier: MIT
#include "planish/mesh/panel_boxes.hpp"

#include <algorithm>
#include <numeric>

#include "planish/numeric/index.hpp"

namespace planish {

PanelBoxes::PanelBoxes(const Mesh& mesh, const Positions& points)
    : boxes_(at(mesh.face_count())), panels_(boxes_.size()) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) boxes_[at(f)].extend(Eigen::Vector3d(points.col(v)));
  }
  std::iota(panels_.begin(), panels_.end(), 0);
  if (!panels_.empty()) halve(0, mesh.face_count());
}

void PanelBoxes::halve(int begin, int end) {
  constexpr int kTogether = 8;
  const std::size_t place = nodes_.size();
  Node node{.box = {}, .begin = begin, .end = end};
  for (int k = begin; k < end; ++k) node.box.extend(boxes_[at(panels_[at(k)])]);
  nodes_.push_back(node);
  if (end - begin <= kTogether) return;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(panels_.begin() + begin, panels_.begin() + middle, panels_.begin() + end,
                   [&](int a, int b) {
                     const double x = boxes_[at(a)].center()[axis];
                     const double y = boxes_[at(b)].center()[axis];
                     return x != y ? x < y : a < b;
                   });
  halve(begin, middle);
  nodes_[place].second = static_cast<int>(nodes_.size());
  halve(middle, end);
}

std::vector<int> PanelBoxes::near(const Eigen::AlignedBox3d& box) const {
  std::vector<int> found;
  std::vector<int> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const int place = open.back();
    const Node& node = nodes_[at(place)];
    open.pop_back();
    if (!node.box.intersects(box)) continue;
    if (node.second >= 0) {
      open.push_back(node.second);
      open.push_back(place + 1);
      continue;
    }
    for (int k = node.begin; k < node.end; ++k) {
      const int panel = panels_[at(k)];
      if (boxes_[at(panel)].intersects(box)) found.push_back(panel);
    }
  }
  return found;
}

}  // namespace planish
