// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/result_table.h"

#include <algorithm>
#include <stdexcept>

namespace kinex::lab {

namespace {

std::string heading(const std::string& key) {
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::FILE* append_to(const std::string& path) {
  if (path.empty()) return nullptr;
  std::FILE* file = std::fopen(path.c_str(), "ab");
  if (file == nullptr) throw std::runtime_error(path + " cannot be written");
  return file;
}

}  // namespace

ResultTable::ResultTable(const BenchOptions& options, std::string name, const std::string& about,
                         std::vector<Column> columns)
    : name_(std::move(name)),
      columns_(std::move(columns)),
      json_(append_to(options.json)),
      markdown_(append_to(options.markdown)) {
  std::string text, rule;
  for (Column& column : columns_) {
    const std::string words = heading(column.key);
    column.width = std::max(column.width, static_cast<int>(words.size()));
    char cell[200];
    std::snprintf(cell, sizeof cell, column.decimals == kText ? "%-*s  " : "%*s  ", column.width,
                  words.c_str());
    text += cell;
    if (markdown_)
      std::fprintf(markdown_.get(), "%s%s",
                   rule.empty() ? ("\n" + about + "\n\n| ").c_str() : " | ", words.c_str());
    rule += column.decimals == kText ? "| --- " : "| ---: ";
  }
  if (markdown_) std::fprintf(markdown_.get(), " |\n%s|\n", rule.c_str());
  std::printf("%s\n%s\n", about.c_str(), text.c_str());
}

std::string ResultTable::shown(std::size_t column, const Field& cell) const {
  if (columns_[column].decimals == kText) return cell.text;
  char number[64];
  std::snprintf(number, sizeof number, "%.*f", columns_[column].decimals, cell.number);
  return number;
}

void ResultTable::row(const std::vector<Field>& cells) {
  if (cells.size() != columns_.size()) throw std::logic_error("a row of another table");
  std::string text, object = "{\"bench\": \"" + name_ + "\"", line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_text = columns_[i].decimals == kText;
    const std::string value = shown(i, cells[i]);
    char cell[200];
    std::snprintf(cell, sizeof cell, is_text ? "%-*s  " : "%*s  ", columns_[i].width,
                  value.c_str());
    text += cell;
    object += ", \"" + columns_[i].key + "\": " + (is_text ? "\"" + value + "\"" : value);
    line += " " + value + " |";
  }
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  if (json_) std::fprintf(json_.get(), "%s}\n", object.c_str());
  if (markdown_) std::fprintf(markdown_.get(), "%s\n", line.c_str());
}

}  // namespace kinex::lab
