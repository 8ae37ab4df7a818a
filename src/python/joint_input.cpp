// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/joint_input.h"

#include <algorithm>
#include <cmath>

#include "link_bounds/robot/urdf/kinematics.h"
#include "python/text.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/options.h"

namespace py = pybind11;

namespace link_bounds {
namespace {

const char* const kWhatRows =
    " must be a dict {joint: value}, an array [joints] in the order of .joints, an array [rows, "
    "joints], or a list of dicts";

/// "q", or "q[3]" of several rows.
std::string nameOf(const std::string& rows, std::size_t row, bool is_single) {
  return is_single ? rows : rows + "[" + std::to_string(row) + "]";
}

std::string reprOf(const py::handle& object) {
  return py::cast<std::string>(py::repr(object));
}

double numberOf(const py::handle& value, const std::string& joint) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred()) {
    PyErr_Clear();
    throw JointError("the value of joint \"" + joint + "\" is " + reprOf(value) +
                     ", but must be a number");
  }
  return number;
}

/// Returns false for a joint that mimics another one. Throws if there is none of that name.
bool isSettable(const SharedRobot& shared, const std::string& name) {
  const std::string reason = whyNoJoint(shared.robot(), name);
  if (!reason.empty()) throw JointError(reason);
  const Joint& joint = movableJoint(shared.robot(), name);
  if (joint.mimic) warnInPython(whyIgnored(joint));
  return !joint.mimic;
}

/// Writes a dict into `values`, which has a zero for each joint of SharedRobot::joints().
void readDict(const SharedRobot& shared, const py::dict& dict, double* values) {
  for (const auto& [key, value] : dict) {
    const std::string name = keyName(key, "a joint");
    const double number = numberOf(value, name);
    std::size_t column = 0;
    while (column < shared.joints().size() &&
           shared.robot().joints[shared.joints()[column]].name != name)
      ++column;
    if (column < shared.joints().size())
      values[column] = number;
    else
      isSettable(shared, name);
  }
}

JointRows rowsOfDicts(const SharedRobot& shared, const std::vector<py::dict>& dicts,
                      bool is_single) {
  const std::size_t columns = shared.joints().size();
  JointRows rows{RowArray(std::vector<Py_ssize_t>{static_cast<Py_ssize_t>(dicts.size()),
                                                  static_cast<Py_ssize_t>(columns)}),
                 dicts.size(), is_single};
  std::fill_n(rows.values.mutable_data(), dicts.size() * columns, 0.0);
  for (std::size_t i = 0; i < dicts.size(); ++i)
    readDict(shared, dicts[i], rows.values.mutable_data() + i * columns);
  return rows;
}

bool isList(const py::handle& object) {
  return py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object);
}

bool isNumber(const py::handle& object) {
  return py::isinstance<py::float_>(object) || py::isinstance<py::int_>(object);
}

/// Whether `q` has keys(). Those of a Series or DataFrame of pandas do not count: it is an array.
/// What most poses are is known without a search for attributes.
bool isMapping(const py::handle& q) {
  if (py::isinstance<py::dict>(q)) return true;
  if (py::isinstance<py::array>(q) || isNumber(q) || isList(q)) return false;
  return py::hasattr(q, "keys") && !py::hasattr(q, "__array__");
}

/// Empty if `q` is no list or tuple of mappings.
std::vector<py::dict> dictsOf(const py::handle& q, const std::string& name) {
  std::vector<py::dict> dicts;
  if (!isList(q)) return dicts;
  for (const py::handle& item : q) {
    if (!isMapping(item)) return {};
    dicts.push_back(dictOf(item, name, kWhatRows));
  }
  return dicts;
}

std::string shapeOf(const py::array& array) {
  return reprOf(array.attr("shape"));
}

/// Whether `q` is a masked array, or a list that has one. Looks into lists only `levels` deep: no
/// value is deeper, and a list may contain itself.
bool isMasked(const py::handle& q, int levels = 2) {
  if (isNumber(q)) return false;  // most are
  if (isList(q))
    return levels > 0 && std::any_of(q.begin(), q.end(), [levels](const py::handle& item) {
             return isMasked(item, levels - 1);
           });
  const auto module = py::getattr(py::type::handle_of(q), "__module__", py::str(""));
  return py::cast<std::string>(py::str(module)).rfind("numpy.ma", 0) == 0;
}

JointRows rowsOfArray(const SharedRobot& shared, const py::handle& q, const std::string& name) {
  const py::array any = numbersOf(q, name, kWhatRows);
  const std::size_t columns = shared.joints().size();
  const bool has_columns = (any.ndim() == 1 || any.ndim() == 2) &&
                           any.shape(any.ndim() - 1) == static_cast<Py_ssize_t>(columns);
  if (!has_columns)
    throw py::value_error(name + kWhatRows + "; its shape is " + shapeOf(any) +
                          ", but the robot has " + std::to_string(columns) + " joints");
  const bool is_single = any.ndim() == 1;
  return {RowArray(any), is_single ? 1 : static_cast<std::size_t>(any.shape(0)), is_single};
}

