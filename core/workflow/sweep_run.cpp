// SPDX-License-Identifier: MIT
#include "sweep_run.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <system_error>
#include <variant>

#include "design_input.hpp"
#include "mesh_files.hpp"
#include "planish/design/design.hpp"
#include "planish/design/design_text.hpp"
#include "replay_run.hpp"
#include "report.hpp"

namespace planish::workflow {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kIdLength = 32;

/// Columns of the table after the values: their names, and where in the report they stand.
constexpr std::array<std::pair<const char*, const char*>, 17> kColumns = {
    {{"status", "/status"},
     {"message", "/message"},
     {"moved_vertices", "/moved_vertices"},
     {"max_displacement", "/max_displacement"},
     {"shape_max", "/motion/shape_max"},
     {"slide_max", "/motion/slide_max"},
     {"handle_error", "/handle_error"},
     {"objective", "/objective/total"},
     {"sharpest_fold_before", "/sharpest_fold/before"},
     {"sharpest_fold_after", "/sharpest_fold/after"},
     {"remake_outline", "/remake/outline"},
     {"remake_bevel", "/remake/bevel"},
     {"remake_nodes_moved", "/remake/nodes_moved"},
     {"remake_nodes_arms", "/remake/nodes_arms"},
     {"planarity_mm_per_m", "/planarity_mm_per_m/after_max"},
     {"iterations", "/iterations"},
     {"design", "/design"}}};

/// Columns behind kColumns where types of panels were counted.
constexpr std::array<std::pair<const char*, const char*>, 2> kTypeColumns = {
    {{"types_before", "/types/before"}, {"types_after", "/types/after"}}};

/// The columns of the table of `results`.
std::vector<std::pair<const char*, const char*>> columns_of(const std::vector<Json>& results) {
  std::vector<std::pair<const char*, const char*>> columns(kColumns.begin(), kColumns.end());
  const bool counted = std::any_of(results.begin(), results.end(),
                                   [](const Json& one) { return one.contains("types"); });
  if (counted) columns.insert(columns.end(), kTypeColumns.begin(), kTypeColumns.end());
  return columns;
}

std::string path_of(const std::string& folder, const std::string& id, const char* ending) {
  return (fs::path(folder) / (id + ending)).string();
}

/// RFC 4180; numbers and words as JSON writes them, without quotation marks.
std::string cell(const Json& value) {
  if (value.is_null()) return "";
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted(1, '"');
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  quoted += '"';
  return quoted;
}

bool is_result_name(const std::string& name) {
  return name.size() == kIdLength + 5 && name.ends_with(".json") &&
         name.find_first_not_of("0123456789abcdef") == kIdLength;
}

/// The results in a folder, ordered by id.
std::vector<Json> results_in(const std::string& folder) {
  std::error_code error;
  std::set<std::string> names;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (is_result_name(at->path().filename().string())) names.insert(at->path().string());
  }
  if (error) throw MeshError(folder + ": cannot be listed");
  std::vector<Json> results;
  for (const std::string& name : names) {
    results.push_back(Json::parse(load_bytes(name), nullptr, false));
    const Json& last = results.back();
    if (!last.is_object() || !last.contains("values") || !last["values"].is_object()) {
      refuse_file(name, "is no result of a sweep");
    }
  }
  return results;
}

}  // namespace

SweepPlan read_plan(const std::string& text) {
  auto plan = SweepPlan::read(text);
  if (const auto* why = std::get_if<std::string>(&plan)) throw UsageError(*why);
  return std::get<SweepPlan>(std::move(plan));
}

std::string values_text(const SweepJob& job) {
  Json json = Json::object();
  for (const auto& [field, value] : job.values) json[field] = Json::parse(value);
  return json.dump();
}

SweepResult run_job(const SweepJob& job, const std::optional<TypeCounting>& types) {
  Json json = {{"id", job.id}, {"values", Json::parse(values_text(job))}};
  const auto refused = [&](const std::string& sentence) {
    json["status"] = "refused";
    json["message"] = sentence;
    return SweepResult{json.dump(2) + "\n", "", "{}\n"};
  };
  const auto read = read_design(job.design);
  if (const auto* why = std::get_if<std::string>(&read)) return refused(*why);
  Design design = std::get<Design>(read);
  auto replayed = replay(design);
  if (const auto* why = std::get_if<std::string>(&replayed)) return refused(*why);
  const Replay& done = std::get<Replay>(replayed);
  Json report = replay_json(design, done);
  Json seconds = report["seconds"];
  for (const char* key : {"seconds", "verified", "deviation"}) report.erase(key);
  json.update(report);
  if (types) json["types"] = type_change_json(*types, done.base, done.shape);
  json["design"] = job.id + ".design.json";
  design.result = done.mark;
  return {json.dump(2) + "\n", write_design(design) + "\n", seconds.dump() + "\n"};
}

void save_result(const std::string& folder, const std::string& id, const SweepResult& result) {
  std::error_code error;
  fs::create_directories(folder, error);  // what is wrong with it, the files say
  if (!result.design.empty()) save_bytes(path_of(folder, id, ".design.json"), result.design);
  save_bytes(path_of(folder, id, ".seconds"), result.seconds);
  save_bytes(path_of(folder, id, ".json"), result.figures);
}

bool is_done(const std::string& folder, const std::string& id) {
  std::error_code error;
  return fs::exists(path_of(folder, id, ".json"), error);
}

std::string gather(const std::string& folder) {
  const std::vector<Json> results = results_in(folder);
  std::set<std::string> fields;
  for (const Json& result : results) {
    for (const auto& [field, value] : result["values"].items()) fields.insert(field);
  }
  std::string table = "id";
  const auto add = [&](const std::string& text) { (table += ',') += text; };
  for (const std::string& field : fields) add(cell(field));
  const auto columns = columns_of(results);
  for (const auto& [name, where] : columns) add(name);
  table += '\n';
  for (const Json& result : results) {
    table += cell(result.value("id", Json()));
    for (const std::string& field : fields) add(cell(result["values"].value(field, Json())));
    for (const auto& [name, where] : columns) {
      add(cell(result.value(Json::json_pointer(where), Json())));
    }
    table += '\n';
  }
  return table;
}

}  // namespace planish::workflow
