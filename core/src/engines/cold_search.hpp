// SPDX-License-Identifier: MIT
/// A minimum of the handle edit from nothing: several starts race, the best one wins. [WSN-5]
#pragma once

#include "engines/working_set_newton.hpp"

namespace planish {

/// The problem has many local minima. Cold starts in different working sets and smoothings are
/// followed to a coarse smoothing, where their objectives tell most minima apart; those within a
/// few per cent of the best run on to the last smoothing. The result depends on the problem alone.
/// Without a norm term there is one start.
/// @param field the winner's state, newton.support() its support
/// @returns the winner's status and records; steps and factorizations of all
EngineOutcome find_minimum(const EditProblem& problem, const NewtonOptions& options,
                           WorkingSetNewton& newton, DisplacementField& field,
                           const Progress& progress);

}  // namespace planish
