// SPDX-License-Identifier: GPL-3.0-or-later
// InputError: a defect of a file or an option, with its place and a remedy.
#ifndef KINEX_EXPERIMENTS_FORMATS_INPUT_ERROR_H
#define KINEX_EXPERIMENTS_FORMATS_INPUT_ERROR_H

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "core/numbers/show_text.h"

namespace kinex::formats {

// what() is "FILE: PLACE: PROBLEM; REMEDY", for example
//   scene.json: /objects/3/motion/0/1: "0.1.2" is not a number; write an integer, ...
// PLACE is a JSON path or "line 7"; it and REMEDY may be empty.
class InputError : public std::exception {
 public:
  InputError(std::string file, std::string place, std::string problem, std::string remedy)
      : file_(std::move(file)),
        place_(std::move(place)),
        problem_(std::move(problem)),
        remedy_(std::move(remedy)) {
    message_ = file_ + ": ";
    if (!place_.empty()) message_ += place_ + ": ";
    message_ += problem_;
    if (!remedy_.empty()) message_ += "; " + remedy_;
  }
  const char* what() const noexcept override { return message_.c_str(); }
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string file_, place_, problem_, remedy_, message_;
};

}  // namespace kinex::formats

#endif
