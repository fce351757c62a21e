// SPDX-License-Identifier: MIT
/// How sharply neighbouring panels meet: what a designer calls a crease.
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Where two panels meet.
struct Fold {
  double degrees = 0.0;           ///< between their normals: 0 flat, 180 folded back onto itself
  int face = -1, neighbour = -1;  ///< the two panels, face < neighbour; −1: there is no fold
};

/// Faces that use one of `vertices`, ascending.
[[nodiscard]] std::vector<int> faces_of(const Adjacency& adjacency, std::span<const int> vertices);

/// The sharpest fold of a face of `faces` (ascending) with any neighbour. Orientation of the faces
/// does not matter; edges that more than two panels share and panels without area are passed over.
/// Costs what `faces` and their neighbours have. [MET-4]
/// @param positions 3 × n of the whole mesh
[[nodiscard]] Fold sharpest_fold(const Mesh& mesh, const Adjacency& adjacency,
                                 const Positions& positions, std::span<const int> faces);

/// How many degrees the fold that sharpened most became sharper, of all folds that sharpest_fold()
/// looks at; at least 0. A crease in a smooth place so counts in full, whatever folds elsewhere.
/// [MET-4]
/// @param before, after 3 × n of the whole mesh
[[nodiscard]] double largest_fold_growth(const Mesh& mesh, const Adjacency& adjacency,
                                         const Positions& before, const Positions& after,
                                         std::span<const int> faces);

/// The sharpest fold of every face with any neighbour, degrees; 0 for one without. [MET-4]
/// @param positions 3 × n of the whole mesh
[[nodiscard]] std::vector<double> face_folds(const Mesh& mesh, const Positions& positions);

}  // namespace planish
