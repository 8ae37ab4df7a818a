// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of all benchmarks, for people: in Markdown, each row as soon as it is measured.
#pragma once

#include <string>
#include <vector>

#include "bench/common/row.h"

namespace link_bounds::bench {

struct Column {
  std::string name;       ///< of a value of the rows
  std::string head = {};  ///< "": the name
  int width = 0;          ///< of a column of texts; 0: one of numbers, as wide as its head
};

class Table {
 public:
  /// Prints the title and the heads to standard output.
  Table(const std::string& title, std::vector<Column> columns);

  /// Prints a row. A text that is too long loses its beginning, which tells less than its end.
  void add(const Row& row) const;

 private:
  std::vector<Column> columns_;
};

void printTable(const std::string& title, const std::vector<Column>& columns, const Rows& rows);

}  // namespace link_bounds::bench
