// SPDX-License-Identifier: MIT
/// What can be done to the panels of a mesh without moving a point, as values and as text.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/text/refusal.hpp"

namespace planish {

/// A corner of a panel, or a point on one of its sides.
struct OutlinePlace {
  int vertex = 0;      ///< the corner; or where the side begins
  int to = -1;         ///< where the side ends; -1: the place is the corner
  double share = 0.0;  ///< of the way from `vertex` to `to`

  friend bool operator==(const OutlinePlace&, const OutlinePlace&) = default;
};

/// "split=F:A,B": a line from A to B parts panel F. The part that its outline from A to B bounds
/// keeps the number.
struct SplitCut {
  int panel = 0;
  OutlinePlace start, end;

  friend bool operator==(const SplitCut&, const SplitCut&) = default;
};

/// "strip=V-W@T": a line of points through the quads on both sides of the edge from V to W, at a
/// share of the way from it, until the boundary, a panel that is no quad, or itself. The parts on
/// V's side keep their numbers.
struct StripCut {
  static constexpr double kShare = 0.5;
  int from = 0, to = 0;
  double share = kShare;

  friend bool operator==(const StripCut&, const StripCut&) = default;
};

/// "corner=F:V@T": a triangle with V parts from panel F, its other corners at a share of the two
/// sides from V. At 1 they are the next corners. The rest keeps the number.
struct CornerCut {
  static constexpr double kShare = 1.0;
  int panel = 0, vertex = 0;
  double share = kShare;

  friend bool operator==(const CornerCut&, const CornerCut&) = default;
};

/// "refine=F,F,...": as many quads as each panel has corners, about the mean of the corners.
/// "refine=F,F,...:collar": panels beside them are split, too, so that none has a straight corner.
struct RefineCut {
  std::vector<int> panels;
  bool collar = false;

  friend bool operator==(const RefineCut&, const RefineCut&) = default;
};

/// "trim=a,b,c,d": what lies where a·x + b·y + c·z > d goes.
struct TrimCut {
  std::array<double, 4> plane{};

  friend bool operator==(const TrimCut&, const TrimCut&) = default;
};

using Cut = std::variant<SplitCut, StripCut, CornerCut, RefineCut, TrimCut>;

/// Shares of a side are this far from its ends at least.
inline constexpr double kLeastShare = 1e-6;

/// One of the forms above; or one sentence that names the text.
[[nodiscard]] std::variant<Cut, std::string> parse_cut(std::string_view text);

/// The text that parse_cut() reads, with the same bits; shares that go without saying are left out.
[[nodiscard]] std::string cut_text(const Cut& cut);

/// The forms of all cuts, for messages.
[[nodiscard]] std::string_view known_cuts();

/// The first rule that `cut` breaks on whatever mesh; nullopt if none. What parse_cut() gives
/// breaks none.
[[nodiscard]] Refusal find_problem(const Cut& cut);

}  // namespace planish
