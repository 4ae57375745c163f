// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/gnuplot.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "experiments/lab/helper_program.h"
#include "experiments/lab/temporary_folder.h"

namespace kinex::lab {

namespace fs = std::filesystem;

namespace {

// Filled symbols, strokes, and hollow symbols.
constexpr Look kLooks[] = {{"#0072B2", 7, 6},   {"#D55E00", 5, 4},   {"#009E73", 9, 8},
                           {"#CC79A7", 13, 12}, {"#E69F00", 11, 10}, {"#56B4E9", 15, 14},
                           {"#000000", 2, 2},   {"#882255", 1, 1},   {"#777777", 3, 3},
                           {"#332288", 6, 6},   {"#999933", 4, 4},   {"#44AA99", 8, 8},
                           {"#AA4499", 12, 12}, {"#661100", 10, 10}, {"#117733", 14, 14}};
constexpr const char* kDashes[] = {"2",          "(16,5)",         "(4,4)",
                                   "(16,4,4,4)", "(16,4,4,4,4,4)", "(26,8)"};
constexpr const char* kGuideDashes[] = {"3",      "(12,6)", "(14,5,2,5)",
                                        "(3,12)", "(30,5)", "(14,4,2,4,2,4,2,4)"};

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void replace_all(std::string& text, const std::string& old, const std::string& fresh) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += fresh.size()) {
    text.replace(at, old.size(), fresh);
  }
}

// gnuplot names one font; a machine without it would take one with serifs.
std::string with_known_fonts(std::string svg) {
  replace_all(svg, "font-family=\"Helvetica\"",
              "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\"");
  return svg;
}

// Without what draws nothing: half of the file. Groups without content, filters of no text, and the font
// of a part of a text, which is that of the text.
std::string slim(std::string svg) {
  replace_all(svg, "<tspan font-family=\"Helvetica\" ", "<tspan ");
  const std::string end = ">\n</g>\n";
  for (std::size_t at = 0; (at = svg.find(end, at)) != std::string::npos;) {
    const std::size_t line = svg.rfind('\n', at) + 1;
    if (svg.compare(line, 3, "<g ") == 0 && svg.find('>', line) == at) {
      svg.erase(line, at + end.size() - line);
      at = line;
    } else {
      at += end.size();
    }
  }
  const std::size_t filters = svg.find("\t<filter"), defs = svg.find("</defs>");
  if (filters < defs && defs != std::string::npos && svg.find("url(#") == std::string::npos) {
    svg.erase(filters, defs - filters);
  }
  return svg;
}

std::string xml(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return result;
}

// The text of the first element of this name from a place on; returns the place behind that text.
std::size_t set_element(std::string& svg, const std::string& name, const std::string& text,
                        std::size_t from) {
  const std::string begin = "<" + name + ">";
  const std::size_t at = svg.find(begin, from), end = svg.find("</" + name + ">", at);
  if (at == svg.npos || end == svg.npos) return from;
  const std::string plain = xml(text);
  svg.replace(at + begin.size(), end - at - begin.size(), plain);
  return at + begin.size() + plain.size();
}

// What a screen reader reads: title, description, and the names of the curves (those of gnuplot have lost
// their exponents).
std::string with_words(std::string svg, const Figure& figure) {
  if (svg.compare(svg.find("<svg"), 6, "<svg \n") == 0)
    svg.insert(svg.find("<svg") + 5, "role=\"img\"");
  std::size_t at = set_element(svg, "title", picture_title(figure), 0);
  at = set_element(svg, "desc", figure.caption, at);
  for (const std::string& name : figure.names) at = set_element(svg, "title", name, at);
  return svg;
}

}  // namespace

std::string picture_title(const Figure& figure) {
  const bool alone = figure.panel.empty() || figure.panel == figure.title;
  return alone ? figure.title : figure.title + ": " + figure.panel;
}

Drawings draw(const std::vector<Figure>& figures, const std::string& program,
              const std::function<bool()>& go_on) {
  Drawings drawings;
  drawings.svg.resize(figures.size());
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    drawings.problem = "no temporary folder could be made";
    return drawings;
  }
  std::ofstream script(folder.path() / "plots.gp");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    // A picture has a size of its own: without, a page stretches it to its full width.
    // The folder's name is safe inside quotes: it comes from mkdtemp.
    script << "reset\nset encoding utf8\nset terminal svg size " << figures[i].width << ","
           << figures[i].height << " fixed enhanced font 'Helvetica,13' background 'white'\n"
           << "set output '" << (folder.path() / std::to_string(i)).string() << ".svg'\n"
           << figures[i].script << "\nunset output\n";
  }
  script.close();
  const std::string log = (folder.path() / "log").string();
  const HelperEnd end =
      run_helper(program, {(folder.path() / "plots.gp").string()}, log, log, go_on);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string svg = read(folder.path() / (std::to_string(i) + ".svg"));
    if (svg.find("</svg>") == std::string::npos) continue;
    drawings.svg[i] = with_words(with_known_fonts(slim(svg)), figures[i]);
  }
  if (end.how == HelperEnd::How::kNotFound) {
    drawings.problem = program + " is not installed";
  } else if (end.how == HelperEnd::How::kStopped) {
    drawings.problem = "interrupted";
  } else if (end.how == HelperEnd::How::kSignal || end.code != 0) {
    drawings.problem = program + " failed: " + read(folder.path() / "log").substr(0, 300);
  }
  return drawings;
}

const Look& look(std::size_t i) { return kLooks[i % std::size(kLooks)]; }

const char* dash(std::size_t i) { return kDashes[i % std::size(kDashes)]; }

const char* guide_dash(std::size_t i) { return kGuideDashes[i % std::size(kGuideDashes)]; }

std::string marked(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "''";
      continue;
    }
    if (c == '_' || c == '^' || c == '{' || c == '}' || c == '@' || c == '&') result += '\\';
    result += c;
  }
  return result;
}

std::string quoted(const std::string& text) { return "'" + marked(text) + "'"; }

std::string title_command(const std::string& first, const std::string& second) {
  if (second.empty()) return "set title " + quoted(first) + "\n";
  // Between double quotes a backslash and a quote have one more backslash, and \n ends a line.
  std::string text;
  for (const char c : marked(first) + "\n" + marked(second)) {
    if (c == '\n') {
      text += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return "set title \"" + text + "\"\n";
}

std::string formula(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 5, "Theta") == 0) {
      result += "\u0398";
      i += 4;
    } else if (text[i] == '^' && i + 1 < text.size()) {
      const bool group = text[i + 1] == '(';
      const std::size_t begin = i + (group ? 2 : 1);
      std::size_t end = begin;
      if (group) {
        end = std::min(text.find(')', begin), text.size());
      } else {
        const auto is_part = [](char c) {
          return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '/' ||
                 c == '-';
        };
        while (end < text.size() && is_part(text[end])) ++end;
        while (end > begin && text[end - 1] == '.') --end;  // a full stop
      }
      result += "^{" + marked(text.substr(begin, end - begin)) + "}";
      i = group ? end : end - 1;
    } else {
      result += marked(std::string(1, text[i]));
    }
  }
  return result;
}

}  // namespace kinex::lab
