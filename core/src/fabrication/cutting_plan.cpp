// SPDX-License-Identifier: MIT
#include "planish/fabrication/cutting_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "fabrication/numbered.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "planish/numeric/index.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 6> kUnits = {
    {{"mm", 0.001}, {"cm", 0.01}, {"m", 1.0}, {"km", 1000.0}, {"in", 0.0254}, {"ft", 0.3048}}};

bool is_length(double value) { return std::isfinite(value) && value >= 0.0; }

/// What is wrong with `options` where one template a type is cut.
Refusal find_template_problem(const CuttingOptions& options) {
  if (!options.types) return "one drawing a type needs to know by how much joints may vary";
  const auto& joint = options.types->joint;
  const double middle = joint ? 0.5 * (joint->min + joint->max) : options.gap;
  if (options.gap != middle) {
    return "gap must be " + number_text(middle) +
           ", the middle of joint: templates are cut with it";
  }
  return std::nullopt;
}

/// The side that x runs along: the base panel's longest, so that a small edit does not turn it.
int x_side(const Mesh& mesh, const Mesh* base, int face) {
  const bool known = base != nullptr && face < base->face_count() &&
                     base->face(face).size() == mesh.face(face).size();
  const Mesh& from = known ? *base : mesh;
  return longest_side(from.positions, from.face(face));
}

void number_nodes(CuttingPlan& plan) {
  plan.node_of_vertex.assign(at(plan.mesh.vertex_count()), -1);
  for (const int v : plan.mesh.face_vertices) {
    if (plan.node_of_vertex[at(v)] >= 0) continue;
    plan.node_of_vertex[at(v)] = static_cast<int>(plan.vertex_of_node.size());
    plan.vertex_of_node.push_back(v);
  }
}

std::vector<char> drawn_panels(const CuttingPlan& plan) {
  const CuttingOptions& options = plan.options;
  std::vector<char> drawn(at(plan.mesh.face_count()), options.panels.empty() ? 1 : 0);
  for (const int face : options.panels) drawn[at(face)] = 1;
  for (std::size_t f = 0; f < drawn.size() && options.remake_only; ++f) {
    if (plan.remake->panels[f] == PanelChange::kUnchanged) drawn[f] = 0;
  }
  return drawn;
}

}  // namespace

std::optional<double> metres_in(const std::string& unit) {
  for (const auto& [name, metres] : kUnits) {
    if (name == unit) return metres;
  }
  return std::nullopt;
}

Refusal find_problem(const CuttingOptions& options, const Mesh& mesh, bool has_base) {
  if (!metres_in(options.model_unit)) return "model_unit must be mm, cm, m, km, in or ft";
  if (!metres_in(options.unit)) return "unit must be mm, cm, m, km, in or ft";
  if (!is_length(options.gap)) return "gap must be at least 0";
  if (!is_length(options.thickness)) return "thickness must be at least 0";
  if (!is_length(options.text_height)) return "text_height must be at least 0";
  if (!is_length(options.sheet_width) || !is_length(options.sheet_height) ||
      (options.sheet_width > 0.0) != (options.sheet_height > 0.0)) {
    return "sheet must be two lengths greater than 0";
  }
  if (options.types) {
    if (const Refusal problem = find_problem(*options.types)) return problem;
  }
  if (options.by_type) {
    if (const Refusal problem = find_template_problem(options)) return problem;
  }
  if (options.remake_only && !has_base) {
    return "scope: what must be made again needs a mesh to compare with";
  }
  for (const int face : options.panels) {
    if (face < 0 || face >= mesh.face_count()) {
      return "scope: there is no panel " + std::to_string(face);
    }
  }
  return std::nullopt;
}

CuttingPlan make_cutting_plan(const Mesh& mesh, const Mesh* base, const CuttingOptions& options) {
  CuttingPlan plan;
  plan.options = options;
  plan.mesh = mesh;
  plan.hash = mesh_hash(mesh);
  plan.base_hash = base != nullptr ? mesh_hash(*base) : plan.hash;
  plan.scale = metres_in(options.model_unit).value() / metres_in(options.unit).value();
  plan.mesh.positions *= plan.scale;
  plan.joints = joint_table(plan.mesh);
  number_nodes(plan);
  if (base != nullptr) plan.remake = find_remake(*base, mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const int side = x_side(mesh, base, f);
    plan.panels.push_back(flatten_panel(plan.mesh.positions, mesh.face(f), side));
  }
  if (options.types) {
    plan.types = find_structure_types(plan.mesh, plan.panels, plan.joints, *options.types);
  }
  plan.drawn = drawn_panels(plan);
  return plan;
}

void note_pieces(const CuttingPlan& plan, int face, const std::vector<CutPiece>& pieces,
                 DrawnReport& report) {
  std::set<int> sides;
  for (const CutPiece& piece : pieces) sides.insert(piece.sides.begin(), piece.sides.end());
  sides.erase(-1);
  if (pieces.size() > 1) {
    report.apart.push_back({face, static_cast<int>(pieces.size())});
  } else if (sides.size() < plan.mesh.face(face).size()) {
    report.lost_sides.push_back(face);
  }
}

std::string edge_name(int joint) { return numbered("E", joint); }
std::string node_name(int node) { return numbered("N", node); }

}  // namespace planish
