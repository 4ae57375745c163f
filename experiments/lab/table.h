// SPDX-License-Identifier: GPL-3.0-or-later
// Table: a report's rows of text.
#ifndef KINEX_EXPERIMENTS_LAB_TABLE_H
#define KINEX_EXPERIMENTS_LAB_TABLE_H

#include <string>
#include <vector>

namespace kinex::lab {

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  // each as long as the header
  std::string note;                            // the meaning of the numbers
};

// In Markdown, with a newline in front.
std::string markdown(const Table& table);

}  // namespace kinex::lab

#endif
