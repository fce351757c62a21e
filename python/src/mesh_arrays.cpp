// SPDX-License-Identifier: MIT
#include "mesh_arrays.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "request.hpp"

namespace planish::python {

namespace py = pybind11;
using workflow::MeshError;

namespace {

/// Offsets and corners within int and in order; what the corners mean is check_mesh()'s.
std::vector<int> whole_numbers(const Indices& values, const char* what) {
  std::vector<int> result(static_cast<std::size_t>(values.size()));
  for (py::ssize_t k = 0; k < values.size(); ++k) {
    const long long value = values.data()[k];
    if (value < 0 || value > std::numeric_limits<int>::max()) {
      throw MeshError(std::string(what) + "[" + std::to_string(k) + "] is " +
                      std::to_string(value) + ", no index from 0");
    }
    result[static_cast<std::size_t>(k)] = static_cast<int>(value);
  }
  return result;
}

}  // namespace

library::OpenMesh mesh_of_arrays(const Points& points, const Indices& offsets,
                                 const Indices& corners) {
  if (points.ndim() != 2 || points.shape(1) != 3) {
    throw MeshError("points must be an array of shape (n, 3)");
  }
  return library::mesh_of_lists(Eigen::Map<const Positions>(points.data(), 3, points.shape(0)),
                                whole_numbers(offsets, "offsets"),
                                whole_numbers(corners, "corners"));
}

Points points_array(const Positions& positions) {
  return Points(std::vector<py::ssize_t>{positions.cols(), 3}, positions.data());
}

Indices moved_array(const Positions& before, const Positions& after) {
  const std::vector<int> moved = moved_vertices(before, after);
  const std::vector<long long> wide(moved.begin(), moved.end());
  return Indices(static_cast<py::ssize_t>(wide.size()), wide.data());
}

}  // namespace planish::python
