// SPDX-License-Identifier: MIT
/// The list of what the npm package sees: core/library as JavaScript objects. Everything that can
/// fail returns {value} or {kind, sentence}, because an exception would arrive without its text.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "edits.hpp"
#include "mesh_files.hpp"
#include "mobility_run.hpp"
#include "mobility_values.hpp"
#include "open_mesh.hpp"
#include "planish/design/design_text.hpp"
#include "planish/measures/metrics.hpp"
#include "report.hpp"

namespace {

using emscripten::val;
using namespace planish;
using namespace planish::library;  // its names are this module's

val refusal(const char* kind, const std::string& sentence) {
  val answer = val::object();
  answer.set("kind", std::string(kind));
  answer.set("sentence", sentence);
  return answer;
}

/// What `operation` gives, or why it gives nothing.
template <class Operation>
val answer(const Operation& operation) {
  try {
    val result = val::object();
    result.set("value", operation());
    return result;
  } catch (const UsageError& error) {
    return refusal("usage", error.what());
  } catch (const MeshError& error) {
    return refusal("mesh", error.what());
  } catch (const std::bad_alloc&) {
    return refusal("internal", "There is not enough memory for this mesh.");
  } catch (const std::exception& error) {
    return refusal("internal", std::string("Internal error: ") + error.what());
  }
}

/// @param callback (step, objective, residual) → whether to go on; null: nobody watches
Progress to_progress(const val& callback) {
  if (callback.isNull()) return {};
  return [callback, step = 0](const IterationRecord& record) mutable {
    const bool on = callback(step++, record.objective, record.primal_residual).as<bool>();
    return on ? Flow::kContinue : Flow::kStop;
  };
}

template <class T>
std::shared_ptr<T> shared(T value) {
  return std::make_shared<T>(std::move(value));
}

val mesh_of_arrays(const val& points, const val& offsets, const val& corners) {
  return answer([&] {
    return shared(mesh_of_lists(to_positions(points), to_indices(offsets), to_indices(corners)));
  });
}
val sample_mesh(const std::string& name) {
  return answer([&] { return shared(read_mesh_file("sample:" + name)); });
}
val read_mesh(const std::string& name, const val& bytes) {
  return answer([&] { return shared(read_mesh_bytes(name, to_bytes(bytes))); });
}

using MeshHold = std::shared_ptr<OpenMesh>;
using EditHold = std::shared_ptr<Edit>;
using FamilyHold = std::shared_ptr<EditFamily>;

val edit(const MeshHold& mesh, const std::string& asked, const val& progress) {
  return answer([&] { return shared(make_edit(mesh, asked, to_progress(progress))); });
}
val explore(const EditHold& edit, const std::string& asked, const val& progress) {
  return answer([&] { return shared(make_family(edit, asked, to_progress(progress))); });
}
val variation(const FamilyHold& family, const std::string& asked) {
  return answer([&] { return shared(make_variation(family, asked)); });
}
val exact(const EditVariation& variation, const val& progress) {
  return answer([&] { return shared(make_exact(variation, to_progress(progress))); });
}
/// @param reference null for none
val project(const MeshHold& mesh, const std::string& asked, const MeshHold& reference,
            const val& progress) {
  return answer([&] {
    return shared(make_projection(*mesh, asked, reference.get(), to_progress(progress)));
  });
}
/// {value} with what `make` makes of a mesh alone.
template <auto make>
val made(const OpenMesh& mesh, const std::string& asked) {
  return answer([&] { return shared(make(mesh, asked)); });
}
/// @param limit keeps the word that the row looks at
MobilityRow to_row(const val& value, const std::string& limit) {
  const val direction = value["direction"];
  return {value["vertex"].as<int>(),
          {direction[0].as<double>(), direction[1].as<double>(), direction[2].as<double>()},
          value["distance"].as<double>(),
          limit,
          value["remake"].as<int>(),
          value["sharpestFold"].as<double>()};
}
/// Four rows for each of `vertices`, in their order.
val measure_mobility(MobilityRun& run, const val& vertices) {
  return answer([&] {
    const std::vector<int> list = to_indices(vertices);
    const int count = run.base().mesh.vertex_count();
    for (const int v : list) {
      if (v >= 0 && v < count) continue;
      throw UsageError("--vertices: there is no vertex " + std::to_string(v) + " among " +
                       std::to_string(count));
    }
    return to_value(run.measure(list));
  });
}
/// The file of rows that were measured. @param name .json, .csv or .glb
val mobility_file(const MobilityRun& run, const val& values, const std::string& name) {
  return answer([&] {
    const auto list = emscripten::vecFromJSArray<val>(values);
    std::vector<std::string> limits;
    for (const val& value : list) limits.push_back(value["limit"].as<std::string>());
    std::vector<MobilityRow> rows;
    for (std::size_t k = 0; k < list.size(); ++k) rows.push_back(to_row(list[k], limits[k]));
    return copy(mobility_bytes(name, run.base().mesh, rows));
  });
}
val read_design_text(const std::string& text) {
  return answer([&] { return shared(design_of_text(text)); });
}
val replay_design(const OpenedDesign& design, const MeshHold& base, const val& progress) {
  return answer([&] { return shared(make_replay(design, base.get(), to_progress(progress))); });
}

/// {value} with the shape of an edit or a variation.
template <class Result>
val shape(const Result& result) {
  return answer([&] { return shared(shape_of(result)); });
}
template <class Result>
val bytes(const Result& result, const std::string& name) {
  return answer([&] { return copy(bytes_of(result, name)); });
}
val mesh_file(const OpenMesh& mesh, const std::string& name) {
  return answer([&] { return copy(mesh_bytes(name, mesh.mesh)); });
}

val option_table(const std::string& command) {
  return answer([&] {
    return list_of(option_rows(command), [](const OptionRow& row) {
      val entry = val::object();
      entry.set("name", std::string(row.name));
      entry.set("value", std::string(row.value));
      entry.set("help", std::string(row.help));
      return entry;
    });
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_package) {
  using emscripten::class_;
  using emscripten::function;
  class_<OpenMesh>("Mesh")
      .smart_ptr<MeshHold>("MeshHold")
      .function(
          "points", +[](const OpenMesh& m) { return copy(m.mesh.positions); })
      .function(
          "faceOffsets", +[](const OpenMesh& m) { return copy(m.mesh.face_offsets); })
      .function(
          "faceVertices", +[](const OpenMesh& m) { return copy(m.mesh.face_vertices); })
      .function(
          "warnings", +[](const OpenMesh& m) { return val::array(m.warnings); })
      .function(
          "info",
          +[](const OpenMesh& m) {
            return info_json({m.mesh, m.warnings}).dump();
          })
      .function("bytes", &mesh_file);
  class_<Shape>("Shape")
      .smart_ptr<std::shared_ptr<Shape>>("ShapeHold")
      .function(
          "positions", +[](const Shape& s) { return copy(s.positions); })
      .function(
          "moved",
          +[](const Shape& s) { return copy(moved_vertices(s.base.positions, s.positions)); })
      .function(
          "base", +[](const Shape& s) { return shared(mesh_with(s.base, s.base.positions)); })
      .function(
          "report", +[](const Shape& s) { return s.report; })
      .function(
          "messages", +[](const Shape& s) { return val::array(s.messages); })
      .function("bytes", &bytes<Shape>);
  class_<Edit>("Edit")
      .smart_ptr<EditHold>("EditHold")
      .function("shape", &shape<Edit>)
      .function("bytes", &bytes<Edit>);
  class_<EditFamily>("Family")
      .smart_ptr<FamilyHold>("FamilyHold")
      .function(
          "dimension", +[](const EditFamily& f) { return f.family.found.subspace.dimension(); });
  class_<EditVariation>("Variation")
      .smart_ptr<std::shared_ptr<EditVariation>>("VariationHold")
      .function("exact", &exact)
      .function("shape", &shape<EditVariation>)
      .function("bytes", &bytes<EditVariation>);
  class_<MobilityRun>("Mobility")
      .smart_ptr<std::shared_ptr<MobilityRun>>("MobilityHold")
      .function("measure", &measure_mobility)
      .function("bytes", &mobility_file);
  class_<MeshTypes>("Types")
      .smart_ptr<std::shared_ptr<MeshTypes>>("TypesHold")
      .function(
          "report", +[](const MeshTypes& t) { return t.report; })
      .function(
          "messages", +[](const MeshTypes& t) { return val::array(t.messages); })
      .function("bytes", &bytes<MeshTypes>);
  class_<OpenedDesign>("Design")
      .smart_ptr<std::shared_ptr<OpenedDesign>>("DesignHold")
      .function(
          "text", +[](const OpenedDesign& d) { return write_design(d.design); })
      .function("replay", &replay_design);
  class_<Replayed>("Replay")
      .smart_ptr<std::shared_ptr<Replayed>>("ReplayHold")
      .function(
          "shape", +[](const Replayed& r) { return shared(Shape(r.shape)); })
      .function("bytes", &bytes<Replayed>);
  function("meshOfArrays", &mesh_of_arrays);
  function("sampleMesh", &sample_mesh);
  function("readMesh", &read_mesh);
  function("edit", &edit);
  function("explore", &explore);
  function("variation", &variation);
  function("project", &project);
  function("convert", &made<make_conversion>);
  function("offset", &made<make_offset>);
  function("mobility", &made<make_mobility>);
  function("types", &made<make_types>);
  function("readDesign", &read_design_text);
  function("options", &option_table);
}
