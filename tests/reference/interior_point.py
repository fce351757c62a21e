# SPDX-License-Identifier: MIT
"""A small primal-dual interior-point method for what the other files here ask: shares no code with the product.

    min f(y)  such that  c(y) = 0  and  g(y) >= 0,

with slacks, exact second derivatives, steps in the null space of the equations' Jacobian (pivoted QR, so that equations
may depend on each other), and a line search on the l1 merit with a second-order correction. Dense: some hundred unknowns.
"""

import numpy as np
from scipy.linalg import qr, solve_triangular

RANK = 1e-9  # of the largest diagonal entry of R
LEAST_BARRIER = 1e-7  # the value is within so much a row of its minimum
LEAST_WEIGHT = 1e-3  # of the equations in the merit: more makes steps along curved ones short
LONGEST = 1.0  # step
STALLED, STALLED_STEPS = 1e-5, 10
NEVER = 1e6  # a shift beyond which nothing is found


class Tangents:
    """Of the equations: the least step that removes their residual, a basis along them, their multipliers."""

    def __init__(self, rows):
        q, r, order = qr(rows.T, pivoting=True)
        size = np.abs(np.diag(r))
        self.rank = int((size > RANK * max(size.max(initial=0.0), 1e-300)).sum())
        self.across, self.along = q[:, :self.rank], q[:, self.rank:]
        self.factor, self.order, self.count = r[:self.rank, :self.rank], order, len(rows)

    def least_step(self, residual):
        chosen = residual[self.order[:self.rank]]
        return self.across @ solve_triangular(self.factor, -chosen, trans="T")

    def multipliers(self, force):
        found = np.zeros(self.count)
        found[self.order[:self.rank]] = solve_triangular(self.factor, self.across.T @ force)
        return found


class InteriorPoint:
    def __init__(self, problem, start, barrier):
        self.problem, self.y = problem, start.copy()
        self.barrier, self.shift, self.weight = barrier, 1e-4, LEAST_WEIGHT
        self.slack = np.maximum(problem.room(start), barrier)
        self.press = self.barrier / self.slack

    def merit(self, y, slack):
        off = np.abs(self.problem.equations(y)).sum() + np.abs(self.problem.room(y) - slack).sum()
        return self.problem.value(y) - self.barrier * np.log(slack).sum() + self.weight * off

    def direction(self, state):
        """Newton's step; along the equations curvatures count by their size, and by no less than the shift."""
        weights = self.press / self.slack
        pull = state.slope - state.room_rows.T @ (self.barrier / self.slack - weights * (state.room - self.slack))
        matrix = state.curvature + state.room_rows.T @ (weights[:, None] * state.room_rows)
        step = state.tangents.least_step(state.equations)
        along = state.tangents.along
        if along.shape[1]:
            sizes, modes = np.linalg.eigh(along.T @ matrix @ along)
            right = modes.T @ (along.T @ (pull + matrix @ step))
            step = step - along @ (modes @ (right / np.maximum(np.abs(sizes), self.shift)))
        return step

    def search(self, state, step, slack_step):
        """How far the step went; the state goes there."""
        falling = slack_step < 0
        most = min(1.0, 0.995 * np.min(-self.slack[falling] / slack_step[falling], initial=np.inf),
                   LONGEST / max(np.abs(step).max(initial=0.0), 1e-300))
        off = np.abs(state.equations).sum() + np.abs(state.room - self.slack).sum()
        slope = state.slope @ step - self.barrier * (slack_step / self.slack).sum()
        bend = step @ state.curvature @ step + self.shift * step @ step
        if off > 1e-12:
            self.weight = max(self.weight, (slope + 0.5 * max(bend, 0.0)) / (0.5 * off))
        slope -= self.weight * off
        before, share = self.merit(self.y, self.slack), most
        while share > 1e-5:
            for correct in (False, True):
                y = self.y + share * step
                if correct and np.isfinite(self.problem.equations(y)).all():
                    y = y + state.tangents.least_step(self.problem.equations(y))
                slack = np.maximum(self.slack + share * slack_step, self.problem.room(y))
                if self.merit(y, slack) <= before + 1e-4 * share * slope + 1e-13 * abs(before):
                    self.y, self.slack = y, slack
                    return share
            share *= 0.5
        return 0.0

    def solve(self, steps=100):
        values = []
        for _ in range(steps):
            state = State(self.problem, self.y, self.press)
            gradient = np.abs(state.slope - state.room_rows.T @ self.press - state.rows.T @ state.multipliers).max()
            left = max(gradient, np.abs(state.equations).max(initial=0.0), np.abs(state.room - self.slack).max(initial=0.0))
            gap = np.abs(self.slack * self.press - self.barrier).max(initial=0.0)
            values.append(self.problem.value(self.y))
            arrived = max(left, gap) < 10 * self.barrier
            if arrived and self.barrier <= LEAST_BARRIER:
                break
            stalled = len(values) > STALLED_STEPS and abs(values[-1] - values[-STALLED_STEPS]) < STALLED
            if arrived or stalled:
                values = []
                self.weight = LEAST_WEIGHT if arrived else 10 * self.weight
                self.barrier = max(LEAST_BARRIER, 0.1 * self.barrier) if arrived or left < 0.1 else self.barrier
            step = self.direction(state)
            slack_step = state.room_rows @ step + state.room - self.slack
            press_step = self.barrier / self.slack - self.press * (1.0 + slack_step / self.slack)
            falling = press_step < 0
            most = min(1.0, 0.995 * np.min(-self.press[falling] / press_step[falling], initial=np.inf))
            share = self.search(state, step, slack_step)
            if share == 0.0:
                self.shift = max(self.shift, 1e-6) * 10.0
                if self.shift > NEVER:
                    break
                continue
            self.press = np.clip(self.press + most * press_step, 1e-3 * self.barrier / self.slack,
                                 1e3 * self.barrier / self.slack)
            self.shift = max(1e-9, self.shift / 4.0) if share > 0.5 else self.shift * (2.0 if share < 0.05 else 1.0)
        return self.on_equations()

    def on_equations(self):
        """The place where the steps ended, moved the least that the equations ask; there as it is where that gets lost."""
        y = self.y
        for _ in range(6):
            rows = self.problem.equation_rows(y)
            if not np.isfinite(rows).all():
                return self.y
            y = y + Tangents(rows).least_step(self.problem.equations(y))
        return y


class State:
    """What a step needs of a place."""

    def __init__(self, problem, y, press):
        self.slope, self.equations, self.room = problem.slope(y), problem.equations(y), problem.room(y)
        self.rows, self.room_rows = problem.equation_rows(y), problem.room_rows(y)
        self.tangents = Tangents(self.rows)
        self.multipliers = self.tangents.multipliers(self.slope - self.room_rows.T @ press)
        self.curvature = problem.curvature(y, self.multipliers, press)
