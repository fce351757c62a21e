// SPDX-License-Identifier: MIT
#include <ctime>

#include "commands.hpp"
#include "edit_options.hpp"
#include "edit_run.hpp"
#include "planish/comparison/edit_measure.hpp"
#include "planish/comparison/global_subspace.hpp"
#include "planish/comparison/methods.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/subspace.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

using comparison::ComparedEdit;
using comparison::EditMeasure;
using comparison::EditTask;

constexpr int kInnerLimit = 30;     ///< l_max of the product's reference engine
constexpr int kStepBudget = 12000;  ///< steps of alternating minimisation in all

/// An edit as `planish edit` makes it, exact finish included.
ComparedEdit edit_by_product(const EditTask& task) {
  const HandleEditResult result = solve_handle_edit(task.mesh, task.targets, task.options);
  return {.positions = apply(task.mesh, result),
          .finished = result.report.status == SolveStatus::kConverged,
          .steps = result.report.cost.steps,
          .records = result.report.records};
}

ComparedEdit run_method(const std::string& method, const EditTask& task) {
  if (method == "newton" || method == "reference") return edit_by_product(task);
  if (method == "alm") return edit_by_alternation(task, kInnerLimit, kStepBudget);
  if (method == "admm") return edit_by_alternation(task, 1, kStepBudget);
  if (method == "hof10") return edit_one_ring(task);
  if (method == "hk12") return edit_greedily(task);
  if (method == "shapeup") return edit_by_shape_up(task);
  if (method == "yypm11") return edit_in_tangent_space(task);
  throw UsageError("there is no method \"" + method +
                   "\"; use newton, reference, alm, admm, hof10, hk12, shapeup or yypm11");
}

/// Processor time of this process, seconds: a busy machine does not count.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Json measure_json(const EditMeasure& measure) {
  return {{"moved_vertices", measure.moved},
          {"visibly_moved", measure.moved_visibly},
          {"displacement_l21", measure.displacement},
          {"fairness", measure.fairness},
          {"objective", measure.objective},
          {"planarity_mm_per_m", measure.planarity},
          {"handle_error", measure.handle_error},
          {"edge_strain", measure.edge_strain},
          {"fold_change_degrees", measure.fold_change}};
}

Json records_json(const std::vector<IterationRecord>& records) {
  Json list = Json::array();
  for (const IterationRecord& record : records) {
    Json entry = {{"objective", record.objective}, {"primal_residual", record.primal_residual}};
    if (record.penalty > 0.0) {
      entry["dual_residual"] = record.dual_residual;
      entry["penalty"] = record.penalty;
    } else {
      entry["step"] = record.step;
      entry["smoothing"] = record.smoothing;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

/// How far vectors reach beyond the edit: 3n × s, interleaved by vertex.
Json reach_json(const Eigen::MatrixXd& basis, const Positions& base, const Positions& edited) {
  const Eigen::RowVectorXd edit = (edited - base).colwise().norm();
  Json correlation = Json::array();
  Json visible = Json::array();
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    const Eigen::RowVectorXd lengths =
        Eigen::Map<const Positions>(basis.col(k).data(), 3, edited.cols()).colwise().norm();
    correlation.push_back(lengths.dot(edit) / edit.norm());
    visible.push_back((lengths.array() > 1e-3 * lengths.maxCoeff()).count());
  }
  return {{"dimension", basis.cols()}, {"correlation", correlation}, {"visibly_moved", visible}};
}

/// (8) on the mesh explored with every slider at 0.5.
Json compared_projection_json(const EditTask& task, Mesh edited, const Subspace& subspace) {
  Positions rows;
  evaluate(subspace, Eigen::VectorXd::Constant(subspace.dimension(), 0.5), rows);
  for (std::size_t k = 0; k < subspace.support.size(); ++k) {
    edited.positions.col(subspace.support[k]) = rows.col(static_cast<Eigen::Index>(k));
  }
  ProjectionOptions options;
  options.engine = task.options.engine;
  options.keep_shape = task.options.keep_shape;
  const double start = processor_seconds();
  const ProjectionResult result = project_to_planar(edited, task.mesh.positions, options);
  const double seconds = processor_seconds() - start;
  return {{"before_mm_per_m", planarity_summary(edited).max},
          {"after_mm_per_m", result.report.planarity_after},
          {"processor_seconds", seconds}};
}

/// The family of (7), that of [YYPM11], and (8), each at the edited mesh and timed.
void add_exploration(const EditTask& task, const Positions& positions, int dimension, Json& json) {
  Mesh edited = task.mesh;
  edited.positions = positions;
  std::vector<int> close;
  for (const Handle& handle : task.targets.handles) close.push_back(handle.vertex);
  SubspaceOptions options{.dimension = dimension, .engine = task.options.engine};
  options.fairness = task.options.fairness;
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  double start = processor_seconds();
  const Subspace subspace = compute_subspace(task.mesh, positions, close, options);
  const double local_seconds = processor_seconds() - start;
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(positions.size(), subspace.basis.cols());
  for (std::size_t k = 0; k < subspace.support.size(); ++k) {
    local.middleRows<3>(3 * subspace.support[k]) =
        subspace.basis.middleRows<3>(3 * static_cast<Eigen::Index>(k));
  }
  start = processor_seconds();
  const Eigen::MatrixXd global =
      comparison::global_subspace(edited, dimension, task.options.fairness);
  const double global_seconds = processor_seconds() - start;
  json["family"] = reach_json(local, task.mesh.positions, positions);
  json["family"]["processor_seconds"] = local_seconds;
  json["global_family"] = reach_json(global, task.mesh.positions, positions);
  json["global_family"]["processor_seconds"] = global_seconds;
  json["projection"] = compared_projection_json(task, edited, subspace);
}

ExitCode run_compare(const Arguments& arguments) {
  const auto& words = arguments.positional();
  if (words.size() != 2) throw UsageError("METHOD and MESH are expected");
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  EditTask task;
  const EditRequest asked = edit_request(arguments);
  task.options = asked.options;
  task.options.engine = words[0] == "newton" ? Engine::kNewton : Engine::kAugmentedLagrangian;
  task.mesh = flat_base(load_mesh(words[1]).mesh, task.options, progress_line()).mesh;
  clear_progress_line();
  task.targets = edit_targets(asked, task.mesh);
  const double start = processor_seconds();
  const ComparedEdit result = run_method(words[0], task);
  const double seconds = processor_seconds() - start;
  Json json = {{"method", words[0]},
               {"finished", result.finished},
               {"steps", result.steps},
               {"processor_seconds", seconds}};
  json.update(measure_json(comparison::measure(task, result.positions)));
  if (const auto dimension = arguments.value("--dimension")) {
    add_exploration(task, result.positions, parse_whole(*dimension, "--dimension"), json);
  }
  if (arguments.has("--records")) json["records"] = records_json(result.records);
  if (output) save_bytes(*output, moved_mesh_bytes(*output, task.mesh, result.positions));
  save_report(arguments, json);
  return kDone;
}

}  // namespace

Command compare_command() {
  std::vector<OptionRow> rows = edit_option_rows();
  rows.insert(rows.end(),
              {{"--dimension", "S", "also families of variations at the result, and a projection"},
               {"--records", "", "what was measured in every outer step"},
               output_row(),
               kReportRow});
  return {"compare", "METHOD MESH <edit options> [-o OUT] [--report R.json]",
          "the edit by another method (newton reference alm admm hof10 hk12 shapeup yypm11), "
          "measured alike",
          rows, run_compare};
}

}  // namespace planish::cli
