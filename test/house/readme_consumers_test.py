#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The consumers in README.md and doc/deployment.md work as they are."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import rostest
from bounds_testing import wait_for
from page_testing import code_block

BUILD_LIMIT = 240  # wall seconds for compiling thirty lines on a busy machine
CPP = ("doc/deployment.md", "## A consumer in C++")
PRINTED = "post up to 1"  # the post is 1 m high, and boxes are rounded outward


class ReadmeConsumers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_tool(self, *command):
        found = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               timeout=BUILD_LIMIT)
        self.assertEqual(found.returncode, 0, found.stdout.decode())

    def check_consumer(self, *command):
        """The program prints the box of the post and goes on."""
        path = os.path.join(self.folder, "output")
        with open(path, "wb") as output:
            consumer = subprocess.Popen(command, stdout=output,
                                        env=dict(os.environ, PYTHONUNBUFFERED="1"))
        self.addCleanup(consumer.wait)
        self.addCleanup(consumer.kill)

        def printed():
            with open(path, encoding="utf-8") as output:
                return PRINTED in output.read()
        wait_for(printed, "the consumer prints a box")
        self.assertIsNone(consumer.poll())

    def test_consumer_in_python(self):
        script = self.write("consumer.py", code_block("README.md", "A consumer in Python:", "python"))
        self.check_consumer(sys.executable, script)

    def test_consumer_in_cpp(self):
        self.write("consumer.cpp", code_block(*CPP, "cpp"))
        self.write("CMakeLists.txt", code_block(*CPP, "cmake"))
        build = os.path.join(self.folder, "build")
        # A library that was built for a sanitizer needs the same of its users.
        flags = "-fsanitize=address" if "ASAN_OPTIONS" in os.environ else ""
        self.run_tool("cmake", "-S", self.folder, "-B", build, "-DCMAKE_CXX_FLAGS=" + flags)
        self.run_tool("cmake", "--build", build)
        self.check_consumer(os.path.join(build, "consumer"))


if __name__ == "__main__":
    rostest.rosrun("link_bounds", "readme_consumers", ReadmeConsumers)
