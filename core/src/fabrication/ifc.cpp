// SPDX-License-Identifier: MIT
#include "planish/fabrication/ifc.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "fabrication/plan_header.hpp"
#include "fabrication/step_file.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/fabrication/inset.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A value that is not given.
StepValue nothing() { return {"$"}; }

/// What an identifier is of; the numbers must never change.
enum class Identified : std::uint32_t {
  kProject = 1,
  kSite = 2,
  kBuilding = 3,
  kWall = 4,
  kSiteInProject = 5,
  kBuildingInSite = 6,
  kWallInBuilding = 7,
  kPlatesInWall = 8,
  kPlate = 9,
  kPlateProperties = 10,
  kPlateHasProperties = 11,
  kPlateType = 12,
  kPlatesOfType = 13,
};

/// A permutation of the 64-bit numbers (splitmix64's finaliser).
std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// 128 bits in the 64 characters of an IfcGloballyUniqueId. Within one identity no two are equal.
StepValue identifier(std::uint32_t identity, Identified what, int number) {
  constexpr std::string_view kDigits =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  const std::uint64_t thing =
      static_cast<std::uint64_t>(what) << 32 | static_cast<std::uint32_t>(number);
  const std::uint64_t low = scrambled(thing ^ static_cast<std::uint64_t>(identity) << 40);
  std::uint64_t high = scrambled(low ^ scrambled(identity));
  std::uint64_t rest = low;
  std::string text(22, '0');
  for (std::size_t k = text.size(); k-- > 0;) {
    text[k] = kDigits[rest & 63u];
    rest = rest >> 6 | high << 58;
    high >>= 6;
  }
  return {std::string("'").append(text).append("'")};
}

StepValue words(std::string_view type, const StepValue& value) {
  return {std::string(type).append("(").append(value.text).append(")")};
}

template <typename Vector>
StepValue reals(const Vector& v) {
  std::vector<StepValue> values;
  for (const double x : v) values.push_back(step_real(x));
  return step_list(values);
}

class IfcWriter {
 public:
  explicit IfcWriter(const CuttingPlan& plan) : plan_(plan) {}

  IfcModel write() {
    add_setting();
    std::vector<StepValue> plates;
    std::vector<std::vector<StepValue>> of_type(plan_.types ? plan_.types->panels.types.size() : 0);
    const bool is_surface = plan_.options.gap == 0.0 && plan_.options.thickness == 0.0;
    if (is_surface) points_ = add_points();
    for (int f = 0; f < plan_.mesh.face_count(); ++f) {
      if (plan_.drawn[at(f)] == 0) continue;
      const auto shapes = is_surface ? std::vector{add_polygon(f)} : add_cut_panel(f);
      if (shapes.empty()) {
        model_.report.vanished.push_back(f);
      } else {
        plates.push_back(step_reference(add_plate(f, shapes, is_surface)));
        if (plan_.types)
          of_type[at(plan_.types->panels.panels[at(f)].family)].push_back(plates.back());
      }
    }
    add_types(of_type);
    if (!plates.empty()) {
      file_.add("IFCRELAGGREGATES", id(Identified::kPlatesInWall), nothing(), nothing(), nothing(),
                step_reference(wall_), step_list(plates));
    }
    model_.report.drawn = static_cast<int>(plates.size());
    measure_flatness(plan_, model_.report);
    model_.header = plan_header("planish-ifc", plan_, model_.report).text();
    model_.text = file_.finish("IFC4", plan_.options.name);
    return std::move(model_);
  }

 private:
  StepValue id(Identified what, int number = 0) const {
    return identifier(plan_.base_hash, what, number);
  }

  int add_point(const Eigen::Vector3d& p) { return file_.add("IFCCARTESIANPOINT", reals(p)); }
  int add_direction(const Eigen::Vector3d& d) { return file_.add("IFCDIRECTION", reals(d)); }
  /// The axes of a panel, or of the world.
  int add_axes(const PanelFrame& frame) {
    const int point = add_point(frame.origin);
    const int z = add_direction(frame.normal);
    const int x = add_direction(frame.x);
    return file_.add("IFCAXIS2PLACEMENT3D", step_reference(point), step_reference(z),
                     step_reference(x));
  }

  int add_length_unit() {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPrefixes = {
        {{"mm", ".MILLI."}, {"cm", ".CENTI."}, {"m", "$"}, {"km", ".KILO."}}};
    for (const auto& [unit, prefix] : kPrefixes) {
      if (plan_.options.unit == unit) return add_metres(prefix);
    }
    const int metre = add_metres("$");
    const int factor =
        file_.add("IFCMEASUREWITHUNIT",
                  words("IFCLENGTHMEASURE", step_real(metres_in(plan_.options.unit).value())),
                  step_reference(metre));
    const int length =
        file_.add("IFCDIMENSIONALEXPONENTS", step_word("1"), step_word("0"), step_word("0"),
                  step_word("0"), step_word("0"), step_word("0"), step_word("0"));
    return file_.add("IFCCONVERSIONBASEDUNIT", step_reference(length), step_word(".LENGTHUNIT."),
                     step_string(plan_.options.unit == "in" ? "inch" : "foot"),
                     step_reference(factor));
  }
  int add_metres(std::string_view prefix) {
    return file_.add("IFCSIUNIT", step_word("*"), step_word(".LENGTHUNIT."), step_word(prefix),
                     step_word(".METRE."));
  }

