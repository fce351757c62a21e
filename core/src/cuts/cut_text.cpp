// SPDX-License-Identifier: MIT
/// Cuts as text, and the rules that hold on whatever mesh.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "planish/cuts/cut.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

constexpr std::string_view kCollar = ":collar";

std::optional<int> parse_index(std::string_view text) {
  const auto number = parse_integer(text);
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(*number);
}

/// The words before and behind the first `mark`; nullopt where there is none.
std::optional<std::pair<std::string_view, std::string_view>> parted(std::string_view text,
                                                                    char mark) {
  const std::size_t place = text.find(mark);
  if (place == std::string_view::npos) return std::nullopt;
  return std::pair(text.substr(0, place), text.substr(place + 1));
}

/// Takes "@T" from the end of `text`; `otherwise` where it has none, nullopt where T is no number.
std::optional<double> take_share(std::string_view& text, double otherwise) {
  const auto words = parted(text, '@');
  if (!words) return otherwise;
  text = words->first;
  return parse_number(words->second);
}

/// "V" or "V-W@T".
std::optional<OutlinePlace> parse_place(std::string_view text) {
  const auto at_share = parted(text, '@');
  if (!at_share) {
    const auto vertex = parse_index(text);
    return vertex ? std::optional(OutlinePlace{*vertex}) : std::nullopt;
  }
  const auto ends = parted(at_share->first, '-');
  if (!ends) return std::nullopt;
  const auto from = parse_index(ends->first), to = parse_index(ends->second);
  const auto share = parse_number(at_share->second);
  if (!from || !to || !share) return std::nullopt;
  return OutlinePlace{*from, *to, *share};
}

std::optional<Cut> parse_split(std::string_view text) {
  const auto words = parted(text, ':');
  const auto places = words ? parted(words->second, ',') : std::nullopt;
  if (!places) return std::nullopt;
  const auto panel = parse_index(words->first);
  const auto start = parse_place(places->first), end = parse_place(places->second);
  if (!panel || !start || !end) return std::nullopt;
  return SplitCut{*panel, *start, *end};
}

std::optional<Cut> parse_strip(std::string_view text) {
  const auto share = take_share(text, StripCut::kShare);
  const auto ends = parted(text, '-');
  if (!ends) return std::nullopt;
  const auto from = parse_index(ends->first), to = parse_index(ends->second);
  if (!from || !to || !share) return std::nullopt;
  return StripCut{*from, *to, *share};
}

std::optional<Cut> parse_corner(std::string_view text) {
  const auto share = take_share(text, CornerCut::kShare);
  const auto words = parted(text, ':');
  if (!words) return std::nullopt;
  const auto panel = parse_index(words->first), vertex = parse_index(words->second);
  if (!panel || !vertex || !share) return std::nullopt;
  return CornerCut{*panel, *vertex, *share};
}

std::optional<Cut> parse_refine(std::string_view text) {
  RefineCut cut;
  cut.collar = text.ends_with(kCollar);
  if (cut.collar) text.remove_suffix(kCollar.size());
  for (;;) {
    const auto words = parted(text, ',');
    const auto panel = parse_index(words ? words->first : text);
    if (!panel) return std::nullopt;
    cut.panels.push_back(*panel);
    if (!words) return cut;
    text = words->second;
  }
}

std::optional<Cut> parse_trim(std::string_view text) {
  TrimCut cut;
  for (std::size_t k = 0; k < cut.plane.size(); ++k) {
    const auto words = parted(text, ',');
    const auto number = parse_number(words ? words->first : text);
    if (!number || words.has_value() == (k + 1 == cut.plane.size())) return std::nullopt;
    cut.plane[k] = *number;
    if (words) text = words->second;
  }
  return cut;
}

struct CutForm {
  std::string_view name, form;
  std::optional<Cut> (*parse)(std::string_view text);
};

/// In the order of the alternatives of Cut.
constexpr std::array<CutForm, std::variant_size_v<Cut>> kForms = {
    {{"split", "split=F:A,B (A and B: a corner V, or V-W@T on a side)", parse_split},
     {"strip", "strip=V-W@T", parse_strip},
     {"corner", "corner=F:V@T", parse_corner},
     {"refine", "refine=F,F,... or refine=F,F,...:collar", parse_refine},
     {"trim", "trim=a,b,c,d", parse_trim}}};

std::string place_text(const OutlinePlace& place) {
  std::string text = std::to_string(place.vertex);
  if (place.to < 0) return text;
  append_integer(text += '-', place.to);
  append_exact(text += '@', place.share);
  return text;
}

