# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints failures at once. rosunit alone counts a failed subTest and an error in setUpClass, but
prints neither."""
import sys
import traceback

from rosunit import xmlrunner


def tell(test, error):
    # rosunit collects sys.stderr for the file of results.
    print("FAILED: %s\n%s" % (test.id(), "".join(traceback.format_exception(*error))),
          file=sys.__stderr__, flush=True)


class TellingResult(xmlrunner._XMLTestResult):  # pylint: disable=protected-access
    def addError(self, test, err):
        tell(test, err)
        super().addError(test, err)

    def addFailure(self, test, err):
        tell(test, err)
        super().addFailure(test, err)

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            tell(subtest, err)
            self._failure = err


xmlrunner._XMLTestResult = TellingResult  # pylint: disable=protected-access
