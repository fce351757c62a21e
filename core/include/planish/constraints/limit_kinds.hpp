// SPDX-License-Identifier: MIT
/// All kinds of limits. A new one is its own file and one line here.
#pragma once

#include "planish/constraints/angle_limit.hpp"
#include "planish/constraints/area_limit.hpp"
#include "planish/constraints/constraint_rows.hpp"
#include "planish/constraints/edge_limit.hpp"
#include "planish/constraints/fold_limit.hpp"
#include "planish/constraints/sheet_limit.hpp"
#include "planish/constraints/slide_limit.hpp"

namespace planish {

using LimitKinds = KindList<  //
    FoldLimit,                //
    AngleLimit,               //
    EdgeLimit,                //
    AreaLimit,                //
    SheetLimit,               //
    SlideLimit                //
    >;
static_assert(LimitKinds::all([](auto tag) { return LimitKind<typename decltype(tag)::type>; }));

/// The limits' rows of a mesh or of a patch.
using LimitRows = RowBatches<LimitKinds>;

}  // namespace planish
