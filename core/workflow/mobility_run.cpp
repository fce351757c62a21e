// SPDX-License-Identifier: MIT
#include "mobility_run.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <map>
#include <numeric>
#include <string_view>
#include <thread>

#include "design_input.hpp"
#include "edit_options.hpp"
#include "lengths.hpp"
#include "mesh_files.hpp"
#include "planish/text/number.hpp"
#include "thread_pool.hpp"

namespace planish::workflow {
namespace {

/// Of `edit`, what changes the edits that a path is made of; handles are mobility's own business.
constexpr std::array<std::string_view, 9> kEditRows = {
    "--locality",   "--smoothness", "--softness", "--reach",    "--keep-boundary",
    "--model-unit", "--fairness",   "--sparsity", "--tolerance"};

std::size_t parse_threads(const Request& request) {
  if (const auto stated = stated_threads(request)) return static_cast<std::size_t>(*stated);
  return std::clamp(std::thread::hardware_concurrency(), 1U, unsigned{kMostThreads});
}

Json row_json(const MobilityRow& row) {
  return {{"vertex", row.vertex},
          {"direction", {row.direction.x(), row.direction.y(), row.direction.z()}},
          {"distance", row.distance},
          {"limit", row.limit},
          {"remake", row.remake},
          {"sharpest_fold", row.sharpest_fold}};
}

/// One row a line.
std::string json_of(const std::vector<MobilityRow>& rows) {
  std::string text = "{\"rows\": [";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    text += (k == 0 ? "\n" : ",\n") + row_json(rows[k]).dump();
  }
  return text + "\n]}\n";
}

std::string csv_of(const std::vector<MobilityRow>& rows) {
  std::string text = "vertex,dx,dy,dz,distance,limit,remake,sharpest_fold\n";
  for (const MobilityRow& row : rows) {
    append_integer(text, row.vertex);
    for (const double number :
         {row.direction.x(), row.direction.y(), row.direction.z(), row.distance}) {
      append_exact(text += ',', number);
    }
    text += ',' + std::string(row.limit) + ',';
    append_integer(text, row.remake);
    append_exact(text += ',', row.sharpest_fold);
    text += '\n';
  }
  return text;
}

/// Coloured by the mean of each vertex's distances.
std::string glb_of(const Mesh& mesh, const std::vector<MobilityRow>& rows) {
  GlbContent content;
  content.heat = Eigen::VectorXd::Zero(mesh.vertex_count());
  double most = 0.0;
  for (const MobilityRow& row : rows) {
    (*content.heat)[row.vertex] += row.distance / static_cast<double>(kMobilityRows);
    most = std::max(most, (*content.heat)[row.vertex]);
  }
  if (most > 0.0) *content.heat /= most;
  return write_glb(mesh, content);
}

}  // namespace

std::vector<OptionRow> mobility_option_rows() {
  std::vector<OptionRow> rows = {
      {"--vertices", "V,V,...", "these alone (repeatable); default all"},
      {"--part", "K/N", "the K-th of N parts of them, K from 1"},
      {"--range", "D", "moves are tried up to D (units of the mesh); default the mean edge"},
      {"--steps", "N", "the range in N equal steps, each in quarters at its end; default 8"},
      {"--bound", "NAME=VALUE",
       "as for edit, default shape=on and fold=+10: a panel that reaches one ends\n"
       "the way (repeatable)"},
      kConstraintRow};
  for (const OptionRow& row : edit_option_rows()) {
    if (std::find(kEditRows.begin(), kEditRows.end(), row.name) == kEditRows.end()) continue;
    rows.push_back(row);
    if (row.name == "--reach") {
      rows.back().help = "nothing moves beyond R face rings, or a length such as 1.5m; default 4";
    }
  }
  rows.push_back({"--threads", "N", "default all cores; the result is the same"});
  return rows;
}

MobilityOptions mobility_options(const Request& request) {
  MobilityOptions options;
  const HandleEditOptions defaults = MobilityOptions::default_edit();
  options.edit = edit_options(request);
  if (!request.has("--reach")) options.edit.reach = defaults.reach;
  add_unstated(options.edit.bounds, defaults.bounds);
  if (request.has("--range")) {
    read_length(request, "--range", model_unit(request), options.range);
    if (options.range <= 0.0) throw UsageError("--range must be greater than 0");
  }
  request.read("--steps", options.steps);
  if (const auto problem = find_problem(options)) throw UsageError(*problem);
  return options;
}

std::vector<int> mobility_vertices(const Request& request, const Mesh& mesh) {
  std::vector<int> vertices = parse_vertices(request, "--vertices");
  check_vertices(vertices, "--vertices", mesh);
  if (!request.has("--vertices")) {
    vertices.resize(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto text = request.value("--part");
  if (!text) return vertices;
  const PartRange part = parse_part(*text, vertices.size());
  return {vertices.begin() + static_cast<std::ptrdiff_t>(part.begin),
          vertices.begin() + static_cast<std::ptrdiff_t>(part.end)};
}

MobilityRun::MobilityRun(const Mesh& mesh, const Request& request, const std::string& name,
                         const Progress& progress)
    : options_(mobility_options(request)), thread_count_(parse_threads(request)) {
  base_ = std::make_unique<FlatBase>(flat_base(mesh, options_.edit, progress));
  if (!base_->is_flat()) {
    refuse_file(name, "could not be made flat; planish project says where");
  }
  if (const auto broken = find_broken_constraint(base_->mesh, options_.edit)) {
    refuse_file(name, *broken + "; planish project --constraint makes it so");
  }
}

std::vector<MobilityRow> MobilityRun::measure(const std::vector<int>& vertices) {
  std::vector<MobilityRow> rows(kMobilityRows * vertices.size());
  const std::size_t threads = std::min(thread_count_, vertices.size());
  while (meters_.size() < threads) meters_.emplace_back(base_->mesh, options_);
  std::atomic<std::size_t> next = 0;
  const auto work = [&](std::size_t thread) {
    for (std::size_t k = next++; k < vertices.size(); k = next++) {
      const auto measured = meters_[thread].measure(vertices[k]);
      std::copy(measured.begin(), measured.end(),
                rows.begin() + static_cast<std::ptrdiff_t>(kMobilityRows * k));
    }
  };
  if (threads <= 1) {
    work(0);
    return rows;
  }
  std::vector<std::future<void>> running;
  for (std::size_t k = 0; k < threads; ++k) {
    running.push_back(std::async(std::launch::async, work, k));
  }
  for (std::future<void>& one : running) one.get();
  return rows;
}

void check_mobility_name(const std::string& name) {
  for (const std::string_view ending : {".json", ".csv", ".glb"}) {
    if (name == "-" || name.ends_with(ending)) return;
  }
  throw UsageError(name + ": the extension must be .json, .csv or .glb");
}

std::string mobility_bytes(const std::string& name, const Mesh& mesh,
                           const std::vector<MobilityRow>& rows) {
  check_mobility_name(name);
  if (name.ends_with(".csv")) return csv_of(rows);
  if (name.ends_with(".glb")) return glb_of(mesh, rows);
  return json_of(rows);
}

std::string mobility_sentence(const std::vector<MobilityRow>& rows) {
  std::map<std::string_view, int> counts;
  for (const MobilityRow& row : rows) ++counts[row.limit];
  std::string text = std::to_string(rows.size()) + " directions:";
  for (const auto& [limit, count] : counts) {
    text +=
        (text.back() == ':' ? " " : ", ") + std::to_string(count) + " end at " + std::string(limit);
  }
  return text;
}

}  // namespace planish::workflow
