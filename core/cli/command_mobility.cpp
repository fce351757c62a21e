// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base_sentences.hpp"
#include "commands.hpp"
#include "mobility_run.hpp"
#include "planish/mobility/best_places.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "terminal.hpp"

namespace planish::cli {
namespace {

/// Vertices that are measured between two words about how far it is.
constexpr std::size_t kChunk = 64;
/// Vertices that --estimate measures.
constexpr std::size_t kSampled = 32;

std::vector<MobilityRow> measure_in_chunks(MobilityRun& run, const std::vector<int>& vertices) {
  std::vector<MobilityRow> rows;
  const bool watched = isatty(STDERR_FILENO) != 0;
  for (std::size_t begin = 0; begin < vertices.size(); begin += kChunk) {
    const std::size_t end = std::min(begin + kChunk, vertices.size());
    const auto measured = run.measure({vertices.begin() + static_cast<std::ptrdiff_t>(begin),
                                       vertices.begin() + static_cast<std::ptrdiff_t>(end)});
    rows.insert(rows.end(), measured.begin(), measured.end());
    if (watched) std::fprintf(stderr, "\r%zu of %zu vertices\033[K", end, vertices.size());
  }
  clear_progress_line();
  return rows;
}

/// What all of `vertices` would take, from some that are spread evenly among them.
Json estimate(MobilityRun& run, const std::vector<int>& vertices) {
  std::vector<int> sampled;
  const std::size_t count = std::min(kSampled, vertices.size());
  for (std::size_t k = 0; k < count; ++k) {
    sampled.push_back(vertices[(2 * k + 1) * vertices.size() / (2 * count)]);
  }
  static_cast<void>(run.measure({sampled.begin(), sampled.begin() + 1}));  // makes the meters
  const Stopwatch watch;
  const auto rows = run.measure(sampled);
  const double each = watch.seconds() / static_cast<double>(count);
  return {{"vertices", vertices.size()},
          {"sampled", count},
          {"threads", run.thread_count()},
          {"seconds_per_vertex", each},
          {"seconds", each * static_cast<double>(vertices.size())}};
}

/// How many places --best asks for; 0: all rows are asked for.
int parse_best(const Arguments& arguments, const std::string& output) {
  const auto text = arguments.value("--best");
  if (!text) return 0;
  const int count = parse_whole(*text, "--best");
  if (count < 1) throw UsageError("--best must be 1 or greater");
  if (output.ends_with(".glb")) throw UsageError("--best lists rows: use .json or .csv");
  return count;
}

ExitCode run_mobility(const Arguments& arguments) {
  const std::string output = arguments.value("-o").value_or("-");
  check_mobility_name(output);
  const int best = parse_best(arguments, output);
  static_cast<void>(mobility_options(arguments));  // wrong ones must not cost a planarising
  const std::string name = arguments.only_positional("MESH");
  const Mesh mesh = load_mesh(name).mesh;
  const std::vector<int> vertices = mobility_vertices(arguments, mesh);
  MobilityRun run(mesh, arguments, name, progress_line());
  clear_progress_line();
  if (const auto sentence = planarised_sentence(run.base())) print_message(name + ": " + *sentence);
  if (arguments.has("--estimate")) {
    if (vertices.empty()) throw UsageError("--part: there is no vertex in it");
    save_bytes(output, estimate(run, vertices).dump(2) + "\n");
    return kDone;
  }
  std::vector<MobilityRow> rows = measure_in_chunks(run, vertices);
  if (best > 0) rows = best_places(build_adjacency(run.base().mesh), std::move(rows), best);
  save_bytes(output, mobility_bytes(output, run.base().mesh, rows));
  if (output != "-") print_message(mobility_sentence(rows));
  return kDone;
}

}  // namespace

Command mobility_command() {
  std::vector<OptionRow> rows = mobility_option_rows();
  rows.push_back({"--estimate", "", "what it would take, from 32 of the vertices"});
  rows.push_back({"--best", "N",
                  "only the N best places to change the shape: up or down, the farthest first,\n"
                  "each 4 edges or more from those before it"});
  rows.push_back({"-o", "OUT", "where the rows go (.json .csv, .glb as colours, - as JSON)"});
  return {"mobility", "MESH [--vertices V,V,...] [--part K/N] [options] -o OUT.json|.csv|.glb",
          "how far each vertex gets, up, down and along the surface, before a panel stops it", rows,
          run_mobility};
}

}  // namespace planish::cli
