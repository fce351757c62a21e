// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

#include "commands.hpp"
#include "sweep_run.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

/// Prints one line a job: its id and its values, separated by tabs.
void print_jobs(const SweepPlan& plan) {
  for (std::size_t k = 0; k < plan.job_count(); ++k) {
    const SweepJob job = plan.job(k);
    std::string line = job.id;
    for (const auto& [field, value] : job.values) line += "\t" + field + "=" + value;
    std::cout << line << '\n';
  }
  std::cout.flush();
}

PartRange find_job(const SweepPlan& plan, const std::string& id) {
  for (std::size_t k = 0; k < plan.job_count(); ++k) {
    if (plan.job_id(k) == id) return {k, k + 1};
  }
  throw UsageError("--job: there is no job \"" + id + "\" in the plan");
}

void run_jobs(const SweepPlan& plan, const PartRange& range, const std::string& folder,
              const std::optional<TypeCounting>& types) {
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const std::string id = plan.job_id(k);
    if (!is_done(folder, id)) save_result(folder, id, run_job(plan.job(k), types));
  }
}

ExitCode run_sweep(const Arguments& arguments) {
  const auto job = arguments.value("--job");
  const auto part = arguments.value("--part");
  if (arguments.has("--list") + job.has_value() + part.has_value() != 1) {
    throw UsageError("one of --list, --job ID and --part K/N is expected");
  }
  const auto folder = arguments.value("-o");
  if (!folder && !arguments.has("--list")) throw UsageError("-o DIR is missing");
  const std::optional<TypeCounting> types = type_counting(arguments);
  const SweepPlan plan = read_plan(load_bytes(arguments.only_positional("PLAN.json")));
  if (arguments.has("--list")) {
    print_jobs(plan);
  } else if (job && is_done(*folder, *job)) {
    return kDone;
  } else {
    run_jobs(plan, job ? find_job(plan, *job) : parse_part(*part, plan.job_count()), *folder,
             types);
  }
  return kDone;
}

ExitCode run_gather(const Arguments& arguments) {
  const auto output = arguments.value("-o");
  if (!output) throw UsageError("-o results.csv is missing");
  save_bytes(*output, gather(arguments.only_positional("DIR")));
  return kDone;
}

}  // namespace

Command sweep_command() {
  std::vector<OptionRow> rows = {{"--list", "", "one line a job: its id and its values"},
                                 {"--job", "ID", "do this one; nothing where DIR has it already"},
                                 {"--part", "K/N", "do the K-th of N parts of the plan, K from 1"},
                                 {"-o", "DIR", "where <id>.json and <id>.design.json go"}};
  for (OptionRow& row : type_counting_rows()) rows.push_back(std::move(row));
  return {"sweep", "PLAN.json --list | --job ID -o DIR | --part K/N -o DIR",
          "many designs from one: what there is to do, or one of it, or one of N parts", rows,
          run_sweep};
}

Command gather_command() {
  return {"gather",
          "DIR -o results.csv",
          "the table of a sweep: the same bytes in whatever order the jobs ran",
          {{"-o", "results.csv", "where the table goes (or -)"}},
          run_gather};
}

}  // namespace planish::cli
