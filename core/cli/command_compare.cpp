// SPDX-License-Identifier: MIT
#include <ctime>

#include "commands.hpp"
#include "edit_options.hpp"
#include "files.hpp"
#include "planish/comparison/edit_measure.hpp"
#include "planish/comparison/global_subspace.hpp"
#include "planish/comparison/methods.hpp"

namespace planish::cli {
namespace {

using comparison::ComparedEdit;
using comparison::EditMeasure;
using comparison::EditTask;

constexpr int kInnerLimit = 30;     ///< l_max of the product's reference engine
constexpr int kStepBudget = 12000;  ///< steps of alternating minimisation in all

/// The product's own fast engine, measured like the others.
ComparedEdit edit_by_newton(const EditTask& task) {
  const HandleEditResult result = solve_handle_edit(task.mesh, task.targets, task.options);
  return {.positions = apply(task.mesh, result),
          .finished = result.report.status == SolveStatus::kConverged,
          .steps = result.report.iterations,
          .records = result.report.records};
}

ComparedEdit run_method(const std::string& method, const EditTask& task) {
  if (method == "newton") return edit_by_newton(task);
  if (method == "alm") return edit_by_alternation(task, kInnerLimit, kStepBudget);
  if (method == "admm") return edit_by_alternation(task, 1, kStepBudget);
  if (method == "hof10") return edit_one_ring(task);
  if (method == "hk12") return edit_greedily(task);
  if (method == "shapeup") return edit_by_shape_up(task);
  if (method == "yypm11") return edit_in_tangent_space(task);
  throw CommandError(kWrongUsage, "there is no method \"" + method +
                                      "\"; use newton, alm, admm, hof10, hk12, shapeup or yypm11");
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
    list.push_back(
        {record.objective, record.primal_residual, record.dual_residual, record.penalty});
  }
  return list;
}

/// The global basis at the edited mesh, and how far it reaches beyond the edit.
Json basis_json(const EditTask& task, const Positions& edited, int dimension) {
  Mesh flat = task.mesh;
  flat.positions = edited;
  const double start = processor_seconds();
  const Eigen::MatrixXd basis = comparison::global_subspace(flat, dimension, task.options.fairness);
  const double seconds = processor_seconds() - start;
  const Eigen::RowVectorXd edit = (edited - task.mesh.positions).colwise().norm();
  Json correlation = Json::array();
  Json visible = Json::array();
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    const Eigen::RowVectorXd lengths =
        Eigen::Map<const Positions>(basis.col(k).data(), 3, edited.cols()).colwise().norm();
    correlation.push_back(lengths.dot(edit) / edit.norm());
    visible.push_back((lengths.array() > 1e-3 * lengths.maxCoeff()).count());
  }
  return {{"dimension", basis.cols()},
          {"correlation", correlation},
          {"visibly_moved", visible},
          {"processor_seconds", seconds}};
}

ExitCode run(const Arguments& arguments) {
  const auto& words = arguments.positional();
  if (words.size() != 2) throw CommandError(kWrongUsage, "METHOD and MESH are expected");
  const auto output = arguments.value("-o");
  if (output) check_output_name(*output);
  EditTask task;
  task.options = edit_options(arguments);
  task.mesh = flat_base(load_mesh(words[1]).mesh, task.options).mesh;
  task.targets = edit_targets(arguments, task.mesh);
  const double start = processor_seconds();
  const ComparedEdit result = run_method(words[0], task);
  const double seconds = processor_seconds() - start;
  Json json = {{"method", words[0]},
               {"finished", result.finished},
               {"steps", result.steps},
               {"processor_seconds", seconds}};
  json.update(measure_json(comparison::measure(task, result.positions)));
  if (const auto dimension = arguments.value("--dimension")) {
    json["subspace"] = basis_json(task, result.positions, parse_whole(*dimension, "--dimension"));
  }
  if (arguments.has("--records")) json["records"] = records_json(result.records);
  if (output) {
    Mesh edited = task.mesh;
    edited.positions = result.positions;
    GlbContent content;
    content.base = task.mesh.positions;
    save_mesh(*output, edited, content);
  }
  save_report(arguments, json);
  return kDone;
}

}  // namespace

Command compare_command() {
  std::vector<OptionRow> rows = edit_option_rows();
  rows.insert(rows.end(),
              {{"--dimension", "S", "also the global subspace of [YYPM11] at the result"},
               {"--records", "", "objective, residuals and penalty of every outer step"},
               kOutputRow,
               kReportRow});
  return {"compare", "METHOD MESH <edit options> [-o OUT] [--report R.json]",
          "the edit by another method (newton alm admm hof10 hk12 shapeup yypm11), measured alike",
          rows, run};
}

}  // namespace planish::cli
