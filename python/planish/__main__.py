# SPDX-License-Identifier: MIT
"""What the package does on the command line and the `planish` command does not:

python3 -m planish catalogue DIR -o CATALOGUE --page https://example.org/planish/
"""

import argparse
import sys

from .catalogues import catalogue
from .errors import Error


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m planish")
    commands = parser.add_subparsers(required=True)
    words = commands.add_parser("catalogue", help="a folder to look through, of what a sweep left")
    words.add_argument("folder", metavar="DIR", help="as planish sweep fills it")
    words.add_argument("-o", dest="out", required=True, metavar="CATALOGUE")
    words.add_argument("--page", help="address of the editor, absolute or as seen from CATALOGUE")
    words.add_argument("--title", default="Designs")
    given = parser.parse_args()
    try:
        catalogue(given.folder, given.out, page=given.page, title=given.title)
    except Error as error:
        print(f"planish: {error}", file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
