// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/program/star_witness.h"

#include <sstream>

#include "tests/program/spawn.h"

namespace kinex {

namespace {

std::int64_t millionths(const std::string& text) {
  const std::size_t point = text.find('.');
  std::string digits = text.substr(0, point);
  std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
  fraction.resize(6, '0');
  return std::stoll(digits + fraction);
}

}  // namespace

std::map<std::string, Star> read_stars(const std::string& file) {
  std::map<std::string, Star> stars;
  std::istringstream lines(read_file(file));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string id, field;
    std::getline(fields, id, ',');
    Star& star = stars[id];
    for (std::int64_t* vector : {star.position.data(), star.velocity.data()}) {
      for (int axis = 0; axis < 3; ++axis) {
        std::getline(fields, field, ',');
        vector[axis] = millionths(field);
      }
    }
  }
  return stars;
}

}  // namespace kinex
