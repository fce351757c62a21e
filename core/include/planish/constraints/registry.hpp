// SPDX-License-Identifier: MIT
/// All kinds of constraints. A new one is its own file and one line here. Kinds of one name are
/// kept together, and a report has the worst of them; they follow each other.
#pragma once

#include "planish/constraints/circular_polygon.hpp"
#include "planish/constraints/conical_star.hpp"
#include "planish/constraints/conical_vertex.hpp"
#include "planish/constraints/constraint_rows.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/constraints/surface_row.hpp"

namespace planish {

using ConstraintKinds = KindList<  //
    PlanarPolygon,                 //
    CircularPolygon,               //
    ConicalVertex,                 //
    ConicalStar                    //
    >;
static_assert(ConstraintKinds::all([](auto tag) {
  return ConstraintKind<typename decltype(tag)::type>;
}));

static_assert(ConstraintRow<SurfaceRow>);

/// The rows of a mesh or of a patch, kind by kind; last, of a patch alone, those of points that
/// stand on surfaces.
using ConstraintRows = RowBatches<ConstraintKinds::With<SurfacePoint>>;

}  // namespace planish
