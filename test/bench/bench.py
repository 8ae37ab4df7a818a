# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs one of the benchmarks that start programs, in the build's environment: bench.py NAME
[--quick] [--json FILE] [OPTION ...]. NAME is that of a module with measure(options), which prints
and returns the rows, and with QUICK, what --quick does; it may have add_options(parser)."""
import argparse
import importlib
import json
import pathlib
import sys


ROOMS = ("common", "node", "tools")


def main():
    # Before others, which may have modules of the same names.
    sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent / room) for room in ROOMS]
    name = sys.argv.pop(1)
    module = importlib.import_module(name)
    parser = argparse.ArgumentParser(prog="scripts/bench " + name.replace("_", "-"),
                                     description=module.__doc__)
    parser.add_argument("--quick", action="store_true", help=module.QUICK)
    parser.add_argument("--json", metavar="FILE", help="the rows as JSON, too")
    getattr(module, "add_options", lambda _: None)(parser)
    options = parser.parse_args()
    rows = module.measure(options)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)


if __name__ == "__main__":
    main()
