# SPDX-License-Identifier: MIT
"""Circles in a graph of files, for the checks of includes and of imports."""


def find_circles(graph):
    """Yields a list of names for each circle met, the last one again the name that closes it.

    graph: by name, the names that it leads to; those that are no keys lead nowhere.
    """
    state = {}

    def visit(name, trail):
        state[name] = "open"
        for target in graph.get(name, []):
            if state.get(target) == "open":
                yield trail + [name, target]
            elif target not in state:
                yield from visit(target, trail + [name])
        state[name] = "done"

    for name in graph:
        if name not in state:
            yield from visit(name, [])
