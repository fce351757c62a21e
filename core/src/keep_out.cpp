// SPDX-License-Identifier: MIT
/// Keep-outs as text, their rules, and what they leave free: who reads designs needs no more.
#include "planish/keep_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "planish/io/number.hpp"

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

Refusal find_problem(const ContextMesh& mesh) {
  if (mesh.panels.empty()) return "keep_out: mesh: it has no panels";
  const auto is_finite = [](const auto& point) {
    return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
  };
  if (!std::all_of(mesh.points.begin(), mesh.points.end(), is_finite)) {
    return "keep_out: mesh must be finite";
  }
  const int count = static_cast<int>(mesh.points.size());
  for (const std::vector<int>& panel : mesh.panels) {
    const bool known =
        std::all_of(panel.begin(), panel.end(), [&](int v) { return v >= 0 && v < count; });
    if (!known || panel.size() < 3) {
      return "keep_out: mesh: a panel has three or more of its " + std::to_string(count) +
             " points (from 0)";
    }
  }
  return std::nullopt;
}

Refusal find_problem(const KeepOut& keep_out) {
  if (keep_out.kind == KeepOut::Kind::kMesh) return find_problem(keep_out.mesh);
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

/// What stands between marks: calls `take` with each part, until it returns false.
template <class Take>
bool for_each_part(std::string_view text, char mark, const Take& take) {
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(mark, begin);
    if (!take(text.substr(begin, end - begin))) return false;
    if (end == std::string_view::npos) return true;
    begin = end + 1;
  }
}

bool parse_point(std::string_view text, std::array<double, 3>& point) {
  std::size_t count = 0;
  const bool read = for_each_part(text, ',', [&](std::string_view word) {
    const auto number = parse_number(word);
    if (!number || count == point.size()) return false;
    point[count++] = *number;
    return true;
  });
  return read && count == point.size();
}

bool parse_panel(std::string_view text, std::vector<int>& panel) {
  return for_each_part(text, ',', [&](std::string_view word) {
    const auto vertex = parse_integer(word);
    if (!vertex || *vertex < 0 || *vertex > std::numeric_limits<int>::max()) return false;
    panel.push_back(static_cast<int>(*vertex));
    return true;
  });
}

/// "x,y,z;x,y,z;x,y,z/0,1,2;0,2,3"
std::optional<ContextMesh> parse_context(std::string_view text) {
  ContextMesh mesh;
  const std::size_t stroke = text.find('/');
  if (stroke == std::string_view::npos) return std::nullopt;
  const bool points = for_each_part(text.substr(0, stroke), ';', [&](std::string_view part) {
    return parse_point(part, mesh.points.emplace_back());
  });
  const bool panels = points && for_each_part(text.substr(stroke + 1), ';', [&](auto part) {
                        return parse_panel(part, mesh.panels.emplace_back());
                      });
  return panels ? std::optional(std::move(mesh)) : std::nullopt;
}

void append_context(std::string& text, const ContextMesh& mesh) {
  char mark = '=';
  for (const auto& point : mesh.points) {
    for (const double x : point) {
      append_exact(text += mark, x);
      mark = ',';
    }
    mark = ';';
  }
  mark = '/';
  for (const std::vector<int>& panel : mesh.panels) {
    for (const int v : panel) {
      (text += mark) += std::to_string(v);
      mark = ',';
    }
    mark = ';';
  }
}

/// Its panels, behind those that are there.
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
    auto mesh = parse_context(text.substr(equals + 1));
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
  if (keep_out.kind == KeepOut::Kind::kMesh) append_context(text, keep_out.mesh);
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
