// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Columns of numbers stand to the right.
#include "bench/common/table.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace link_bounds::bench {
namespace {

constexpr std::size_t kMinWidth = 7;

std::string shortened(const std::string& text, std::size_t longest) {
  return text.size() <= longest ? text : "~" + text.substr(text.size() - longest + 1);
}

std::size_t widthOf(const Column& column) {
  const std::size_t min_width =
      column.width > 0 ? static_cast<std::size_t>(column.width) : kMinWidth;
  return std::max(min_width, column.head.size());
}

void printCell(const Column& column, const std::string& text) {
  const std::size_t width = widthOf(column);
  std::cout << "| " << (column.width > 0 ? std::left : std::right)
            << std::setw(static_cast<int>(width))
            << (column.width > 0 ? shortened(text, width) : text) << " ";
}

}  // namespace

Table::Table(const std::string& title, std::vector<Column> columns) : columns_(std::move(columns)) {
  for (Column& column : columns_)
    if (column.head.empty()) column.head = column.name;
  std::cout << "\n" << title << "\n\n";
  for (const Column& column : columns_)
    printCell(column, column.head);
  std::cout << "|\n";
  for (const Column& column : columns_)
    std::cout << "|" << std::string(widthOf(column) + 1, '-') << (column.width > 0 ? "-" : ":");
  std::cout << "|\n" << std::flush;
}

void Table::add(const Row& row) const {
  for (const Column& column : columns_)
    printCell(column, valueOf(row, column.name).text());
  std::cout << "|\n" << std::flush;
}

void printTable(const std::string& title, const std::vector<Column>& columns, const Rows& rows) {
  const Table table(title, columns);
  for (const Row& row : rows)
    table.add(row);
}

}  // namespace link_bounds::bench