/// "@T" unless it goes without saying.
void append_share(std::string& text, double share, double otherwise) {
  if (share != otherwise) append_exact(text += '@', share);
}

std::string value_text(const SplitCut& cut) {
  return std::to_string(cut.panel) + ":" + place_text(cut.start) + "," + place_text(cut.end);
}

std::string value_text(const StripCut& cut) {
  std::string text = std::to_string(cut.from) + "-" + std::to_string(cut.to);
  append_share(text, cut.share, StripCut::kShare);
  return text;
}

std::string value_text(const CornerCut& cut) {
  std::string text = std::to_string(cut.panel) + ":" + std::to_string(cut.vertex);
  append_share(text, cut.share, CornerCut::kShare);
  return text;
}

std::string value_text(const RefineCut& cut) {
  std::string text;
  for (const int panel : cut.panels) {
    if (!text.empty()) text += ',';
    append_integer(text, panel);
  }
  return cut.collar ? text.append(kCollar) : text;
}

std::string value_text(const TrimCut& cut) {
  std::string text;
  for (std::size_t k = 0; k < cut.plane.size(); ++k) {
    if (k > 0) text += ',';
    append_exact(text, cut.plane[k]);
  }
  return text;
}

bool is_share(double share) { return share >= kLeastShare && share <= 1.0 - kLeastShare; }

constexpr const char* kBadShare =
    "the share T must be above 0 and below 1, by a millionth at least";

Refusal problem_of(const OutlinePlace& place) {
  if (place.vertex < 0) return "a corner must be a whole number from 0";
  if (place.to < 0) return std::nullopt;
  if (place.vertex == place.to) return "a side needs two ends";
  return is_share(place.share) ? std::nullopt : std::optional<std::string>(kBadShare);
}

Refusal problem_of(const SplitCut& cut) {
  if (cut.panel < 0) return "a panel must be a whole number from 0";
  if (Refusal problem = problem_of(cut.start)) return problem;
  if (Refusal problem = problem_of(cut.end)) return problem;
  return cut.start == cut.end ? std::optional<std::string>("A and B are one place") : std::nullopt;
}

Refusal problem_of(const StripCut& cut) {
  return problem_of(OutlinePlace{cut.from, std::max(cut.to, 0), cut.share});
}

Refusal problem_of(const CornerCut& cut) {
  if (cut.panel < 0 || cut.vertex < 0) return "panels and corners are whole numbers from 0";
  if (cut.share == 1.0 || is_share(cut.share)) return std::nullopt;
  return std::string(kBadShare) + ", or 1";
}

Refusal problem_of(const RefineCut& cut) {
  if (cut.panels.empty()) return "it needs a panel";
  std::vector<int> sorted = cut.panels;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front() < 0) return "a panel must be a whole number from 0";
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return std::nullopt;
  return "panel " + std::to_string(*twice) + " is named twice";
}

Refusal problem_of(const TrimCut& cut) {
  const auto& plane = cut.plane;
  if (!std::all_of(plane.begin(), plane.end(), [](double x) { return std::isfinite(x); })) {
    return "its numbers must be finite";
  }
  const double length = Eigen::Map<const Eigen::Vector3d>(plane.data()).norm();
  if (length > 0.0 && std::isfinite(length) && std::isfinite(plane[3] / length)) {
    return std::nullopt;
  }
  return "the plane's direction has no length";
}

}  // namespace

std::variant<Cut, std::string> parse_cut(std::string_view text) {
  const auto words = parted(text, '=');
  const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const CutForm& one) {
    return words && one.name == words->first;
  });
  if (form == kForms.end()) {
    return quoted(text) + " is no cut: there are " + std::string(known_cuts());
  }
  const std::optional<Cut> cut = form->parse(words->second);
  if (!cut) return quoted(text) + " is not of the form " + std::string(form->form);
  if (Refusal problem = find_problem(*cut)) return *problem;
  return *cut;
}

std::string cut_text(const Cut& cut) {
  const std::string value = std::visit([](const auto& one) { return value_text(one); }, cut);
  return std::string(kForms[cut.index()].name) + "=" + value;
}

std::string_view known_cuts() {
  return "split=F:A,B, strip=V-W@T, corner=F:V@T, refine=F,F,... and trim=a,b,c,d";
}

Refusal find_problem(const Cut& cut) {
  const Refusal problem = std::visit([](const auto& one) { return problem_of(one); }, cut);
  if (!problem) return std::nullopt;
  constexpr std::size_t kLongest = 48;
  return printable(cut_text(cut), kLongest) + ": " + *problem;
}

}  // namespace planish
