// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/html.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>

#include "experiments/lab/html_page.h"

namespace kinex::lab {

namespace {

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  // The table for terminals is ASCII; a page need not be.
  for (std::size_t at = 0; (at = result.find("+-", at)) != std::string::npos;) {
    result.replace(at, 2, "&plusmn;");
  }
  return result;
}

std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings) {
  std::string text;
  if (!drawings.problem.empty()) {
    text += "<p><b>Not all plots could be drawn:</b> " + escape(drawings.problem) +
            ". The tables hold the same numbers.</p>\n";
  }
  const std::size_t count = std::min(figures.size(), drawings.svg.size());
  std::string drawn;
  for (std::size_t i = 0; i < count; ++i) {
    const Figure& first = figures[i];
    std::string images;
    int pictures = 0;
    for (std::size_t j = i; j < count && (j == i || figures[j].joins); ++j) {
      i = j;
      if (drawings.svg[j].empty()) continue;
      ++pictures;
      images += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">",
                            escape(first.title), base64(drawings.svg[j]));
    }
    if (pictures == 0) continue;
    drawn += fmt::format("<figure id=\"{}\"{}>{}<figcaption><b>{}</b>{}</figcaption></figure>\n",
                         anchor_of("plot " + first.title), pictures > 1 ? " class=\"row\"" : "",
                         pictures > 1 ? "<div>" + images + "</div>" : images, escape(first.title),
                         escape(first.caption));
  }
  return drawn.empty() ? text : text + "<div class=\"grid\">\n" + drawn + "</div>\n";
}

std::string facts_part(const PageFacts& facts) {
  const BuildFacts& build = facts.build;
  const MachineFacts& machine = facts.machine;
  return fmt::format(
      "<p><code>{}</code> in {:.0f} s</p>\n"
      "<p class=\"facts\">{}, commit {}{}; {}; flags {}; {}</p>\n"
      "<p class=\"facts\">{}, {} cores, {} MB, {}</p>\n",
      escape(facts.command), facts.seconds, escape(build.program), escape(build.commit),
      build.dirty ? " with changes" : "", escape(build.compiler), escape(build.flags),
      escape(build.libraries), escape(machine.cpu), machine.cores, machine.memory_kb / 1024,
      escape(machine.kernel));
}

}  // namespace kinex::lab
