// SPDX-License-Identifier: MIT
#include "planish/design/design.hpp"

#include <algorithm>
#include <iterator>
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

std::uint32_t hash_of(const SparseShape& shape) {
  const std::uint32_t indices = crc32(bytes_of(shape.moved.data(), shape.moved.size()));
  const auto count = static_cast<std::size_t>(shape.positions.size());
  return crc32(bytes_of(shape.positions.data(), count), indices);
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

/// A sentence if `design` does not fit the base that it is to be done again on.
/// @param stated its targets without images
Refusal find_misfit(const Design& design, const Mesh& base, const EditTargets& stated) {
  if (auto problem = find_problem(stated, base)) return problem;
  if (design.targets.handles.empty()) return std::nullopt;  // it is its base, whatever that is
  if (planarity_summary(base).max_excess > design.options.tolerance) {
    return "the mesh has panels that are not flat, and the design does not planarise it";
  }
  if (auto broken = find_broken_constraint(base, design.options)) return broken;
  for (const DesignVariation& variation : design.variations) {
    for (const int v : variation.close) {
      if (v >= base.vertex_count()) return "variations: close names a vertex too many";
    }
  }
  return std::nullopt;
}

/// False if the shape stays where it was before this variation.
bool vary(const DesignSteps& steps, const DesignVariation& variation, const Progress& progress,
          Replay& done) {
  if (steps.find_no_variations(done.shape)) return false;
  VariationFamily found = steps.explore(done.shape, variation.options, variation.close, progress);
  done.directions.push_back(found.subspace.dimension());
  if (found.subspace.dimension() == 0) return false;
  const std::vector<double>& values = variation.coefficients;
  done.shape = found.shape_at(Eigen::VectorXd::Map(values.data(), std::ssize(values)));
  done.family = std::move(found);
  done.exact.reset();
  if (!variation.exact) return true;
  const ProjectionResult exact =
      steps.make_exact(&*done.family, done.shape, variation.exact_fairness, progress);
  done.exact = exact.report;
  if (!exact.report.usable()) {
    done.report = exact.report;
    return false;
  }
  done.shape(Eigen::all, exact.moved) = exact.moved_positions;
  return true;
}

}  // namespace

DesignMark mark_of(const SparseShape& shape) {
  const std::size_t count = shape.moved.size();
  DesignMark mark{.hash = hash_of(shape), .moved = static_cast<int>(count), .probes = {}};
  const std::size_t stride = std::max<std::size_t>(1, count / kProbes);
  for (std::size_t k = stride / 2; k < count && mark.probes.size() < kProbes; k += stride) {
    const Eigen::Vector3d p = shape.positions.col(static_cast<Eigen::Index>(k));
    mark.probes.push_back({shape.moved[k], p.unaryExpr(&to_twelve_digits)});
  }
  return mark;
}

DesignMark mark_of(const Mesh& base, const Positions& shape) {
  return mark_of(difference(base, shape));
}

double deviation(const DesignMark& mark, const Mesh& base, const Positions& shape) {
  const SparseShape moved = difference(base, shape);
  const bool as_many = static_cast<int>(moved.moved.size()) == mark.moved;
  if (as_many && hash_of(moved) == mark.hash) return 0.0;
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
  Replay done;
  done.base = std::move(base);
  done.shape = done.base.positions;
  done.report.status = SolveStatus::kConverged;
  const DesignSteps steps(done.base, design.options, stated, std::move(symmetry));
  if (steps.image_problem()) return *steps.image_problem();
  if (auto problem = find_misfit(design, done.base, stated)) return std::move(*problem);
  if (!design.targets.handles.empty()) {
    const HandleEditResult edited = steps.edit(progress);
    done.report = edited.report;
    if (edited.report.usable()) done.shape = apply(done.base, edited);
  }
  for (const DesignVariation& variation : design.variations) {
    if (!vary(steps, variation, progress, done)) break;
  }
  done.mark = mark_of(done.base, done.shape);
  if (steps.symmetry() != nullptr) done.symmetry = *steps.symmetry();
  if (design.result) {
    done.deviation = deviation(*design.result, done.base, done.shape);
    done.verified = done.deviation == 0.0;
    done.agrees = done.deviation <= agreement(done.base);
  }
  return done;
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
