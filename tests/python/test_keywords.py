# SPDX-License-Identifier: MIT
"""Every option that the core has is a typed keyword, and every keyword an option."""

import inspect
import unittest

import planish

# Keywords that are no options, each with its reason.
NO_OPTIONS = {
    "mesh": "what it is done to",
    "self": "what it is done to",
    "relative": "how `handles` are read",
    "client": "where it is done",
    "progress": "who watches",
}
# Options that are no keywords, each with its reason.
NO_KEYWORDS = {
    ("explore", "coefficients"): "Family(coefficients) takes them: many of one family",
    ("explore", "exact"): "Variation.exact() does it: a family of exact ones is none",
    ("mobility", "part"): "of --vertices, for machines that share a command; `client` shares here",
}
FUNCTIONS = {
    "edit": planish.edit,
    "explore": planish.Edit.explore,
    "project": planish.project,
    "offset": planish.offset,
    "mobility": planish.mobility,
    "convert": planish.convert,
    "types": planish.types,
}


def keywords(function):
    """Of a function, by name, without its **more."""
    signature = inspect.signature(function)
    return {
        name: parameter
        for name, parameter in signature.parameters.items()
        if parameter.kind is not inspect.Parameter.VAR_KEYWORD
    }


class Keywords(unittest.TestCase):
    def test_every_option_is_a_keyword_and_every_keyword_an_option(self):
        used = set()
        for command, function in FUNCTIONS.items():
            given = keywords(function)
            used |= given.keys() & NO_OPTIONS.keys()
            expected = set()
            for option in planish.options(command):
                if (command, option) in NO_KEYWORDS:
                    used.add((command, option))
                else:  # what may be repeated is a list, and has a name of many
                    expected.add(option + "s" if option + "s" in given else option)
            with self.subTest(command):
                self.assertEqual(set(given) - NO_OPTIONS.keys(), expected)
        self.assertEqual(used, NO_OPTIONS.keys() | NO_KEYWORDS.keys(), "an exception of nothing")

    def test_every_keyword_has_a_type(self):
        for command, function in FUNCTIONS.items():
            for name, parameter in keywords(function).items():
                with self.subTest(command=command, keyword=name):
                    self.assertTrue(name == "self" or parameter.annotation is not parameter.empty)

    def test_every_keyword_is_handed_on(self):
        """Wrong on purpose: the core names it, so it has come there."""
        mesh = planish.Mesh.read("sample:vault:8")
        handles = {20: (0, 0, 0.1)}
        edit = planish.edit(mesh, handles)
        calls = {
            "edit": lambda wrong: planish.edit(mesh, handles, **wrong),
            "explore": lambda wrong: edit.explore(**{"dimension": 2, **wrong}),
            "project": lambda wrong: planish.project(mesh, **wrong),
            "offset": lambda wrong: planish.offset(mesh, **{"distance": 0.1, **wrong}),
            "mobility": lambda wrong: planish.mobility(mesh, **wrong),
            "convert": lambda wrong: planish.convert(mesh, **wrong),
            "types": lambda wrong: planish.types(mesh, **wrong),
        }
        # What these two take is looked at here, before the core.
        own = {("edit", "handles"), ("mobility", "vertices"), ("project", "reference")}
        self.assertEqual(calls.keys(), FUNCTIONS.keys())
        for command, call in calls.items():
            for name in keywords(FUNCTIONS[command]).keys() - NO_OPTIONS.keys():
                if (command, name) in own:
                    continue
                with self.subTest(command=command, keyword=name):
                    with self.assertRaises(planish.UsageError) as caught:
                        call({name: "?"})
                    said = name.removesuffix("s") if name not in planish.options(command) else name
                    self.assertIn(said, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
