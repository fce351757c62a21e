// SPDX-License-Identifier: MIT
/// Keep-outs as text, their rules, and what they leave free: who reads designs needs no more.
#include "planish/obstacles/keep_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "planish/text/number.hpp"

namespace planish {
namespace {

struct KeepOutForm {
  std::string_view name;
  std::size_t numbers;
};

/// In the order of KeepOut::Kind.
constexpr std::array<KeepOutForm, 6> kForms = {
    {{"below", 1}, {"above", 1}, {"plane", 4}, {"box", 6}, {"self", 0}, {"mesh", 0}}};

const KeepOutForm& form_of(const KeepOut& keep_out) {
  return kForms[static_cast<std::size_t>(keep_out.kind)];
}

Refusal find_problem(const KeepOut& keep_out) {
  if (keep_out.kind == KeepOut::Kind::kMesh) {
    auto problem = find_problem(keep_out.mesh);
    return problem ? "keep_out: mesh" + *problem : std::optional<std::string>();
  }
  const std::string name = "keep_out: " + std::string(form_of(keep_out).name);
  const auto& numbers = keep_out.numbers;
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) {
    return name + " must be finite";
  }
  if (keep_out.kind == KeepOut::Kind::kBox) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(numbers[c] < numbers[c + 3])) return name + ": its first corner must be the lower one";
    }
  }
  if (keep_out.kind != KeepOut::Kind::kPlane) return std::nullopt;
  const double length = Eigen::Map<const Eigen::Vector3d>(numbers.data()).norm();
  if (!(length > 0.0) || !std::isfinite(length)) return name + ": its direction has no length";
  return std::nullopt;
}

HalfSpace free_side(const KeepOut& keep_out) {
  const auto& numbers = keep_out.numbers;
  if (keep_out.kind == KeepOut::Kind::kBelow) return {Eigen::Vector3d::UnitZ(), numbers[0]};
  if (keep_out.kind == KeepOut::Kind::kAbove) return {-Eigen::Vector3d::UnitZ(), -numbers[0]};
  const Eigen::Map<const Eigen::Vector3d> normal(numbers.data());
  const double length = normal.norm();
  return {-normal / length, -numbers[3] / length};
}

KeptBox box_of(const KeepOut& keep_out, double clearance) {
  const Eigen::Map<const Eigen::Vector3d> low(keep_out.numbers.data());
  const Eigen::Map<const Eigen::Vector3d> high(keep_out.numbers.data() + 3);
  return {0.5 * (low + high), Eigen::Vector3d(0.5 * (high - low)).asDiagonal(), clearance};
}

/// Adds the panels of `mesh`.
void append_walls(const ContextMesh& mesh, std::vector<Eigen::Matrix3Xd>& walls) {
  for (const std::vector<int>& panel : mesh.panels) {
    Eigen::Matrix3Xd wall(3, static_cast<Eigen::Index>(panel.size()));
    for (std::size_t k = 0; k < panel.size(); ++k) {
      wall.col(static_cast<Eigen::Index>(k)) =
          Eigen::Map<const Eigen::Vector3d>(mesh.points[static_cast<std::size_t>(panel[k])].data());
    }
    walls.push_back(std::move(wall));
  }
}

}  // namespace

std::optional<KeepOut> parse_keep_out(std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const KeepOutForm& one) {
    return one.name == text.substr(0, equals);
  });
  if (form == kForms.end()) return std::nullopt;
  KeepOut keep_out;
  keep_out.kind = static_cast<KeepOut::Kind>(form - kForms.begin());
  if (keep_out.kind == KeepOut::Kind::kMesh) {
    if (equals == std::string_view::npos) return std::nullopt;
    auto mesh = parse_context_mesh(text.substr(equals + 1));
    if (!mesh) return std::nullopt;
    keep_out.mesh = std::move(*mesh);
    return keep_out;
  }
  std::size_t count = 0;
  for (std::size_t begin = equals; begin != std::string_view::npos; ++count) {
    const std::size_t comma = text.find(',', begin + 1);
    const auto number = parse_number(text.substr(begin + 1, comma - begin - 1));
    if (!number || count == form->numbers) return std::nullopt;
    keep_out.numbers[count] = *number;
    begin = comma;
  }
  return count == form->numbers ? std::optional(keep_out) : std::nullopt;
}

std::string keep_out_text(const KeepOut& keep_out) {
  std::string text(form_of(keep_out).name);
  if (keep_out.kind == KeepOut::Kind::kMesh) append_context_mesh(keep_out.mesh, text += '=');
  char mark = '=';
  for (std::size_t k = 0; k < form_of(keep_out).numbers; ++k) {
    append_exact(text += mark, keep_out.numbers[k]);
    mark = ',';
  }
  return text;
}

std::string_view known_keep_outs() {
  return "below=Z, above=Z, plane=a,b,c,d, box=x0,y0,z0,x1,y1,z1, self, mesh=FILE";
}

Refusal find_problem(const std::vector<KeepOut>& keep_outs) {
  constexpr std::size_t kMost = 64;
  if (keep_outs.size() > kMost) return "keep_out: at most 64";
  std::size_t panels = 0;
  for (const KeepOut& keep_out : keep_outs) {
    if (auto problem = find_problem(keep_out)) return problem;
    panels += keep_out.mesh.panels.size();
  }
  if (panels > kMostContextPanels) {
    return "keep_out: mesh: at most " + std::to_string(kMostContextPanels) + " panels, here are " +
           std::to_string(panels);
  }
  return std::nullopt;
}

FreeSpace free_space(const std::vector<KeepOut>& keep_outs, double clearance) {
  FreeSpace free;
  free.wall_clearance = clearance;
  for (const KeepOut& keep_out : keep_outs) {
    if (keep_out.kind == KeepOut::Kind::kSelf) {
      free.apart = clearance;
    } else if (keep_out.kind == KeepOut::Kind::kMesh) {
      append_walls(keep_out.mesh, free.walls);
    } else if (keep_out.kind == KeepOut::Kind::kBox) {
      free.boxes.push_back(box_of(keep_out, clearance));
    } else {
      free.sides.push_back(free_side(keep_out));
      free.sides.back().bound += clearance;
    }
  }
  return free;
}

}  // namespace planish
