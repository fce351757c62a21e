// SPDX-License-Identifier: MIT
/// How symmetric the points of a shape are, and the shape that is so near it. [SYM-2]
#include <algorithm>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "planish/numeric/index.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {
namespace {

/// What is on a mirror plane of an axis stays there, to the bit.
void put_on_planes(const MeshSymmetry& symmetry, int vertex, Positions& shape) {
  for (const SymmetryOperation& operation : symmetry.operations) {
    if (operation.image[at(vertex)] != vertex) continue;
    for (int c = 0; c < 3; ++c) {
      if (operation.turn(c, c) == -1.0) shape(c, vertex) = symmetry.centre[c];
    }
  }
}

/// The place of a vertex in the mean over all motions.
Eigen::Vector3d mean_place(const MeshSymmetry& symmetry, int vertex,
                           const std::vector<std::size_t>& inverse, const Positions& shape) {
  const auto& operations = symmetry.operations;
  const Eigen::Vector3d own = shape.col(vertex);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of the ways from here: far from 0 digits count
  for (std::size_t k = 0; k < operations.size(); ++k) {
    sum += symmetry.moved(inverse[k], shape.col(operations[k].image[at(vertex)])) - own;
  }
  return own + sum / static_cast<double>(operations.size());
}

/// The operations that only keep and mirror coordinates: what they copy is a copy to the bit.
std::vector<std::size_t> plain_mirrors(const MeshSymmetry& symmetry) {
  std::vector<std::size_t> plain;
  for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
    if ((symmetry.operations[k].turn.diagonal().cwiseAbs().array() == 1.0).all()) {
      plain.push_back(k);
    }
  }
  return plain;
}

/// For each operation the one that undoes it.
std::vector<std::size_t> inverses(const MeshSymmetry& symmetry) {
  std::vector<std::size_t> inverse;
  const auto& operations = symmetry.operations;
  for (const SymmetryOperation& one : operations) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < operations.size(); ++k) {
      const double off = (operations[k].turn - one.turn.transpose()).cwiseAbs().maxCoeff();
      if (off < least) {
        least = off;
        best = k;
      }
    }
    inverse.push_back(best);
  }
  return inverse;
}

}  // namespace

std::vector<int> images_of(const MeshSymmetry& symmetry, std::span<const int> vertices) {
  std::vector<int> images;
  for (const int v : vertices) {
    for (const SymmetryOperation& one : symmetry.operations) images.push_back(one.image[at(v)]);
  }
  std::sort(images.begin(), images.end());
  images.erase(std::unique(images.begin(), images.end()), images.end());
  return images;
}

double asymmetry(const MeshSymmetry& symmetry, const Mesh& mesh, const Positions& shape) {
  double largest = 0.0;
  for (std::size_t k = 1; k < symmetry.operations.size(); ++k) {
    const std::vector<int>& image = symmetry.operations[k].image;
    for (const int v : mesh.face_vertices) {
      const Eigen::Vector3d moved = symmetry.moved(k, shape.col(v));
      largest = std::max(largest, (moved - shape.col(image[at(v)])).norm());
    }
  }
  const double edge = mean_edge_length(mesh);
  return edge > 0.0 ? largest / edge : largest;
}

void even_out(const MeshSymmetry& symmetry, std::span<const int> vertices, Positions& shape) {
  const std::vector<std::size_t> inverse = inverses(symmetry), plain = plain_mirrors(symmetry);
  std::vector<char> done(at(shape.cols()), 0);
  const auto put = [&](int vertex, const Eigen::Vector3d& place) {
    if (done[at(vertex)] != 0) return;
    done[at(vertex)] = 1;
    shape.col(vertex) = place;
    put_on_planes(symmetry, vertex, shape);
  };
  for (const int v : vertices) {
    if (done[at(v)] != 0) continue;
    const Eigen::Vector3d place = mean_place(symmetry, v, inverse, shape);
    for (std::size_t k = 0; k < symmetry.operations.size(); ++k) {
      const int image = symmetry.operations[k].image[at(v)];
      if (done[at(image)] != 0) continue;
      put(image, symmetry.moved(k, place));
      for (const std::size_t mirror : plain) {
        const Eigen::Vector3d copy = symmetry.moved(mirror, shape.col(image));
        put(symmetry.operations[mirror].image[at(image)], copy);
      }
    }
  }
}

void even_out_directions(const MeshSymmetry& symmetry, std::span<const int> vertices,
                         Eigen::Matrix3Xd& displacement) {
  std::unordered_map<int, Eigen::Index> place;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    place[vertices[k]] = static_cast<Eigen::Index>(k);
  }
  const Eigen::Matrix3Xd given = displacement;
  displacement.setZero();
  for (const SymmetryOperation& one : symmetry.operations) {
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const Eigen::Index image = place.at(one.image[at(vertices[k])]);
      displacement.col(static_cast<Eigen::Index>(k)) += one.turn.transpose() * given.col(image);
    }
  }
  displacement /= static_cast<double>(symmetry.operations.size());
}

}  // namespace planish