  /// Units, axes, and what contains what, down to the curtain wall.
  void add_setting() {
    const int length = add_length_unit();
    const int area = file_.add("IFCSIUNIT", step_word("*"), step_word(".AREAUNIT."), nothing(),
                               step_word(".SQUARE_METRE."));
    const int angle = file_.add("IFCSIUNIT", step_word("*"), step_word(".PLANEANGLEUNIT."),
                                nothing(), step_word(".RADIAN."));
    const int units = file_.add(
        "IFCUNITASSIGNMENT",
        step_list(std::array{step_reference(length), step_reference(area), step_reference(angle)}));
    const int axes = add_axes({});
    const int model =
        file_.add("IFCGEOMETRICREPRESENTATIONCONTEXT", nothing(), step_string("Model"),
                  step_word("3"), step_word("1.E-05"), step_reference(axes), nothing());
    context_ =
        file_.add("IFCGEOMETRICREPRESENTATIONSUBCONTEXT", step_string("Body"), step_string("Model"),
                  step_word("*"), step_word("*"), step_word("*"), step_word("*"),
                  step_reference(model), nothing(), step_word(".MODEL_VIEW."), nothing());
    placement_ = file_.add("IFCLOCALPLACEMENT", nothing(), step_reference(axes));
    const StepValue name = step_string(plan_.options.name);
    const StepValue here = step_reference(placement_);
    const StepValue project = step_reference(file_.add(
        "IFCPROJECT", id(Identified::kProject), nothing(), name, nothing(), nothing(), nothing(),
        nothing(), step_list(std::array{step_reference(model)}), step_reference(units)));
    const StepValue site = step_reference(
        file_.add("IFCSITE", id(Identified::kSite), nothing(), step_string("Site"), nothing(),
                  nothing(), here, nothing(), nothing(), step_word(".ELEMENT."), nothing(),
                  nothing(), nothing(), nothing(), nothing()));
    const StepValue building = step_reference(
        file_.add("IFCBUILDING", id(Identified::kBuilding), nothing(), step_string("Building"),
                  nothing(), nothing(), here, nothing(), nothing(), step_word(".ELEMENT."),
                  nothing(), nothing(), nothing()));
    wall_ = file_.add("IFCCURTAINWALL", id(Identified::kWall), nothing(), name, nothing(),
                      nothing(), here, nothing(), nothing(), nothing());
    file_.add("IFCRELAGGREGATES", id(Identified::kSiteInProject), nothing(), nothing(), nothing(),
              project, step_list(std::array{site}));
    file_.add("IFCRELAGGREGATES", id(Identified::kBuildingInSite), nothing(), nothing(), nothing(),
              site, step_list(std::array{building}));
    file_.add("IFCRELCONTAINEDINSPATIALSTRUCTURE", id(Identified::kWallInBuilding), nothing(),
              nothing(), nothing(), step_list(std::array{step_reference(wall_)}), building);
  }

  /// Adds all vertices: vertex v is point v + 1.
  int add_points() {
    std::vector<StepValue> points;
    for (const auto p : plan_.mesh.positions.colwise()) points.push_back(reals(p));
    return file_.add("IFCCARTESIANPOINTLIST3D", step_list(points));
  }

  StepValue add_polygon(int face) {
    std::vector<StepValue> corners;
    for (const int v : plan_.mesh.face(face)) corners.push_back({std::to_string(v + 1)});
    return add_face_set(points_, corners);
  }

  StepValue add_face_set(int points, const std::vector<StepValue>& corners) {
    const int polygon = file_.add("IFCINDEXEDPOLYGONALFACE", step_list(corners));
    return step_reference(file_.add("IFCPOLYGONALFACESET", step_reference(points), step_word(".F."),
                                    step_list(std::array{step_reference(polygon)}), nothing()));
  }

  /// Adds a shape, in the panel's own axes, for each piece that is left of it.
  std::vector<StepValue> add_cut_panel(int face) {
    const FlatPanel& panel = plan_.panels[at(face)];
    const auto pieces = inset(panel.outline, 0.5 * plan_.options.gap);
    if (!pieces.empty()) note_pieces(plan_, face, pieces, model_.report);
    std::vector<StepValue> shapes;
    for (const CutPiece& piece : pieces) {
      const bool is_solid = plan_.options.thickness > 0.0;
      shapes.push_back(is_solid ? add_solid(panel.frame, piece.corners)
                                : add_surface(panel.frame, piece.corners));
    }
    return shapes;
  }

