// SPDX-License-Identifier: MIT
/// The elements of a mesh that rows hang on, each as the list of vertices that a kind is given.
#pragma once

#include <span>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Numbers elements like faces and vertices. Keeps references to mesh and adjacency.
class MeshElements {
 public:
  MeshElements(const Mesh& mesh, const Adjacency& adjacency) : mesh_(mesh), adjacency_(adjacency) {}

  [[nodiscard]] int count(Element element) const {
    return element == Element::kFace ? mesh_.face_count() : mesh_.vertex_count();
  }

  /// A face's vertices, or an inner vertex and its neighbours in order; nothing at a vertex on the
  /// boundary. Valid until the next call.
  [[nodiscard]] std::span<const int> of(Element element, int index) {
    if (element == Element::kFace) return mesh_.face(index);
    star_.clear();
    const auto v = static_cast<std::size_t>(index);
    if (adjacency_.boundary[v] != 0 || adjacency_.regular[v] == 0) return star_;
    star_.push_back(index);
    const auto around = adjacency_.neighbours[index];
    star_.insert(star_.end(), around.begin(), around.end());
    return star_;
  }

 private:
  const Mesh& mesh_;
  const Adjacency& adjacency_;
  std::vector<int> star_;
};

}  // namespace planish
