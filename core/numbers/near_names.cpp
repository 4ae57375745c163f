// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/near_names.h"

#include <algorithm>

namespace kinex {

namespace {

constexpr std::size_t kMostNames = 3;
constexpr std::size_t kLongestName = 100;  // a longer text is no misspelt name
constexpr std::size_t kShortestPart = 4, kShortestBeginning = 3;

std::string plain(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = '_';
  }
  return result;
}

// Without the number of axes at the end: "delaunay" of "delaunay_2".
std::string_view stem(std::string_view name) {
  const bool numbered =
      name.size() > 2 && name[name.size() - 2] == '_' && name.back() >= '0' && name.back() <= '9';
  return numbered ? name.substr(0, name.size() - 2) : name;
}

}  // namespace

std::size_t name_distance(std::string_view first, std::string_view second) {
  const std::string a = plain(first), b = plain(second);
  // rows[i % 3][j]: the distance of the first i letters of a and the first j of b.
  std::vector<std::vector<std::size_t>> rows(3, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t>& row = rows[i % 3];
    const std::vector<std::size_t>& above = rows[(i + 2) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], rows[(i + 1) % 3][j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& known) {
  if (name.empty() || name.size() > kLongestName) return {};
  std::size_t nearest = std::max<std::size_t>(1, name.size() / 3);
  std::vector<std::string> near, holding;
  for (const std::string& other : known) {
    const std::size_t distance = std::min(name_distance(name, other), name_distance(name, stem(other)));
    if (distance < nearest) near.clear();
    if (distance <= nearest) near.push_back(other);
    nearest = std::min(nearest, distance);
    const std::size_t at = plain(other).find(plain(name));
    if (at == std::string::npos) continue;
    if (name.size() >= (at == 0 ? kShortestBeginning : kShortestPart)) holding.push_back(other);
  }
  if (near.empty()) near = std::move(holding);
  if (near.size() > kMostNames) near.resize(kMostNames);
  return near;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                         const std::string& otherwise) {
  const std::vector<std::string> near = near_names(name, known);
  if (near.empty()) return otherwise;
  std::string text = "did you mean " + near.front();
  for (std::size_t i = 1; i < near.size(); ++i) {
    text += (i + 1 < near.size() ? ", " : " or ") + near[i];
  }
  return text + "?";
}

}  // namespace kinex
