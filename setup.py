# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""For catkin_python_setup alone: CMake builds and installs the package, see doc/deployment.md."""
from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(
    packages=['link_bounds'], package_dir={'': 'src/python'},
    package_data={'link_bounds': ['*.pyi', 'py.typed']}))
