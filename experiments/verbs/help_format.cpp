// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/help_format.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>

namespace kinex::verbs {

namespace {

constexpr std::size_t kColumns = 80;

// The words with line breaks between them where a line would be wider; a word that is wider is left as it is.
std::string wrapped(const std::string& text, std::size_t width) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::string part;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (!part.empty() && part.size() + 1 + word.size() > width) {
        result += (result.empty() ? "" : "\n") + part;
        part.clear();
      }
      part += (part.empty() ? "" : " ") + word;
    }
    result += (result.empty() ? "" : "\n") + part;
  }
  return result;
}

class HelpFormat final : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    return described(make_option_name(option, is_positional) + make_option_opts(option),
                     make_option_desc(option));
  }
  std::string make_subcommand(const CLI::App* verb) const override {
    return described(verb->get_display_name(true), verb->get_description());
  }

 private:
  std::string described(const std::string& name, const std::string& text) const {
    std::ostringstream out;
    CLI::detail::format_help(out, name, wrapped(text, kColumns - get_column_width()), get_column_width());
    return out.str();
  }
};

}  // namespace

void set_help_format(CLI::App& app) { app.formatter(std::make_shared<HelpFormat>()); }

}  // namespace kinex::verbs
