// SPDX-License-Identifier: GPL-3.0-or-later
// Table: rows of text, for a page (html_page.h), for Markdown, for terminals.
#ifndef KINEX_EXPERIMENTS_LAB_TABLE_H
#define KINEX_EXPERIMENTS_LAB_TABLE_H

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kinex::lab {

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
  std::string note = {};                       // the meaning of the numbers
  std::string verdict = "verdict";  // the column that is one, if there is one: first on pages
};

// True if all cells of the column are numbers, "-" or begin with "<".
bool has_numbers(const Table& table, std::size_t column);

// In Markdown, with a newline in front: title, note and rows.
std::string markdown(const Table& table);
// Its rows alone. Columns of numbers are aligned to the right, except for the first one.
std::string markdown_rows(const Table& table);

// A column of a table for terminals that has the same columns on a page.
struct TextColumn {
  const char* title;                 // for terminals
  int width;                         // there; below 0: aligned to the left; 0: the last column
  bool number = true;                // on the page: HtmlColumn::number
  const char* page_title = nullptr;  // on the page; nullptr: `title`
  bool verdict = false;              // on the page: HtmlColumn::verdict
};
// One line; of the titles, or of cells.
std::string text_header(std::span<const TextColumn> columns);
std::string text_row(std::span<const TextColumn> columns, const std::vector<std::string>& cells);

}  // namespace kinex::lab

#endif
