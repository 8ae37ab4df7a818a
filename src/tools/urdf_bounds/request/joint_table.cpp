// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// First the columns, then line after line. A cell that is no number spoils its row, not the table.
#include "tools/urdf_bounds/request/joint_table.h"

#include <algorithm>
#include <map>
#include <set>

#include "robot/urdf/limit_warnings.h"
#include "robot/urdf/simple_joints.h"
#include "robot/urdf/trimmed.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr char kTimeName[] = "time";
constexpr char kVelocityEnd[] = ".velocity";
constexpr char kAccelerationEnd[] = ".acceleration";

/// Max number of rows that are listed one by one as left out.
constexpr std::size_t kListedFaults = 5;

enum class Quantity { kNothing, kTime, kPosition, kVelocity, kAcceleration };

struct Column {
  std::string name;
  Quantity quantity = Quantity::kNothing;
  std::size_t joint = 0;
};

/// The text in the quotes that begin at `at`; a doubled quote stands for one. Moves `at` behind the
/// closing quote. std::nullopt if there is none.
std::optional<std::string> quoted(const std::string& line, std::size_t& at) {
  std::string text;
  while (++at < line.size()) {
    if (line[at] != '"') {
      text += line[at];
    } else if (line.compare(++at, 1, "\"") != 0) {
      return text;
    } else {
      text += '"';
    }
  }
  return std::nullopt;
}

/// Splits a line by RFC 4180, but strips blanks around cells. std::nullopt if a quote is not at
/// both ends of a cell, or if the line ends within quotes.
std::optional<std::vector<std::string>> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0;; ++begin) {
    begin = std::min(line.find_first_not_of(" \t", begin), line.size());
    const bool has_quotes = line.compare(begin, 1, "\"") == 0;
    const std::optional<std::string> cell = has_quotes ? quoted(line, begin) : std::nullopt;
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    const std::string rest = trimmed(line.substr(begin, comma - begin), " \t");
    if (has_quotes ? !cell || !rest.empty() : rest.find('"') != std::string::npos)
      return std::nullopt;
    cells.push_back(cell.value_or(rest));
    begin = comma;
    if (begin == line.size()) return cells;
  }
}

/// The beginning of a text for a message. A zero byte would end the message, so it becomes a space.
std::string shown(const std::string& text) {
  constexpr std::size_t kMaxShown = 100;
  std::string begin = text.substr(0, kMaxShown);
  std::replace(begin.begin(), begin.end(), '\0', ' ');
  return text.size() <= kMaxShown ? begin : begin + "...";
}

constexpr char kWrongQuotes[] =
    "has quotes that are not around whole cells of one line; correct them";

