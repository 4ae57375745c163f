// SPDX-License-Identifier: GPL-3.0-or-later
// HtmlPage: a page of results: its verdict first, then the contents, then its sections. A page is
// self-contained: it loads no files and uses no network.
#ifndef KINEX_EXPERIMENTS_LAB_HTML_PAGE_H
#define KINEX_EXPERIMENTS_LAB_HTML_PAGE_H

#include <span>
#include <string>
#include <vector>

#include "experiments/lab/html.h"
#include "experiments/lab/table.h"

namespace kinex::lab {

struct HtmlSection {
  std::string id, title;  // of its anchor; of its heading
  Html html;              // empty: the section is left out
};

class HtmlPage {
 public:
  // `good`: of the verdict's colour.
  HtmlPage(std::string title, std::string verdict, bool good, Html lead);
  void add(HtmlSection section);
  std::string text() const;

 private:
  Html contents() const;  // links to the sections

  std::string title_, verdict_;
  bool good_;
  Html lead_;
  std::vector<HtmlSection> sections_;
};

// A table that is filtered and sorted on the page.
struct HtmlColumn {
  std::string title;
  bool number = false;   // aligned to the right, sorted as a number
  bool verdict = false;  // stands before all others: a narrow window shows the first columns
};
struct HtmlRow {
  std::vector<Html> cells;
  std::string id = {};  // of an anchor; empty: none
  Html more = {};       // unfolds below the row, by a cell that is an unfolding_button
  bool first = false;   // of a group
};
Html html_table(const std::vector<HtmlColumn>& columns, const std::vector<HtmlRow>& rows);
std::vector<HtmlColumn> html_columns(std::span<const TextColumn> columns);
Html unfolding_button(std::string_view text, std::string_view title);
// With its note, without its title. Rows whose first two cells are equal are a group.
Html html_table(const Table& table);

}  // namespace kinex::lab

#endif
