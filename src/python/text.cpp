// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/text.h"

#include "link_bounds/robot/mesh/mesh_fault.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/pairs/srdf.h"
#include "tools/command_line/options.h"
#include "tools/command_line/text_file.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {

pybind11::str toPython(const std::string& text) {
  PyObject* const result =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape");
  if (!result) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(result);
}

std::string textOfFile(const std::string& file, const std::string& what) {
  // Standard input belongs to Python itself.
  if (file == "-") throw UsageError("\"-\" is no file; give the path of " + what);
  return readText(file, what);
}

void warnInPython(const std::string& text) {
  if (PyErr_WarnEx(PyExc_RuntimeWarning, validUtf8(text).c_str(), 1) != 0)
    throw pybind11::error_already_set();
}

void translate(std::exception_ptr error, const pybind11::handle& robot_error) {
  const auto set = [](PyObject* type, const std::exception& what) {
    PyErr_SetString(type, validUtf8(what.what()).c_str());
  };
  try {
    std::rethrow_exception(error);
  } catch (const JointError& what) {
    set(PyExc_ValueError, what);
  } catch (const RobotError& what) {
    set(robot_error.ptr(), what);
  } catch (const SrdfError& what) {
    set(robot_error.ptr(), what);
  } catch (const UsageError& what) {
    set(robot_error.ptr(), what);
  } catch (const MeshError& what) {
    set(robot_error.ptr(), what);
  }
}

}  // namespace link_bounds
