// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace kinex::lab {

namespace {

bool is_number(const std::string& text) {
  return !text.empty() &&
         (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text == "-" || text[0] == '<');
}

}  // namespace

bool has_numbers(const Table& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return column >= row.size() || is_number(row[column]);
  });
}

std::string markdown(const Table& table) {
  const std::string note = table.note.empty() ? "" : table.note + "\n\n";
  return "\n## " + table.title + "\n\n" + note + markdown_rows(table);
}

std::string markdown_rows(const Table& table) {
  std::string text = "|", line = "\n|";
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    text += " " + table.header[i] + " |";
    line += i > 0 && has_numbers(table, i) ? " ---: |" : " --- |";
  }
  text += line + "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const std::string& cell : row) text += " " + cell + " |";
    text += "\n";
  }
  return text;
}

std::string text_row(std::span<const TextColumn> columns, const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int width = columns[i].width;
    if (i > 0) text += width == 0 ? "  " : " ";
    text += width < 0 ? fmt::format("{:<{}}", cells[i], -width) : fmt::format("{:>{}}", cells[i], width);
  }
  return text + "\n";
}

std::string text_header(std::span<const TextColumn> columns) {
  std::vector<std::string> titles;
  for (const TextColumn& column : columns) titles.emplace_back(column.title);
  return text_row(columns, titles);
}

}  // namespace kinex::lab