  StepValue add_surface(const PanelFrame& frame, const Outline& outline) {
    std::vector<StepValue> points;
    std::vector<StepValue> corners;
    for (const auto p : outline.colwise()) {
      points.push_back(reals(frame.to_model({p.x(), p.y(), 0.0})));
      corners.push_back({std::to_string(points.size())});
    }
    return add_face_set(file_.add("IFCCARTESIANPOINTLIST3D", step_list(points)), corners);
  }

  /// The outline, extruded to the inside.
  StepValue add_solid(const PanelFrame& frame, const Outline& outline) {
    std::vector<StepValue> points;
    for (const auto p : outline.colwise()) points.push_back(reals(p));
    points.push_back(points.front());
    const int list = file_.add("IFCCARTESIANPOINTLIST2D", step_list(points));
    const int curve =
        file_.add("IFCINDEXEDPOLYCURVE", step_reference(list), nothing(), step_word(".F."));
    const int profile = file_.add("IFCARBITRARYCLOSEDPROFILEDEF", step_word(".AREA."), nothing(),
                                  step_reference(curve));
    const int axes = add_axes(frame);
    const int inwards = add_direction(-Eigen::Vector3d::UnitZ());
    return step_reference(file_.add("IFCEXTRUDEDAREASOLID", step_reference(profile),
                                    step_reference(axes), step_reference(inwards),
                                    step_real(plan_.options.thickness)));
  }

  int add_plate(int face, const std::vector<StepValue>& shapes, bool is_surface) {
    const bool is_solid = !is_surface && plan_.options.thickness > 0.0;
    const int representation =
        file_.add("IFCSHAPEREPRESENTATION", step_reference(context_), step_string("Body"),
                  step_string(is_solid ? "SweptSolid" : "Tessellation"), step_list(shapes));
    const int definition = file_.add("IFCPRODUCTDEFINITIONSHAPE", nothing(), nothing(),
                                     step_list(std::array{step_reference(representation)}));
    const StepValue name = step_string(plan_.options.names.of(face));
    const int plate = file_.add("IFCPLATE", id(Identified::kPlate, face), nothing(), name,
                                nothing(), nothing(), step_reference(placement_),
                                step_reference(definition), name, step_word(".CURTAIN_PANEL."));
    add_properties(face, plate);
    return plate;
  }

  /// Adds the types that have a plate; a plate keeps its own shape, which is within the tolerance
  /// of its type's.
  void add_types(const std::vector<std::vector<StepValue>>& of_type) {
    for (std::size_t k = 0; k < of_type.size(); ++k) {
      if (of_type[k].empty()) continue;
      const int number = static_cast<int>(k);
      const StepValue name = step_string(type_name(number));
      const int type =
          file_.add("IFCPLATETYPE", id(Identified::kPlateType, number), nothing(), name, nothing(),
                    nothing(), nothing(), nothing(), name, nothing(), step_word(".CURTAIN_PANEL."));
      file_.add("IFCRELDEFINESBYTYPE", id(Identified::kPlatesOfType, number), nothing(), nothing(),
                nothing(), step_list(of_type[k]), step_reference(type));
    }
  }

  StepValue property(std::string_view name, const StepValue& value) {
    return step_reference(
        file_.add("IFCPROPERTYSINGLEVALUE", step_string(name), nothing(), value, nothing()));
  }

  /// The panel's row in brief. Areas are square metres, whatever the unit of lengths.
  void add_properties(int face, int plate) {
    const double metres = metres_in(plan_.options.unit).value();
    const double area = area_of(plan_.panels[at(face)].outline) * metres * metres;
    const double flatness = face_planarity(plan_.mesh.positions, plan_.mesh.face(face)).mm_per_m;
    std::vector<StepValue> properties = {
        property("Panel", words("IFCIDENTIFIER", step_string(plan_.options.names.of(face)))),
        property("Face", words("IFCINTEGER", {std::to_string(face)})),
        property("Area", words("IFCAREAMEASURE", step_real(area))),
        property("FlatnessMmPerM", words("IFCREAL", step_real(flatness))),
        property("DesignHash", words("IFCIDENTIFIER", step_string(hash_text(plan_.hash))))};
    if (plan_.remake) {
      const auto change = change_name(plan_.remake->panels[at(face)]);
      properties.push_back(property("Change", words("IFCLABEL", step_string(change))));
    }
    const int set = file_.add("IFCPROPERTYSET", id(Identified::kPlateProperties, face), nothing(),
                              step_string("Planish_Panel"), nothing(), step_list(properties));
    file_.add("IFCRELDEFINESBYPROPERTIES", id(Identified::kPlateHasProperties, face), nothing(),
              nothing(), nothing(), step_list(std::array{step_reference(plate)}),
              step_reference(set));
  }

  const CuttingPlan& plan_;
  StepFile file_;
  IfcModel model_;
  int context_ = 0, placement_ = 0, wall_ = 0, points_ = 0;  ///< numbers of entities
};

}  // namespace

IfcModel write_ifc(const CuttingPlan& plan) { return IfcWriter(plan).write(); }

}  // namespace planish
