// SPDX-License-Identifier: GPL-3.0-or-later
// InputError: a defect of a file or an option, with its place and a remedy.
#ifndef KINEX_EXPERIMENTS_INPUT_ERROR_H
#define KINEX_EXPERIMENTS_INPUT_ERROR_H

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

namespace kinex {

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

// A piece of input as it is shown in a message: printable ASCII in double quotes, cut after 40
// bytes.
inline std::string show_text(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  static constexpr char kHex[] = "0123456789abcdef";
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size() && i < kLongest; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 0x20 && byte < 0x7f) {
      result += text[i];
    } else {
      result += "\\x";
      result += kHex[byte >> 4];
      result += kHex[byte & 15];
    }
  }
  result += '"';
  if (text.size() > kLongest) result += " (" + std::to_string(text.size()) + " bytes)";
  return result;
}

}  // namespace kinex

#endif
