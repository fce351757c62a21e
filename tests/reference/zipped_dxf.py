# SPDX-License-Identifier: MIT
"""What check_package.py and check_drawings.py both ask of a DXF file in a zip. Exit 77 without ezdxf."""

import csv
import io
import sys

try:
    import ezdxf
except ImportError:
    sys.exit(77)


# $INSUNITS and $MEASUREMENT by the unit in a drawing's name.
UNITS = {"mm": (4, 1), "cm": (5, 1), "m": (6, 1), "km": (7, 1), "in": (1, 0), "ft": (2, 0)}


def read_dxf(archive, name, types):
    """The model space of a DXF R12 file without faults that holds entities of these types alone."""
    document = ezdxf.read(io.StringIO(archive.read(name).decode("ascii")))
    audit = document.audit()
    assert not audit.errors and not audit.fixes, f"{name}: {[e.message for e in audit.errors + audit.fixes]}"
    assert document.dxfversion == "AC1009", name
    unit = name.removesuffix(".dxf").rsplit("-", 1)[1]
    assert (document.header["$INSUNITS"], document.header["$MEASUREMENT"]) == UNITS[unit], name
    space = document.modelspace()
    assert {e.dxftype() for e in space} <= types, name
    return space


def read_csv(archive, name):
    return list(csv.DictReader(io.StringIO(archive.read(name).decode("utf-8"), newline="")))