class TableReader {
 public:
  TableReader(std::string file, const Robot& robot) : file_(std::move(file)), robot_(robot) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (hasValue(robot.joints[i].motion)) index_.emplace(robot.joints[i].name, i);
    }
  }

  void setColumns(const std::string& line, const std::vector<std::string>& given, bool is_path) {
    std::set<std::string> names;
    std::optional<std::string> twice;
    const auto cells = cellsOf(line);
    if (!cells) throw UsageError(file_ + ": the line of names " + kWrongQuotes);
    for (const std::string& name : *cells) {
      if (!names.insert(name).second && !twice) twice = name;
      columns_.push_back(columnOf(name));
    }
    for (const Column& column : columns_) {
      if (column.quantity == Quantity::kPosition) table_.joints.push_back(column.joint);
    }
    if (is_path) checkUnknown(names);
    if (table_.joints.empty())
      throw UsageError(
          file_ + " has no column of a joint; where it has no line of names, give them " +
          "by --columns; lines that begin with # are remarks; joints that can be set:" +
          settableNames(robot_));
    if (twice)
      throw UsageError(file_ + ": column \"" + shown(*twice) + "\" is there twice; remove one");
    const std::set<std::string> known(given.begin(), given.end());
    for (const std::string& name : given) {
      if (names.count(name))
        throw UsageError(file_ + ": column \"" + name + "\" and " + name +
                         ":= give the same joint; leave one out");
    }
    warnOfMissing(names, known);
    checkDerivatives(Quantity::kVelocity, kVelocityEnd);
    checkDerivatives(Quantity::kAcceleration, kAccelerationEnd);
    if (has(Quantity::kAcceleration) && !has(Quantity::kVelocity))
      throw UsageError(file_ + " has accelerations but no velocities; add the columns" + " NAME" +
                       kVelocityEnd);
    if (has(Quantity::kVelocity) && !has(Quantity::kTime))
      throw UsageError(file_ + " has velocities but no times; add the column " + kTimeName);
  }

  void add(const std::string& line, std::size_t line_number) {
    const auto read = cellsOf(line);
    const std::vector<std::string> cells = read.value_or(std::vector<std::string>());
    std::vector<double> numbers(columns_.size(), 0.0);
    std::string fault;
    if (!read) {
      fault = kWrongQuotes;
    } else if (cells.size() != columns_.size()) {
      fault = "has " + std::to_string(cells.size()) + " cells instead of " +
              std::to_string(columns_.size());
    }
    for (std::size_t i = 0; i < columns_.size() && fault.empty(); ++i) {
      if (columns_[i].quantity == Quantity::kNothing) continue;
      const std::optional<double> number = toNumber(cells[i]);
      if (number)
        numbers[i] = *number;
      else
        fault = "column \"" + columns_[i].name + "\" is \"" + shown(cells[i]) +
                "\", which is no finite number";
    }
    if (!fault.empty()) fault += " (line " + std::to_string(line_number) + ")";
    table_.faults.push_back(fault);
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  }

  JointTable result() {
    if (std::all_of(table_.faults.begin(), table_.faults.end(),
                    [](const std::string& fault) { return !fault.empty(); }))
      throw UsageError(file_ + " has no row that can be used" +
                       (table_.faults.empty() ? "" : ": row 1 " + table_.faults.front()));
    table_.positions = numbersOf(Quantity::kPosition);
    table_.velocities = numbersOf(Quantity::kVelocity);
    table_.accelerations = numbersOf(Quantity::kAcceleration);
    const JointTable::Numbers times = numbersOf(Quantity::kTime);
    table_.times.assign(times.data(), times.data() + times.size());
    tellFaults();
    for (std::size_t i = 0; i < table_.joints.size(); ++i)
      checkLimits(i);
    return std::move(table_);
  }

 private:
  Column columnOf(const std::string& name) {
    Column column{name};
    const auto find = [&](const std::string& joint, Quantity quantity) {
      const auto found = index_.find(joint);
      if (found == index_.end()) return false;
      column.joint = found->second;
      column.quantity = quantity;
      return true;
    };
    const std::optional<std::string> moving = withoutEnd(name, kVelocityEnd);
    const std::optional<std::string> speeding = withoutEnd(name, kAccelerationEnd);
    if (!find(name, Quantity::kPosition) && !(moving && find(*moving, Quantity::kVelocity)) &&
        !(speeding && find(*speeding, Quantity::kAcceleration))) {
      if (name == kTimeName) {
        column.quantity = Quantity::kTime;
      } else {
        unknown_.push_back(name);
        table_.problems.push_back(file_ + ": column \"" + shown(name) +
                                  "\" is no movable joint of the "
                                  "robot and is ignored; those that can be set:" +
                                  settableNames(robot_));
      }
    } else if (robot_.joints[column.joint].mimic) {
      column.quantity = Quantity::kNothing;
      mimics_ += (mimics_.empty() ? "\"" : ", \"") + name + "\"";
    }
    return column;
  }

  /// Throws UsageError for an unknown column that may say how a joint moves.
  void checkUnknown(const std::set<std::string>& names) const {
    for (const std::string& name : unknown_) {
      const std::size_t dot = name.rfind('.');
      if (dot == std::string::npos) continue;
      const std::string joint = name.substr(0, dot);
      const std::string end = name.substr(dot);
      const bool is_derivative = end == kVelocityEnd || end == kAccelerationEnd;
      if (index_.count(joint) || (is_derivative && !names.count(joint)))
        throw UsageError(file_ + ": column \"" + name + "\" would be ignored, but a path must " +
                         "know how its joints move; name it JOINT" + kVelocityEnd + " or JOINT" +
                         kAccelerationEnd + ", or remove it; joints:" + settableNames(robot_));
    }
  }

  void warnOfMissing(const std::set<std::string>& names, const std::set<std::string>& given) {
    std::string missing;
    for (const std::size_t joint : settableJoints(robot_)) {
      const std::string& name = robot_.joints[joint].name;
      if (names.count(name) || given.count(name)) continue;
      missing += (missing.empty() ? "\"" : ", \"") + name + "\"";
      const std::optional<Limits>& limits = robot_.joints[joint].limits;
      if (limits && (limits->lower > 0 || limits->upper < 0))
        missing += " (beyond its limits " + shortestNumber(limits->lower) + " to " +
                   shortestNumber(limits->upper) + ")";
    }
    if (missing.empty()) return;
    table_.problems.push_back(file_ + ": joints without a column stay at 0: " + missing +
                              "; add columns, or give joint:=value");
  }

  bool has(Quantity quantity) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [=](const Column& column) { return column.quantity == quantity; });
  }

  /// Throws UsageError unless all joints with a column have one of this quantity, or none has.
  void checkDerivatives(Quantity quantity, const char* end) const {
    if (!has(quantity)) return;
    for (const std::size_t joint : table_.joints) {
      if (columnsOf(quantity, joint).empty())
        throw UsageError(file_ + " has columns of some joints that end in " + end + ", but not \"" +
                         robot_.joints[joint].name + end + "\"; add it");
    }
    for (const Column& column : columns_) {
      if (column.quantity == quantity && columnsOf(Quantity::kPosition, column.joint).empty())
        throw UsageError(file_ + ": column \"" + column.name + "\" has no column of positions \"" +
                         robot_.joints[column.joint].name + "\"; add it");
    }
  }

  /// The index of the column, or an empty list.
  std::vector<std::size_t> columnsOf(Quantity quantity, std::size_t joint) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].quantity == quantity && columns_[i].joint == joint) result.push_back(i);
    }
    return result;
  }

  /// The cells of all rows, with columns in the order of `joints`; for kTime the column of times.
  JointTable::Numbers numbersOf(Quantity quantity) const {
    std::vector<std::size_t> chosen;
    if (quantity == Quantity::kTime) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (columns_[i].quantity == quantity) chosen.push_back(i);
      }
    } else if (has(quantity)) {
      for (const std::size_t joint : table_.joints)
        chosen.push_back(columnsOf(quantity, joint).front());
    }
    const auto rows = static_cast<Eigen::Index>(table_.rows());
    const auto width = static_cast<Eigen::Index>(columns_.size());
    const Eigen::Map<const JointTable::Numbers> all(numbers_.data(), rows, width);
    JointTable::Numbers result(rows, static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i)
      result.col(static_cast<Eigen::Index>(i)) = all.col(static_cast<Eigen::Index>(chosen[i]));
    return result;
  }

  void tellFaults() {
    std::size_t count = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (table_.faults[row].empty()) continue;
      if (++count <= kListedFaults)
        table_.problems.push_back(file_ + ": row " + std::to_string(row + 1) +
                                  " is left out: " + table_.faults[row]);
    }
    if (count > kListedFaults)
      table_.problems.push_back(file_ + ": " + std::to_string(count - kListedFaults) +
                                " more rows are left out");
    if (!mimics_.empty())
      table_.notes.push_back(file_ +
                             ": columns of joints that follow another one are ignored: " + mimics_);
  }

  /// Adds a problem if a joint is outside its limits: the number of rows, and the first of them.
  void checkLimits(std::size_t column) {
    const Joint& joint = robot_.joints[table_.joints[column]];
    if (!joint.limits) return;
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const double value = valueAt(row, column);
      if (!table_.faults[row].empty() ||
          (value >= joint.limits->lower && value <= joint.limits->upper))
        continue;
      if (++count == 1) first = row;
    }
    if (count == 0) return;
    table_.problems.push_back(
        file_ + ": column \"" + joint.name + "\" is outside the limits " +
        shortestNumber(joint.limits->lower) + " to " + shortestNumber(joint.limits->upper) +
        (count == 1 ? " in row " : " in " + std::to_string(count) + " rows, first in row ") +
        std::to_string(first + 1) + ": " + shortestNumber(valueAt(first, column)));
  }

  double valueAt(std::size_t row, std::size_t column) const {
    return table_.positions(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  }

  std::string file_;
  const Robot& robot_;
  std::map<std::string, std::size_t> index_;
  std::vector<Column> columns_;
  std::vector<std::string> unknown_;  ///< names of unknown columns
  std::string mimics_;
  std::vector<double> numbers_;  ///< all cells, row by row
  JointTable table_;
};

