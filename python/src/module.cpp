// SPDX-License-Identifier: MIT
// planish._core: lists, no logic. python/planish/ gives the names that people use.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "edits.hpp"
#include "mesh_arrays.hpp"
#include "mesh_files.hpp"
#include "mobility_run.hpp"
#include "planish/design/design_text.hpp"
#include "planish/design/link_dictionary.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "sweep_run.hpp"

namespace py = pybind11;

namespace planish::python {
namespace {

using namespace planish::library;  // its names are this module's

/// A window into `values`, which `owner` keeps alive; read only.
template <class Value>
py::array window(const Value* values, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<Value> array(std::move(shape), values, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Whatever has bytes, to the file that names their format.
template <class Result>
void save(const Result& result, const std::string& path) {
  save_bytes(path, bytes_of(result, path));
}

/// Errors become exceptions of planish.errors, which words them for Python.
void translate(std::exception_ptr error) {
  const auto raise = [](const char* kind, const char* sentence) {
    const py::module_ errors = py::module_::import("planish.errors");
    PyErr_SetObject(errors.attr(kind).ptr(), errors.attr("wording")(sentence).ptr());
  };
  try {
    if (error) std::rethrow_exception(error);
  } catch (const UsageError& e) {
    raise("UsageError", e.what());
  } catch (const MeshError& e) {
    raise("MeshError", e.what());
  }
}

void bind_mesh(py::module_& module) {
  using Held = std::shared_ptr<OpenMesh>;
  py::class_<OpenMesh, Held>(module, "Mesh")
      .def(py::init([](const Points& points, const Indices& offsets, const Indices& corners) {
        return std::make_shared<OpenMesh>(mesh_of_arrays(points, offsets, corners));
      }))
      .def_static("read", &read_mesh_file, py::call_guard<py::gil_scoped_release>())
      .def(
          "write",
          [](const OpenMesh& self, const std::string& path) {
            check_output_name(path);
            save_bytes(path, mesh_bytes(path, self.mesh));
          },
          py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("points",
                             [](const py::object& self) {
                               const Positions& p = self.cast<const OpenMesh&>().mesh.positions;
                               return window(p.data(), {p.cols(), 3}, self);
                             })
      .def_property_readonly("offsets",
                             [](const py::object& self) {
                               const auto& list = self.cast<const OpenMesh&>().mesh.face_offsets;
                               return window(list.data(), {py::ssize_t(list.size())}, self);
                             })
      .def_property_readonly("corners",
                             [](const py::object& self) {
                               const auto& list = self.cast<const OpenMesh&>().mesh.face_vertices;
                               return window(list.data(), {py::ssize_t(list.size())}, self);
                             })
      .def_readonly("warnings", &OpenMesh::warnings)
      .def("info", [](const OpenMesh& self) {
        return info_json({self.mesh, self.warnings}).dump(2);
      });
}

void bind_shape(py::module_& module) {
  py::class_<Shape>(module, "Shape")
      .def_property_readonly("positions",
                             [](const Shape& self) { return points_array(self.positions); })
      .def_property_readonly(
          "moved",
          [](const Shape& self) { return moved_array(self.base.positions, self.positions); })
      .def_property_readonly(
          "base",
          [](const Shape& self) {
            return std::make_shared<OpenMesh>(mesh_with(self.base, self.base.positions));
          })
      .def_property_readonly(
          "mesh",
          [](const Shape& self) {
            return std::make_shared<OpenMesh>(mesh_with(self.base, self.positions));
          })
      .def_readonly("report", &Shape::report)
      .def_readonly("messages", &Shape::messages)
      .def("save", &save<Shape>);
}

void bind_edit(py::module_& module) {
  py::class_<Edit, std::shared_ptr<Edit>>(module, "Edit")
      .def("shape", py::overload_cast<const Edit&>(&shape_of),
           py::call_guard<py::gil_scoped_release>())
      .def("design", [](const Edit& self) { return write_design(design_of(self)); })
      .def("save", &save<Edit>, py::call_guard<py::gil_scoped_release>())
      .def("explore",
           [](const std::shared_ptr<Edit>& self, const std::string& asked, py::object progress) {
             return run_unlocked(std::move(progress), [&](const Progress& step) {
               return std::make_shared<EditFamily>(make_family(self, asked, step));
             });
           });
  py::class_<EditFamily, std::shared_ptr<EditFamily>>(module, "Family")
      .def_property_readonly(
          "dimension",
          [](const EditFamily& self) { return self.family.found.subspace.dimension(); })
      .def("at", [](const std::shared_ptr<EditFamily>& self, const std::string& asked) {
        return make_variation(self, asked);
      });
  py::class_<EditVariation>(module, "Variation")
      .def("shape", py::overload_cast<const EditVariation&>(&shape_of),
           py::call_guard<py::gil_scoped_release>())
      .def("design", [](const EditVariation& self) { return write_design(design_of(self)); })
      .def("save", &save<EditVariation>, py::call_guard<py::gil_scoped_release>())
      .def("exact", [](const EditVariation& self, py::object progress) {
        return run_unlocked(std::move(progress),
                            [&](const Progress& step) { return make_exact(self, step); });
      });
  module.def("edit", [](const std::shared_ptr<OpenMesh>& mesh, const std::string& asked,
                        py::object progress) {
    return run_unlocked(std::move(progress), [&](const Progress& step) {
      return std::make_shared<Edit>(make_edit(mesh, asked, step));
    });
  });
}

void bind_design(py::module_& module) {
  module.def("link_dictionary", [] { return py::bytes(kLinkDictionary); });
  py::class_<OpenedDesign>(module, "Design")
      .def(py::init(&design_of_text))
      .def_static("load", &open_design)
      .def_property_readonly("text",
                             [](const OpenedDesign& self) { return write_design(self.design); })
      .def_property_readonly(
          "link_text",
          [](const OpenedDesign& self) { return write_design(self.design, FileText::kPlain); })
      .def("save",
           [](const OpenedDesign& self, const std::string& path) { save(self.design, path); })
      .def(
          "replay",
          [](const OpenedDesign& self, const OpenMesh* base, py::object progress) {
            return run_unlocked(std::move(progress), [&](const Progress& step) {
              return make_replay(self, base, step);
            });
          },
          py::arg("base").none(true), py::arg("progress"));
  py::class_<Replayed>(module, "Replay")
      .def_readonly("shape", &Replayed::shape)
      .def_property_readonly("design",
                             [](const Replayed& self) { return write_design(self.design); })
      .def("save", &save<Replayed>, py::call_guard<py::gil_scoped_release>());
}

void bind_sweep(py::module_& module) {
  py::class_<SweepPlan>(module, "Plan")
      .def(py::init(&read_plan), py::call_guard<py::gil_scoped_release>())
      .def("__len__", &SweepPlan::job_count)
      .def("job_id", &SweepPlan::job_id)
      .def("job_values",
           [](const SweepPlan& self, std::size_t k) { return values_text(self.job(k)); })
      .def("run", [](const SweepPlan& self, std::size_t k, const std::string& asked) {
        SweepResult result;
        {
          const py::gil_scoped_release unlocked;
          const workflow::Request request(asked, workflow::type_counting_rows());
          const auto types = workflow::type_counting(request);
          result = run_job(self.job(k), types);
        }
        return py::make_tuple(result.figures, result.design, result.seconds);
      });
  module.def(
      "save_job",
      [](const std::string& folder, const std::string& id, const std::string& figures,
         const std::string& design, const std::string& seconds) {
        save_result(folder, id, {figures, design, seconds});
      },
      py::call_guard<py::gil_scoped_release>());
  module.def(
      "gather",
      [](const std::string& folder, const std::string& path) { save_bytes(path, gather(folder)); },
      py::call_guard<py::gil_scoped_release>());
}

/// A row as Python has it; plain, so that it goes from a worker to its client.
using RowTuple = std::tuple<int, std::array<double, 3>, double, std::string, int, double>;

std::vector<RowTuple> tuples_of(const std::vector<MobilityRow>& rows) {
  std::vector<RowTuple> tuples;
  for (const MobilityRow& row : rows) {
    const Eigen::Vector3d& u = row.direction;
    tuples.emplace_back(row.vertex, std::array{u.x(), u.y(), u.z()}, row.distance,
                        std::string(row.limit), row.remake, row.sharpest_fold);
  }
  return tuples;
}

/// @param tuples keep the words that the rows look at
std::vector<MobilityRow> rows_of(const std::vector<RowTuple>& tuples) {
  std::vector<MobilityRow> rows;
  for (const auto& [vertex, direction, distance, limit, remake, fold] : tuples) {
    rows.push_back(
        {vertex, {direction[0], direction[1], direction[2]}, distance, limit, remake, fold});
  }
  return rows;
}

void bind_mobility(py::module_& module) {
  using Unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<MobilityRun>(module, "Mobility")
      .def(py::init(&make_mobility), Unlocked())
      .def(
          "measure",
          [](MobilityRun& self, const std::vector<int>& vertices) {
            return tuples_of(self.measure(vertices));
          },
          Unlocked())
      .def(
          "save",
          [](const MobilityRun& self, const std::vector<RowTuple>& rows, const std::string& path) {
            save_bytes(path, mobility_bytes(path, self.base().mesh, rows_of(rows)));
          },
          Unlocked());
}

void bind_types(py::module_& module) {
  py::class_<MeshTypes>(module, "Types")
      .def(py::init(&make_types), py::call_guard<py::gil_scoped_release>())
      .def_readonly("report", &MeshTypes::report)
      .def_readonly("messages", &MeshTypes::messages)
      .def_property_readonly("of_panel",
                             [](const MeshTypes& self) {
                               std::vector<int> types;
                               for (const FamilyMember& member : self.plan.types->panels.panels) {
                                 types.push_back(member.family);
                               }
                               return types;
                             })
      .def("save", &save<MeshTypes>);
}

void bind_functions(py::module_& module) {
  module.def(
      "project",
      [](const OpenMesh& mesh, const std::string& asked, const OpenMesh* reference,
         py::object progress) {
        return run_unlocked(std::move(progress), [&](const Progress& step) {
          return make_projection(mesh, asked, reference, step);
        });
      },
      py::arg("mesh"), py::arg("asked"), py::arg("reference").none(true), py::arg("progress"));
  module.def(
      "convert",
      [](const OpenMesh& mesh, const std::string& asked) {
        return std::make_shared<OpenMesh>(make_conversion(mesh, asked));
      },
      py::call_guard<py::gil_scoped_release>());
  module.def("offset", &make_offset, py::call_guard<py::gil_scoped_release>());
  module.def("options", [](const std::string& command) {
    std::vector<std::tuple<std::string, std::string, std::string>> rows;
    for (const OptionRow& row : option_rows(command)) {
      rows.emplace_back(row.name, row.value, row.help);
    }
    return rows;
  });
  module.attr("version") = PLANISH_VERSION;
}

}  // namespace
}  // namespace planish::python

PYBIND11_MODULE(_core, module) {
  using namespace planish::python;
  py::register_exception_translator(&translate);
  bind_mesh(module);
  bind_shape(module);
  bind_edit(module);
  bind_design(module);
  bind_sweep(module);
  bind_mobility(module);
  bind_types(module);
  bind_functions(module);
}
