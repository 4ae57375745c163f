// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/table.h"

namespace kinex::lab {

std::string markdown(const Table& table) {
  std::string text = "\n## " + table.title + "\n\n";
  if (!table.note.empty()) text += table.note + "\n\n";
  text += "|";
  for (const std::string& cell : table.header) text += " " + cell + " |";
  text += "\n|";
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    text += i == 0 || i == 2 ? " --- |" : " ---: |";
  }
  text += "\n";
  for (const auto& row : table.rows) {
    text += "|";
    for (const std::string& cell : row) text += " " + cell + " |";
    text += "\n";
  }
  return text;
}

}  // namespace kinex::lab
