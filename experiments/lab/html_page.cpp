// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/html_page.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "experiments/lab/html_style.h"

namespace kinex::lab {

HtmlPage::HtmlPage(std::string title, std::string verdict, bool good, Html lead)
    : title_(std::move(title)), verdict_(std::move(verdict)), good_(good), lead_(std::move(lead)) {}

void HtmlPage::add(HtmlSection section) {
  if (!section.html.empty()) sections_.push_back(std::move(section));
}

// Of many sections the first and the last ones; a line, which says from where to where, unfolds those between.
Html HtmlPage::contents() const {
  constexpr std::size_t kMost = 9, kFirst = 3, kLast = 2;
  const std::size_t count = sections_.size();
  Html links;
  for (std::size_t i = 0; i < count; ++i) {
    if (count > kMost && i == kFirst) {
      links +=
          html("<details><summary>{} more parts of this page, from \"{}\" to \"{}\"</summary>\n",
               count - kFirst - kLast, sections_[i].title, sections_[count - kLast - 1].title);
    }
    if (count > kMost && i + kLast == count) links += Html::markup("</details>\n");
    links += html("<a href=\"#{}\">{}</a>\n", sections_[i].id, sections_[i].title);
  }
  return links;
}

std::string HtmlPage::text() const {
  Html page = html(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<title>{0}: {1}</title>\n<style>{2}</style></head><body>\n<header><h1>{0}</h1>\n"
      "<p class=\"verdict {3}\">{1}</p>\n{4}</header>\n<nav aria-label=\"Contents\">",
      title_, verdict_, Html::markup(kPageStyle), good_ ? "PASS" : "FAIL", lead_);
  page += contents();
  page += Html::markup("</nav>\n");
  for (const HtmlSection& one : sections_) {
    page += html("<section><h2 id=\"{0}\"><a href=\"#{0}\">{1}</a></h2>\n{2}</section>\n", one.id,
                 one.title, one.html);
  }
  page += html("<script>{}</script>\n</body></html>\n", Html::markup(kPageScript));
  return page.text();
}

Html html_table(const std::vector<HtmlColumn>& columns, const std::vector<HtmlRow>& rows) {
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return columns[i].verdict; });
  std::string text = "<div class=\"wide\"><table class=\"data\"><thead><tr>";
  for (const std::size_t i : order) {
    const HtmlColumn& column = columns[i];
    text += column.number ? "<th scope=\"col\" class=\"r\">" : "<th scope=\"col\">";
    text += escape(column.title) + "</th>";
  }
  text += "</tr></thead><tbody>\n";
  for (const HtmlRow& row : rows) {
    text += "<tr";
    if (!row.id.empty()) text += " id=\"" + row.id + "\"";
    if (row.first) text += " class=\"first\"";
    text += ">";
    for (const std::size_t i : order) {
      if (i >= row.cells.size()) continue;
      text += columns[i].number ? "<td class=\"r\">" : "<td>";
      text += row.cells[i].text() + "</td>";
    }
    text += "</tr>\n";
    if (row.more.empty()) continue;
    text += html("<tr class=\"more\"><td colspan=\"{}\"><div>{}</div></td></tr>\n", columns.size(), row.more).text();
  }
  return Html::markup(text + "</tbody></table></div>\n");
}

std::vector<HtmlColumn> html_columns(std::span<const TextColumn> columns) {
  std::vector<HtmlColumn> result;
  for (const TextColumn& one : columns) {
    result.push_back(
        {one.page_title == nullptr ? one.title : one.page_title, one.number, one.verdict});
  }
  return result;
}

Html unfolding_button(std::string_view text, std::string_view title) {
  return html("<button class=\"open\" title=\"{}\">{}</button>", title, text);
}

Html html_table(const Table& table) {
  std::vector<HtmlColumn> columns;
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    columns.push_back(
        {table.header[i], i > 0 && has_numbers(table, i), table.header[i] == table.verdict});
  }
  std::vector<HtmlRow> rows;
  std::string group;
  for (const auto& cells : table.rows) {
    HtmlRow row;
    row.cells.assign(cells.begin(), cells.end());
    const std::string own = cells.size() < 2 ? "" : cells[0] + " " + cells[1];
    row.first = own != group;
    group = own;
    rows.push_back(std::move(row));
  }
  const Html note = table.note.empty() ? Html() : html("<p class=\"facts\">{}</p>\n", table.note);
  return note + html_table(columns, rows);
}

}  // namespace kinex::lab
