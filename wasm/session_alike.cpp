// SPDX-License-Identifier: MIT
/// The mesh that a session shows, changed a little so that more of its panels are alike.
#include <string>
#include <variant>

#include "planish/io/obj.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/repetition/fewer_types.hpp"
#include "session.hpp"

namespace planish {

std::variant<AlikeMesh, std::string> Session::alike(const AlikeAsked& asked) const {
  Mesh mesh = shown_mesh();
  const double edge = mean_edge_length(mesh);
  FewerTypesOptions options;
  options.within = asked.within * edge;
  options.move = asked.move * edge;
  options.mirrored = asked.mirrored;
  options.bounds = {*parse_stated_limit("fold=+5")};
  if (const Refusal problem = find_problem(options, mesh)) return "More alike: " + *problem + ".";
  const std::vector<int> pins = asked.keep_boundary ? boundary_vertices(mesh) : std::vector<int>();
  FewerTypes found = find_fewer_types(mesh, options, pins, progress_);
  mesh.positions = std::move(found.positions);
  return AlikeMesh{found.before, static_cast<int>(found.types.families.size()), found.max_move,
                   write_obj(mesh)};
}

}  // namespace planish
