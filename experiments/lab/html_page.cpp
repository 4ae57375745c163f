// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/html_page.h"

#include <fmt/format.h>

#include <cctype>

#include "experiments/lab/html.h"
#include "experiments/lab/html_style.h"

namespace kinex::lab {

HtmlPage::HtmlPage(std::string title, std::string verdict, bool good, std::string lead)
    : title_(std::move(title)), verdict_(std::move(verdict)), lead_(std::move(lead)), good_(good) {}

void HtmlPage::section(std::string id, std::string title, std::string html) {
  if (!html.empty()) sections_.push_back({std::move(id), std::move(title), std::move(html)});
}

std::string HtmlPage::text() const {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<title>{0}: {1}</title>\n<style>{2}</style></head><body>\n<header><h1>{0}</h1>\n"
      "<p class=\"verdict {3}\">{1}</p>\n{4}</header>\n<nav aria-label=\"Contents\">",
      escape(title_), escape(verdict_), kPageStyle, good_ ? "PASS" : "FAIL", lead_);
  for (const Section& one : sections_)
    text += fmt::format("<a href=\"#{}\">{}</a>\n", one.id, escape(one.title));
  text += "</nav>\n";
  for (const Section& one : sections_) {
    text += fmt::format("<section><h2 id=\"{0}\"><a href=\"#{0}\">{1}</a></h2>\n{2}</section>\n",
                        one.id, escape(one.title), one.html);
  }
  return text + fmt::format("<script>{}</script>\n</body></html>\n", kPageScript);
}

std::string html_table(const std::vector<HtmlColumn>& columns, const std::vector<HtmlRow>& rows) {
  std::string text = "<div class=\"wide\"><table class=\"data\"><thead><tr>";
  for (const HtmlColumn& column : columns) {
    text += fmt::format("<th scope=\"col\"{}>{}</th>", column.number ? " class=\"r\"" : "",
                        column.title);
  }
  text += "</tr></thead><tbody>\n";
  for (const HtmlRow& row : rows) {
    text += "<tr";
    if (!row.id.empty()) text += " id=\"" + row.id + "\"";
    if (row.first) text += " class=\"first\"";
    text += ">";
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      text += i < columns.size() && columns[i].number ? "<td class=\"r\">" : "<td>";
      text += row.cells[i] + "</td>";
    }
    text += "</tr>\n";
    if (!row.more.empty()) {
      text += fmt::format("<tr class=\"more\"><td colspan=\"{}\">{}</td></tr>\n", columns.size(),
                          row.more);
    }
  }
  return text + "</tbody></table></div>\n";
}

std::string anchor_of(const std::string& text) {
  std::string anchor;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      anchor += c;
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (!anchor.empty() && anchor.back() == '-') anchor.pop_back();
  return anchor;
}

}  // namespace kinex::lab
