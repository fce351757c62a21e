// SPDX-License-Identifier: MIT
#include "planish/problem/mesh_standing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Strains of the faces that break a constraint: the excess as a multiple of its tolerance.
class Failures {
 public:
  Failures(const Mesh& mesh, const Adjacency& adjacency)
      : adjacency_(adjacency), strains_(at(mesh.face_count()), 0.0) {}

  void add(Element element, int index, double strain) {
    if (element == Element::kFace) return raise(index, strain);
    for (const int f : adjacency_.faces[index]) raise(f, strain);
  }

  [[nodiscard]] std::vector<int> worst_first() const {
    std::vector<int> faces;
    for (std::size_t f = 0; f < strains_.size(); ++f) {
      if (strains_[f] != 0.0) faces.push_back(static_cast<int>(f));
    }
    std::stable_sort(faces.begin(), faces.end(),
                     [&](int a, int b) { return strains_[at(a)] > strains_[at(b)]; });
    return faces;
  }

 private:
  void raise(int face, double strain) {
    if (!(strain <= strains_[at(face)])) strains_[at(face)] = strain;
  }

  const Adjacency& adjacency_;
  std::vector<double> strains_;
};

}  // namespace

MeshStanding measure_standing(const Mesh& mesh, const Adjacency& adjacency, const KeptKinds& kept) {
  MeshStanding standing;
  Failures failures(mesh, adjacency);
  MeshElements elements(mesh, adjacency);
  kept.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    for (int e = 0; e < elements.count(Kind::kElement); ++e) {
      const Violation here = violation_of<Kind>(mesh.positions, elements.of(Kind::kElement, e));
      standing.worst[kind].raise_to(here);
      if (here.excess <= kept.tolerance(kind)) continue;
      const double strain = here.excess / kept.tolerance(kind);
      failures.add(Kind::kElement, e,
                   std::isnan(strain) ? std::numeric_limits<double>::infinity() : strain);
    }
  });
  standing.failing = failures.worst_first();
  return standing;
}

std::vector<KindViolation> kind_violations(const KeptKinds& kept, const Violations& before,
                                           const Violations& after) {
  std::vector<KindViolation> list;
  kept.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    if (list.empty() || list.back().kind != Kind::kName) list.push_back({Kind::kName, Kind::kUnit});
    KindViolation& named = list.back();
    if (!(before[kind].measure <= named.before_max)) named.before_max = before[kind].measure;
    if (!(after[kind].measure <= named.after_max)) named.after_max = after[kind].measure;
  });
  return list;
}

std::vector<int> vertices_of(const Mesh& mesh, const std::vector<int>& faces) {
  std::vector<int> vertices;
  for (const int f : faces) {
    const auto face = mesh.face(f);
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace planish
