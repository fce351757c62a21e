// SPDX-License-Identifier: MIT
#include "planish/design/design.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "numeric/crc32.hpp"
#include "planish/design/cut_base.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/shapes/shapes.hpp"
#include "planish/text/number.hpp"
#include "planish/variations/exact_variation.hpp"

namespace planish {
namespace {

/// Vertices that a mark records.
constexpr std::size_t kProbes = 5;

template <class T>
std::string_view bytes_of(const T* values, std::size_t count) {
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

/// `value` as the page rounds it, so that the same result has the same mark everywhere.
double to_twelve_digits(double value) {
  std::string text;
  append_number(text, value, 12);
  return parse_number(text).value_or(value);
}

struct Moved {
  std::vector<int> vertices;  ///< ascending
  Positions positions;        ///< 3 × |vertices|
};

Moved moved_between(const Mesh& base, const Positions& shape) {
  Moved moved;
  for (int v = 0; v < base.vertex_count(); ++v) {
    if (shape.col(v) != base.positions.col(v)) moved.vertices.push_back(v);
  }
  moved.positions = shape(Eigen::all, moved.vertices);
  return moved;
}

std::uint32_t hash_of(const std::vector<int>& vertices, const Positions& positions) {
  const std::uint32_t indices = crc32(bytes_of(vertices.data(), vertices.size()));
  const auto count = static_cast<std::size_t>(positions.size());
  return crc32(bytes_of(positions.data(), count), indices);
}

/// The mesh of the source, or a sentence.
std::variant<Mesh, std::string> source_mesh(const DesignSource& source, const Mesh* given) {
  if (const auto* sample = std::get_if<SampleSource>(&source)) {
    if (auto mesh = make_sample(sample->name, sample->size)) return std::move(*mesh);
    return "there is no sample \"" + sample->name + "\" of size " + std::to_string(sample->size);
  }
  const auto& file = std::get<FileSource>(source);
  if (file.bytes.empty()) {
    if (given != nullptr) return *given;
    return "the design needs its mesh " + (file.name.empty() ? "" : file.name + " ") + "beside it";
  }
  const auto format = format_from_name("." + file.format);
  if (!format) return "source.format must be " + all_extensions("");
  ReadResult read = read_mesh(file.bytes, *format);
  if (auto* error = std::get_if<ReadError>(&read)) return std::move(error->message);
  return std::move(std::get<MeshFile>(read).mesh);
}

/// The flat base of `design`, or a sentence if it cannot be had.
/// @param symmetry set to that of the design, if it has one
std::variant<Mesh, std::string> open_base(const Design& design, const Mesh* given,
                                          const Progress& progress,
                                          std::optional<MeshSymmetry>& symmetry) {
  auto opened = source_mesh(design.source, given);
  if (std::holds_alternative<std::string>(opened)) return opened;
  Mesh& base = std::get<Mesh>(opened);
  if (!design.symmetry.empty()) {
    auto found = find_symmetry(base, {false, design.symmetry});
    if (auto* problem = std::get_if<std::string>(&found)) return std::move(*problem);
    symmetry = std::get<MeshSymmetry>(std::move(found));
  }
  if (design.planarised) {
    const ProjectionResult flat = planarise(base, *design.planarised, progress);
    base.positions(Eigen::all, flat.moved) = flat.moved_positions;
    if (!is_flattened(flat, *design.planarised)) return "the mesh cannot be made flat";
  }
  if (symmetry && !make_symmetric(base, *symmetry, design.options.tolerance, progress).symmetric) {
    return "symmetry: the mesh cannot be made flat and symmetric";
  }
  // Making a mesh flat, or symmetric, rounds differently elsewhere: what the design's mark says of
  // the result is all that can be held against such a base.
  const bool as_opened = !design.planarised && !symmetry;
  const auto* file = std::get_if<FileSource>(&design.source);
  if (as_opened && file != nullptr && file->hash && *file->hash != mesh_hash(base)) {
    return "the mesh is not the one that the design was made on";
  }
  return opened;
}

/// Replays the steps of one design on its base.
class Player {
 public:
  /// @param targets of the design, with their images where there is a symmetry and what cuts added
  Player(Mesh base, const Design& design, const EditTargets& targets,
         std::shared_ptr<const MeshSymmetry> symmetry, const Progress& progress)
      : design_(design), targets_(targets), symmetry_(std::move(symmetry)), progress_(progress) {
    result_.base = std::move(base);
    result_.shape = result_.base.positions;
  }

  /// A sentence if the design does not fit its base.
  /// @param stated its targets without images
  Refusal check(const EditTargets& stated) {
    if (auto problem = find_problem(stated, result_.base)) return problem;
    if (design_.targets.handles.empty()) return std::nullopt;  // it is its base, whatever that is
    if (planarity_summary(result_.base).max_excess > design_.options.tolerance) {
      return "the mesh has panels that are not flat, and the design does not planarise it";
    }
    if (auto broken = find_broken_constraint(result_.base, design_.options)) return broken;
    for (const DesignVariation& variation : design_.variations) {
      for (const int v : variation.close) {
        if (v >= result_.base.vertex_count()) return "variations: close names a vertex too many";
      }
    }
    keeps_ = kept_by_variations(result_.base, targets_, design_.options, symmetry_);
    return std::nullopt;
  }

  void edit() {
    result_.report.status = SolveStatus::kConverged;
    if (design_.targets.handles.empty()) return;
    HandleEditSolver solver(result_.base, design_.options);
    const HandleEditResult edited = symmetry_
                                        ? solver.solve_symmetric(targets_, *symmetry_, progress_)
                                        : solver.solve(targets_, progress_);
    result_.report = edited.report;
    if (edited.report.usable()) result_.shape = apply(result_.base, edited);
  }

  /// False if the shape stays where it was before this variation.
  bool vary(const DesignVariation& variation) {
    if (result_.shape == result_.base.positions) return false;  // variations are around an edit
    SubspaceOptions options = variation.options;
    options.fairness = design_.options.fairness;
    options.engine = design_.options.engine;
    const std::vector<int> close =
        variation.close.empty() ? handle_vertices(design_.targets) : variation.close;
    Subspace found =
        compute_subspace(result_.base, result_.shape, close, options, keeps_, progress_);
    result_.directions.push_back(found.dimension());
    if (found.dimension() == 0) return false;
    result_.centre = result_.shape;
    result_.exact.reset();
    Eigen::VectorXd values = Eigen::VectorXd::Zero(found.dimension());
    const Eigen::Index given = static_cast<Eigen::Index>(variation.coefficients.size());
    for (Eigen::Index k = 0; k < std::min(given, values.size()); ++k) {
      values[k] = variation.coefficients[static_cast<std::size_t>(k)];
    }
    result_.shape = with_sliders(found, values, std::move(result_.shape));
    result_.subspace = std::move(found);
    return !variation.exact || make_exact(variation.exact_fairness);
  }

  Replay finish() {
    result_.mark = mark_of(result_.base, result_.shape);
    if (symmetry_) result_.symmetry = *symmetry_;
    if (design_.result) {
      result_.deviation = planish::deviation(*design_.result, result_.base, result_.shape);
      result_.verified = result_.deviation == 0.0;
      result_.agrees = result_.deviation <= agreement(result_.base);
    }
    return std::move(result_);
  }

 private:
  bool make_exact(double fairness_weight) {
    const ProjectionResult exact =
        planish::make_exact({result_.base, result_.centre, result_.shape}, design_.options,
                            fairness_weight, keeps_, progress_);
    result_.exact = exact.report;
    if (!exact.report.usable()) {
      result_.report = exact.report;
      return false;
    }
    result_.shape(Eigen::all, exact.moved) = exact.moved_positions;
    return true;
  }

  const Design& design_;
  const EditTargets& targets_;
  std::shared_ptr<const MeshSymmetry> symmetry_;  ///< null: none
  const Progress& progress_;
  KeptByVariations keeps_;
  Replay result_;
};

}  // namespace

DesignMark mark_of(const std::vector<int>& vertices, const Positions& positions) {
  const std::size_t count = vertices.size();
  DesignMark mark{
      .hash = hash_of(vertices, positions), .moved = static_cast<int>(count), .probes = {}};
  const std::size_t stride = std::max<std::size_t>(1, count / kProbes);
  for (std::size_t k = stride / 2; k < count && mark.probes.size() < kProbes; k += stride) {
    const Eigen::Vector3d p = positions.col(static_cast<Eigen::Index>(k));
    mark.probes.push_back({vertices[k], p.unaryExpr(&to_twelve_digits)});
  }
  return mark;
}

DesignMark mark_of(const Mesh& base, const Positions& shape) {
  const Moved moved = moved_between(base, shape);
  return mark_of(moved.vertices, moved.positions);
}

double deviation(const DesignMark& mark, const Mesh& base, const Positions& shape) {
  const Moved moved = moved_between(base, shape);
  const bool as_many = static_cast<int>(moved.vertices.size()) == mark.moved;
  if (as_many && hash_of(moved.vertices, moved.positions) == mark.hash) {
    return 0.0;
  }
  double largest = std::numeric_limits<double>::epsilon();
  for (const DesignProbe& probe : mark.probes) {
    if (probe.vertex >= shape.cols()) continue;
    largest = std::max(largest, (shape.col(probe.vertex) - probe.position).norm());
  }
  return largest;
}

double agreement(const Mesh& base) {
  constexpr double kShare = 1e-9;
  if (base.vertex_count() == 0) return 0.0;
  const Eigen::Vector3d extent =
      base.positions.rowwise().maxCoeff() - base.positions.rowwise().minCoeff();
  return kShare * extent.norm();
}

GlbVariations variations_of(const Subspace& subspace) {
  GlbVariations variations{.support = subspace.support, .displacements = {}};
  const auto rows = static_cast<Eigen::Index>(subspace.support.size());
  for (int k = 0; k < subspace.dimension(); ++k) {
    const Eigen::VectorXd move = subspace.scale[k] * subspace.basis.col(k);
    variations.displacements.emplace_back(Eigen::Map<const Positions>(move.data(), 3, rows));
  }
  return variations;
}

namespace {

/// @param stated the targets of the design, with the points that cuts added
/// @param symmetry null: none
std::variant<Replay, std::string> play(Mesh base, std::shared_ptr<const MeshSymmetry> symmetry,
                                       const Design& design, const EditTargets& stated,
                                       const Progress& progress) {
  EditTargets targets = stated;
  if (symmetry) {
    auto all = with_images(stated, base, *symmetry);
    if (auto* problem = std::get_if<std::string>(&all)) return std::move(*problem);
    targets = std::get<EditTargets>(std::move(all));
  }
  Player player(std::move(base), design, targets, std::move(symmetry), progress);
  if (auto problem = player.check(stated)) return std::move(*problem);
  player.edit();
  for (const DesignVariation& variation : design.variations) {
    if (!player.vary(variation)) break;
  }
  return player.finish();
}

}  // namespace

std::variant<Replay, std::string> replay(const Design& design, const Mesh* given,
                                         const Progress& progress) {
  if (auto problem = find_problem(design)) return std::move(*problem);
  std::optional<MeshSymmetry> symmetry;
  auto opened = open_base(design, given, progress, symmetry);
  if (auto* problem = std::get_if<std::string>(&opened)) return std::move(*problem);
  Mesh& base = std::get<Mesh>(opened);
  EditTargets targets = design.targets;
  std::optional<CutMesh> cut;
  if (!design.cuts.empty()) {
    auto made = cut_base(base, design.cuts, symmetry, design.options.tolerance);
    if (auto* problem = std::get_if<std::string>(&made)) return std::move(*problem);
    cut = std::get<CutMesh>(std::move(made));
    base = cut->mesh;
    targets.supports = supports_after_cuts(targets.supports, *cut);
  }
  auto played =
      play(std::move(base), symmetry ? std::make_shared<const MeshSymmetry>(*symmetry) : nullptr,
           design, targets, progress);
  if (auto* done = std::get_if<Replay>(&played)) {
    done->cut = std::move(cut);
    done->supports = std::move(targets.supports);
  }
  return played;
}

std::variant<CutMesh, std::string> cuts_that_left(const Positions& base, const Design& design) {
  auto opened = source_mesh(design.source, nullptr);
  if (auto* problem = std::get_if<std::string>(&opened)) return std::move(*problem);
  Mesh& flat = std::get<Mesh>(opened);
  if (flat.vertex_count() > base.cols()) return "its base has fewer points than its mesh";
  flat.positions = base.leftCols(flat.vertex_count());
  return cut_mesh(flat, design.cuts);
}

std::variant<Replay, std::string> replay_on(Mesh base, std::shared_ptr<const MeshSymmetry> symmetry,
                                            const Design& design, const Progress& progress) {
  if (auto problem = find_problem(design)) return std::move(*problem);
  if (!symmetry && !design.symmetry.empty()) {
    return "symmetry: this base is of a design without one";
  }
  return play(std::move(base), std::move(symmetry), design, design.targets, progress);
}

}  // namespace planish