void checkFinite(const SharedRobot& shared, const JointRows& rows, const std::string& name) {
  const std::size_t columns = shared.joints().size();
  const double* const values = rows.values.data();
  for (std::size_t i = 0; i < rows.count * columns; ++i) {
    if (std::isfinite(values[i])) continue;
    throw JointError("joint \"" + shared.robot().joints[shared.joints()[i % columns]].name +
                     "\" in " + nameOf(name, i / columns, rows.is_single) + " is " +
                     reprOf(py::float_(values[i])) + ", but must be a finite number");
  }
}

/// Reads a number, or a pair of numbers.
Limits rangeOf(const py::handle& value, const std::string& joint) {
  const bool is_pair = py::isinstance<py::sequence>(value) && PyObject_Size(value.ptr()) == 2;
  PyErr_Clear();  // of objects without a size, such as an array without a dimension
  if (!is_pair) {
    const double number = numberOf(value, joint);
    return {number, number};
  }
  const py::sequence pair = py::reinterpret_borrow<py::sequence>(value);
  return {numberOf(pair[0], joint), numberOf(pair[1], joint)};
}

}  // namespace

py::array numbersOf(const py::handle& given, const std::string& name, const std::string& what) {
  if (isMasked(given))
    throw py::value_error(name + what +
                          ", but it is a masked array; fill it, or leave out what is masked");
  py::array any = py::array::ensure(given);
  if (!any) {
    PyErr_Clear();
    throw py::value_error(name + what + ", but it is " + reprOf(given));
  }
  if (std::string("fiu").find(any.dtype().kind()) == std::string::npos)
    throw py::value_error(name + what + ", but its values are of the type " +
                          py::cast<std::string>(py::str(any.dtype())));
  return any;
}

JointRows jointRows(const SharedRobot& shared, const py::handle& q, const std::string& name) {
  const auto read = [&] {
    if (isMapping(q)) return rowsOfDicts(shared, {dictOf(q, name, kWhatRows)}, true);
    const std::vector<py::dict> dicts = dictsOf(q, name);
    return dicts.empty() ? rowsOfArray(shared, q, name) : rowsOfDicts(shared, dicts, false);
  };
  JointRows rows = read();
  checkFinite(shared, rows, name);
  return rows;
}

std::vector<double> spread(const SharedRobot& shared, const JointRows& rows, std::size_t row) {
  std::vector<double> values(shared.robot().joints.size(), 0.0);
  const double* const given = rows.row(row, shared.joints().size());
  for (std::size_t i = 0; i < shared.joints().size(); ++i)
    values[shared.joints()[i]] = given[i];
  return values;
}

GivenRanges givenRanges(const SharedRobot& shared, const py::object& ranges) {
  GivenRanges given;
  if (ranges.is_none()) return given;
  const char* const what = " must be a dict {joint: (lower, upper)} or {joint: value}";
  for (const auto& [key, value] : dictOf(ranges, "ranges", what)) {
    const std::string name = keyName(key, "a joint");
    const Limits range = rangeOf(value, name);
    if (!(std::isfinite(range.lower) && std::isfinite(range.upper) && range.lower <= range.upper))
      throw JointError("the range of joint \"" + name + "\" is " + reprOf(value) +
                       ", but must go from the smaller number to the larger one");
    if (isSettable(shared, name)) given.emplace(name, range);
  }
  return given;
}

py::dict dictOf(const py::handle& given, const std::string& name, const char* what) {
  if (py::isinstance<py::dict>(given)) return py::reinterpret_borrow<py::dict>(given);
  py::dict dict;
  if (PyDict_Update(dict.ptr(), given.ptr()) == 0) return dict;
  if (!PyErr_ExceptionMatches(PyExc_AttributeError) && !PyErr_ExceptionMatches(PyExc_TypeError))
    throw py::error_already_set();
  PyErr_Clear();
  throw py::value_error(name + what + ", but is " + reprOf(given));
}

std::string keyName(const py::handle& key, const char* kind) {
  if (py::isinstance<py::str>(key)) {
    const auto bytes = py::reinterpret_steal<py::bytes>(
        PyUnicode_AsEncodedString(key.ptr(), "utf-8", "surrogateescape"));
    if (bytes) return bytes;
    PyErr_Clear();
  }
  throw py::value_error(reprOf(key) + " is not the name of " + kind);
}

void checkJobs(unsigned jobs) {
  if (jobs <= kMaxJobs) return;
  throw py::value_error("jobs is " + std::to_string(jobs) + ", but must be at most " +
                        std::to_string(kMaxJobs) + ", or 0 for one per core");
}

void checkLength(const char* name, double metres) {
  if (std::isfinite(metres) && metres >= 0) return;
  throw py::value_error(std::string(name) + " is " + reprOf(py::float_(metres)) +
                        ", but must be a finite number of metres >= 0");
}

void checkPositive(const char* name, double number, const char* unit) {
  if (number > 0) return;
  throw py::value_error(std::string(name) + " is " + reprOf(py::float_(number)) +
                        ", but must be a number of " + unit + " > 0, such as 0.01");
}

}  // namespace link_bounds
