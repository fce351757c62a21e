// SPDX-License-Identifier: MIT
/// Symmetry of the mesh that a session has open, as JavaScript sees it: a list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::copy;
using planish::MeshSymmetry;
using planish::Session;

std::string set_symmetry(Session& s, const std::string& text, double tolerance) {
  return planish::attempt([&] { return s.set_symmetry(text, tolerance); });
}

/// The least vertex of those that each is an image of.
std::vector<int> orbits_of(const MeshSymmetry& symmetry) {
  std::vector<int> least = symmetry.operations.front().image;
  for (const planish::SymmetryOperation& operation : symmetry.operations) {
    for (std::size_t v = 0; v < least.size(); ++v) {
      least[v] = std::min(least[v], operation.image[v]);
    }
  }
  return least;
}

val symmetry_of(const Session& s) {
  if (s.symmetry() == nullptr) return val::null();
  val value = val::object();
  value.set("elements", planish::list_of(s.symmetry()->elements, planish::symmetry_text));
  value.set("orbits", copy(orbits_of(*s.symmetry())));
  return value;
}

val on_fixed_points(const Session& s, const val& handles) {
  auto rows = emscripten::convertJSArrayToNumberVector<double>(handles);
  for (std::size_t k = 0; s.symmetry() != nullptr && k + 3 < rows.size(); k += 4) {
    const auto vertex = static_cast<int>(rows[k]);
    if (vertex < 0 || vertex >= s.base().vertex_count()) continue;
    Eigen::Map<Eigen::Vector3d> target(rows.data() + k + 1);
    target = planish::place_on_fixed_points(*s.symmetry(), vertex, target);
  }
  return copy(rows);
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_symmetry) {
  emscripten::function("setSymmetry", &set_symmetry);
  emscripten::function("symmetryOf", &symmetry_of);
  emscripten::function("onFixedPoints", &on_fixed_points);
}
