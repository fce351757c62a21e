// SPDX-License-Identifier: MIT
#include "edit_request.hpp"

#include <utility>

#include "cut_run.hpp"
#include "edit_options.hpp"
#include "fair_run.hpp"
#include "lengths.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/text/number.hpp"
#include "split_run.hpp"
#include "thread_pool.hpp"

namespace planish::workflow {
namespace {

constexpr Words<FewestOf, 2> kFewestWords = {
    {{"panels", FewestOf::kPanels}, {"points", FewestOf::kPoints}}};

/// "V=x,y,z" or "V+=dx,dy,dz" as {"vertex": V, "to" or "by": "x,y,z"}.
Json parts_of_handle(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--handle: \"" + text + "\" is not V=x,y,z or V+=dx,dy,dz");
  }
  const bool relative = text[equals - 1] == '+';
  const std::string vertex = text.substr(0, equals - (relative ? 1 : 0));
  const std::string point = text.substr(equals + 1);
  // Who signs a coordinate means a way, and would be surprised by a place.
  if (!relative && (point.starts_with('+') || point.find(",+") != std::string::npos)) {
    throw UsageError("--handle: \"" + text + "\" is a place: " + vertex +
                     "+=dx,dy,dz moves it by that, " + vertex + "=x,y,z without + moves it there");
  }
  return {{"vertex", vertex}, {relative ? "by" : "to", point}};
}

/// A handle, and whether its target is a way from the base.
std::pair<Handle, bool> parse_handle(const Json& stated, const std::string& unit) {
  const Json parts = stated.is_object() ? stated : parts_of_handle(text_of(stated));
  const bool relative = parts.contains("by");
  const Json vertex = parts.value("vertex", Json());
  const Json point = parts.value(relative ? "by" : "to", Json());
  Handle handle;
  handle.vertex = parse_whole(vertex, "--handle");
  const std::vector<Json> numbers = entries_of(point);
  if (numbers.size() != 3) {
    throw UsageError("--handle: \"" + text_of(vertex) + (relative ? "+=" : "=") + text_of(point) +
                     "\" needs 3 coordinates");
  }
  for (int c = 0; c < 3; ++c) {
    handle.target[c] = parse_length(numbers[static_cast<std::size_t>(c)], "--handle", unit);
  }
  return {handle, relative};
}

/// What --fewest and --within-handle ask for; nullopt without.
std::optional<FewestOptions> fewest_options(const Request& request) {
  const auto of = request.value("--fewest");
  if (!of) {
    if (request.has("--within-handle") && !request.has(kSplitOption)) {
      throw UsageError("--within-handle is for --fewest or --split-where-needed: there is neither");
    }
    return std::nullopt;
  }
  FewestOptions options;
  if (parse_number(*of)) {
    options.most_panels = parse_whole(*of, "--fewest");
    if (options.most_panels < 1) throw UsageError("--fewest must be at least 1 panel");
  } else {
    options.of = parse_word(*of, "--fewest", kFewestWords);
  }
  set_within_handle(request, options.within_handle);
  return options;
}

std::optional<StatedSymmetry> stated_symmetry(const Request& request) {
  const auto text = request.value("--symmetry");
  if (!text) return std::nullopt;
  auto stated = parse_symmetry(*text);
  if (!stated) {
    throw UsageError("--symmetry: \"" + *text + "\" is none of " + std::string(known_symmetries()));
  }
  return stated->is_off() ? std::nullopt : stated;
}

}  // namespace

EditRequest edit_request(const Request& request) {
  // Not in its braces: g++ 12 destroys members twice where an initializer throws.
  EditRequest asked;
  asked.options = edit_options(request);
  asked.options.executor = stated_executor(request, asked.options.engine);
  asked.unit = model_unit(request);
  asked.cuts = cuts_before_edit(request);
  asked.symmetry = stated_symmetry(request);
  asked.fewest = fewest_options(request);
  asked.splits = split_options(request);
  asked.fair = asks_for_fair(request);
  asked.types = type_counting(request);
  for (const Json& stated : request.values("--handle")) {
    const auto [handle, relative] = parse_handle(stated, asked.unit);
    asked.targets.handles.push_back(handle);
    asked.relative.push_back(relative);
  }
  asked.targets.pins = parse_vertices(request, "--pin");
  asked.targets.supports = parse_supports(request);
  request.read("--continuation", asked.targets.continuation);
  if (const auto problem =
          find_engine_problem(asked.options, asked.targets, asked.symmetry.has_value())) {
    throw UsageError(*problem);
  }
  return asked;
}

EditTargets edit_targets(const EditRequest& asked, const Mesh& base, const CutMesh* cut) {
  EditTargets targets = asked.targets;
  check_vertices(handle_vertices(targets), "--handle", base);
  for (std::size_t k = 0; k < targets.handles.size(); ++k) {
    auto& [vertex, target] = targets.handles[k];
    if (asked.relative[k]) target += base.positions.col(vertex);
  }
  check_vertices(targets.pins, "--pin", base);
  if (targets.handles.empty()) throw UsageError("--handle is missing");
  EditTargets carried = targets;
  if (cut != nullptr) carried.supports = supports_after_cuts(targets.supports, *cut);
  if (const auto problem = find_problem(carried, base)) throw UsageError(*problem);
  return targets;
}

}  // namespace planish::workflow
