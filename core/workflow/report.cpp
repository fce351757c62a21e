// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planish/fabrication/remake.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/motion.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/text/number.hpp"

namespace planish::workflow {
namespace {

/// The most serious first.
constexpr std::array<std::pair<PanelDamage, const char*>, 4> kDamages = {
    {{PanelDamage::kSelfCrossing, "self-crossing"},
     {PanelDamage::kTurnedOver, "turned over"},
     {PanelDamage::kCollapsed, "collapsed"},
     {PanelDamage::kConcave, "concave"}}};

}  // namespace

Json mesh_json(const Mesh& mesh) {
  const MeshSummary summary = summarize(mesh);
  Json sizes = Json::object();
  for (const auto& [size, count] : summary.face_sizes) sizes[std::to_string(size)] = count;
  return {{"vertices", summary.vertices},
          {"faces", summary.faces},
          {"face_sizes", sizes},
          {"boundary_loops", summary.boundary_loops},
          {"components", summary.components},
          {"mean_edge", summary.mean_edge},
          {"degrees_of_freedom", degrees_of_freedom(mesh)},
          {"nonmanifold_edges", summary.nonmanifold_edges},
          {"isolated_vertices", summary.isolated_vertices}};
}

Json planarity_json(const Mesh& mesh, const Positions& before, const Positions& after) {
  const PlanaritySummary now = planarity_summary(mesh, after);
  return {{"before_max", planarity_summary(mesh, before).max},
          {"after_max", now.max},
          {"after_mean", now.mean}};
}

Json damage_json(const Mesh& mesh, const Positions& before, const Positions& after) {
  std::map<PanelDamage, std::vector<int>> found;
  for (int f = 0; f < mesh.face_count(); ++f) {
    found[panel_damage(before, after, mesh.face(f))].push_back(f);
  }
  Json json = Json::object();
  for (const auto& [kind, name] : kDamages) {
    if (const auto panels = found.find(kind); panels != found.end()) json[name] = panels->second;
  }
  return json;
}

Json fold_json(const Mesh& base, const Positions& after) {
  const Adjacency adjacency = build_adjacency(base);
  const std::vector<int> touched = faces_of(adjacency, moved_vertices(base.positions, after));
  return {{"before", sharpest_fold(base, adjacency, base.positions, touched).degrees},
          {"after", sharpest_fold(base, adjacency, after, touched).degrees},
          {"growth", largest_fold_growth(base, adjacency, base.positions, after, touched)}};
}

Json motion_json(const Mesh& base, const Positions& after) {
  const std::vector<int> moved = moved_vertices(base.positions, after);
  const MotionRange range = range_of(motions(base, build_adjacency(base), moved, after));
  return {{"shape_max", range.shape()}, {"slide_max", range.slide}};
}

/// The faces are those of `base`, so that what is not near a changed vertex need not be compared.
Json remake_json(const Mesh& base, const Positions& after) {
  const std::vector<int> changed = moved_vertices(base.positions, after);
  const Adjacency adjacency = build_adjacency(base);
  const Remake remake{panels_to_remake(base, adjacency, after, changed),
                      nodes_to_remake(base, adjacency, after, changed)};
  return {{"outline", remake.count(PanelChange::kOutline)},
          {"bevel", remake.count(PanelChange::kBevel)},
          {"nodes_moved", remake.count(NodeChange::kMoved)},
          {"nodes_arms", remake.count(NodeChange::kArms)}};
}

Json info_json(const MeshFile& file) {
  const PlanaritySummary planarity = planarity_summary(file.mesh);
  Json json = {{"status", "done"}, {"mesh", mesh_json(file.mesh)}};
  const Eigen::Vector3d least = file.mesh.positions.rowwise().minCoeff();
  const Eigen::Vector3d most = file.mesh.positions.rowwise().maxCoeff();
  json["extent"] = {{"min", {least.x(), least.y(), least.z()}},
                    {"max", {most.x(), most.y(), most.z()}}};
  json["planarity_mm_per_m"] = {{"max", planarity.max},
                                {"mean", planarity.mean},
                                {"max_gap", planarity.max_gap},
                                {"worst_face", planarity.worst_face},
                                {"worst_gap", planarity.worst_gap}};
  const auto found = find_symmetry(file.mesh, {.automatic = true, .elements = {}});
  if (const auto* symmetry = std::get_if<MeshSymmetry>(&found)) {
    json["symmetry"] = symmetry_json(*symmetry, file.mesh, file.mesh.positions);
  }
  json["warnings"] = file.warnings;
  return json;
}

std::optional<std::string> outcome_sentence(const SolveReport& report) {
  if (report.status == SolveStatus::kInfeasibleHandles) {
    return "stopped " + three_digits(report.handle_error) +
           " short of a target (units of the mesh): flat panels within the bounds were not found "
           "any nearer";
  }
  if (report.status == SolveStatus::kIterationLimit) {
    constexpr double kRounding = 1e-6;  // of the largest move
    const std::string short_of =
        report.handle_error > kRounding * report.max_displacement
            ? ", " + three_digits(report.handle_error) + " short of a target (units of the mesh)"
            : "";
    return "not converged" + short_of +
           ": every panel is as it should be, but the result is not certified to be the best one "
           "near";
  }
  return std::nullopt;
}

std::vector<std::string> said(std::initializer_list<std::optional<std::string>> sentences) {
  std::vector<std::string> all;
  for (const auto& sentence : sentences) {
    if (sentence) all.push_back(*sentence);
  }
  return all;
}

std::optional<std::string> damage_words(const Json& damage) {
  std::string words;
  for (const auto& [name, panels] : damage.items()) {
    words += (words.empty() ? "" : ", ") + std::to_string(panels.size()) + " " + name;
  }
  return words.empty() ? std::nullopt : std::optional(words);
}

std::optional<std::string> damage_sentence(const Json& damage) {
  const auto words = damage_words(damage);
  return words ? std::optional("flat, but spoilt: " + *words) : std::nullopt;
}

std::optional<std::string> fold_sentence(const Json& fold) {
  constexpr double kNotable = 20.0;  // degrees
  const double growth = fold["growth"].get<double>();
  if (growth <= kNotable) return std::nullopt;
  const double before = fold["before"].get<double>(), after = fold["after"].get<double>();
  const std::string sharpest =
      three_digits(after) + " degrees, " + three_digits(before) + " before";
  // It is another one that grew where the sharpest did not.
  return (after > before + kNotable / 2.0
              ? "sharpest fold " + sharpest
              : "a fold got " + three_digits(growth) + " degrees sharper (the sharpest is " +
                    sharpest + ")") +
         ": --softness bends more gently, --bound fold=MAX limits it";
}

Json subspace_json(const SubspaceReport& report, int dimension) {
  Json certificates = Json::array();
  for (const Optimality& one : report.certificates) certificates.push_back(optimality_json(one));
  return {{"dimension", dimension},
          {"status", status_name(report.status)},
          {"certificates", certificates},
          {"orthonormality_error", report.orthonormality_error},
          {"tangency_error", report.tangency_error},
          {"correlation", report.correlation},
          {"fairness", report.fairness},
          {"edit_fairness", report.edit_fairness},
          {"support_sizes", report.support_sizes}};
}

Json violations_json(const std::vector<KindViolation>& violations) {
  Json json = Json::array();
  for (const KindViolation& one : violations) {
    json.push_back({{"kind", one.kind},
                    {"unit", one.unit},
                    {"before_max", one.before_max},
                    {"after_max", one.after_max}});
  }
  return json;
}

Json optimality_json(const Optimality& optimality) {
  return {{"stationarity", optimality.stationarity},
          {"outside", optimality.outside},
          {"complementarity", optimality.complementarity},
          {"certified_vertices", optimality.certified_vertices}};
}

void add_solve(Json& json, const SolveReport& report, Engine engine) {
  json["status"] = status_name(report.status);
  json["solver"] = engine == Engine::kNewton ? "newton" : "alm";
  json["objective"] = {{"total", report.objective.total()},
                       {"handle", report.objective.handle},
                       {"sparsity", report.objective.sparsity},
                       {"fairness", report.objective.fairness}};
  if (!report.violations.empty()) json["violations"] = violations_json(report.violations);
  for (const BoundStanding& bound : report.bounds) {
    json["bounds"].push_back({{"name", bound.name}, {"binding", bound.binding}});
  }
  json["moved_vertices"] = report.moved_vertices;
  json["max_displacement"] = report.max_displacement;
  json["handle_error"] = report.handle_error;
  json["iterations"] = report.cost.steps;
  json["factorizations"] = report.cost.factorizations;
  if (report.optimality) json["optimality"] = optimality_json(*report.optimality);
  json["seconds"] = {{"setup", report.setup_seconds}, {"solve", report.solve_seconds}};
}

Json symmetry_json(const MeshSymmetry& symmetry, const Mesh& base, const Positions& after) {
  Json elements = Json::array();
  for (const SymmetryElement& element : symmetry.elements) {
    elements.push_back(symmetry_text(element));
  }
  return {{"elements", elements},
          {"images", symmetry.operations.size()},
          {"asymmetry_mean_edges", asymmetry(symmetry, base, after)}};
}

std::string support_name(const PointSupport& support) {
  PointSupport named = support;
  named.surface = {};  // its points are not what it is called
  return point_support_text(named);
}

void add_supports(Json& json, const std::vector<PointSupport>& supports, const Mesh& base,
                  const Positions& after) {
  for (const PointSupport& support : supports) {
    json["supports"].push_back({{"name", support_name(support)},
                                {"distance_max", largest_distance(support, base, after)}});
  }
}

}  // namespace planish::workflow