/// Old Macs and some programs end lines with CR alone: the text would be a single line.
bool hasOnlyCr(const std::string& text) {
  const std::size_t cr = text.find('\r');
  const std::size_t last = text.find_last_not_of(" \t\r");
  return text.find('\n') == std::string::npos && last != std::string::npos && cr < last;
}

}  // namespace

JointTable parseJointTable(const std::string& text, const std::string& file,
                           const std::optional<std::string>& columns, const Robot& robot,
                           const std::vector<std::string>& given, bool is_path) {
  const std::string name = file == "-" ? "standard input" : file;
  if (hasOnlyCr(text)) throw UsageError(name + " has lines that end in CR alone; save it with LF");
  TableReader reader(name, robot);
  bool has_columns = columns.has_value();
  if (has_columns) reader.setColumns(*columns, given, is_path);
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = trimmed(text.substr(begin, end - begin), " \t\r");
    begin = end + 1;
    ++number;
    if (line.empty() || line[0] == '#') continue;
    if (has_columns)
      reader.add(line, number);
    else
      reader.setColumns(line, given, is_path);
    has_columns = true;
  }
  if (!has_columns) throw UsageError(name + " is empty; its first line has the names of joints");
  return reader.result();
}

/// Problems of mimic joints, which have limits of their own.
static std::vector<std::string> mimicsBeyond(const JointTable& table, const std::string& file,
                                             const Robot& simple, const JointValues& given) {
  std::vector<std::string> problems;
  const std::vector<Lead> leads = leadsOf(simple);
  for (std::size_t i = 0; i < simple.joints.size(); ++i) {
    const Joint& joint = simple.joints[i];
    if (!joint.mimic || !joint.limits) continue;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (!table.faults[row].empty()) continue;
      const double value =
          leads[i].factor * valuesOf(table, row, given)[leads[i].leader] + leads[i].offset;
      if (!isBeyond(*joint.limits, value)) continue;
      problems.push_back(file + ": joint \"" + joint.name + "\", which follows \"" +
                         simple.joints[leads[i].leader].name + "\", is outside the limits " +
                         shortestNumber(joint.limits->lower) + " to " +
                         shortestNumber(joint.limits->upper) + ", first in row " +
                         std::to_string(row + 1) + ": " + shortestNumber(value));
      break;
    }
  }
  return problems;
}

JointTable readJointTable(const UrdfBoundsOptions& options, const Robot& simple,
                          const JointValues& given) {
  std::vector<std::string> names;
  for (const auto& joint : options.joints)
    names.push_back(joint.first);
  JointTable table =
      parseJointTable(readText(*options.poses, "a table of joint values"), *options.poses,
                      options.columns, simple, names, options.report == Report::kPath);
  for (const std::string& note : table.notes)
    warn(note);
  tellProblems(options, table.problems);
  tellProblems(options, mimicsBeyond(table, *options.poses, simple, given));
  return table;
}

void tellProblems(const UrdfBoundsOptions& options, const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) {
    if (options.demand.strict)
      throw UsageError(problem + "; --strict accepts only tables without a fault");
    warn(problem);
  }
}

JointValues valuesOf(const JointTable& table, std::size_t row, JointValues given) {
  for (std::size_t i = 0; i < table.joints.size(); ++i)
    given[table.joints[i]] =
        table.positions(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
  return given;
}

}  // namespace link_bounds
