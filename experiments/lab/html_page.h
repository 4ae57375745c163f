// SPDX-License-Identifier: GPL-3.0-or-later
// HtmlPage: a page of results: its verdict first, then the contents, then its sections. A page is
// self-contained: it loads no files and uses no network.
#ifndef KINEX_EXPERIMENTS_LAB_HTML_PAGE_H
#define KINEX_EXPERIMENTS_LAB_HTML_PAGE_H

#include <string>
#include <utility>
#include <vector>

namespace kinex::lab {

class HtmlPage {
 public:
  // All but `title` and `verdict` is HTML. `good`: of the verdict's colour.
  HtmlPage(std::string title, std::string verdict, bool good, std::string lead);
  // `id`: of its anchor. A section without text is left out.
  void section(std::string id, std::string title, std::string html);
  std::string text() const;

 private:
  struct Section {
    std::string id, title, html;
  };
  std::string title_, verdict_, lead_;
  bool good_;
  std::vector<Section> sections_;
};

// A table that is filtered and sorted on the page. Cells are HTML.
struct HtmlColumn {
  std::string title;
  bool number = false;  // aligned to the right, sorted as a number
};
struct HtmlRow {
  std::vector<std::string> cells;
  std::string id = {};    // of an anchor; empty: none
  std::string more = {};  // unfolds below the row, by a cell's <button class="open">
  bool first = false;     // of a group
};
std::string html_table(const std::vector<HtmlColumn>& columns, const std::vector<HtmlRow>& rows);

// An anchor of letters, digits and "-" made of a text.
std::string anchor_of(const std::string& text);

}  // namespace kinex::lab

#endif
