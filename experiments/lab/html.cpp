// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/html.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>

namespace kinex::lab {

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style>
:root { color-scheme: light; }
body { font: 15px/1.45 system-ui, "Helvetica Neue", Arial, sans-serif; color: #1a1a1a;
  background: #fff; margin: 2rem auto; padding: 0 1.5rem; max-width: 1360px;
  position: relative; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
p.facts { color: #555; margin: .2rem 0; }
.verdicts { display: flex; gap: .8rem; flex-wrap: wrap; margin: 1rem 0; }
.verdicts div { border: 1px solid #ccc; border-radius: 6px; padding: .5rem 1rem; }
.verdicts b { font-size: 1.4rem; margin-right: .3rem; }
.v { font-weight: 600; white-space: nowrap; }
.PASS { color: #00583f; } .FAIL { color: #a33a00; } .INCONCLUSIVE, .GAVE { color: #6b5500; }
.grid { display: grid; gap: 1.2rem; align-items: start;
  grid-template-columns: repeat(auto-fill, minmax(min(560px, 100%), 1fr)); }
figure { margin: 0; border: 1px solid #ddd; border-radius: 6px; padding: .8rem; }
figure img { width: 100%; height: auto; }
figure.row { grid-column: 1 / -1; }
figure.row div { display: grid; gap: .6rem;
  grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr)); }
figcaption b { display: block; } figcaption { color: #333; font-size: .87rem; }
table { border-collapse: collapse; font-size: .84rem; width: 100%; }
th, td { padding: .22rem .5rem; text-align: left; border-bottom: 1px solid #e4e4e4;
  vertical-align: top; }
th { position: sticky; top: 0; background: #f3f3f3; border-bottom: 2px solid #bbb; }
td.r, th.r { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.first td { border-top: 2px solid #bbb; }
details summary { cursor: pointer; color: #0b5394; white-space: nowrap; }
details div { position: absolute; right: 1.5rem; max-width: 900px; z-index: 2; background: #fff;
  border: 1px solid #999; border-radius: 6px; padding: .5rem; box-shadow: 0 2px 12px #0004; }
details table { width: auto; } details th { position: static; }
code { background: #f3f3f3; padding: .1rem .3rem; border-radius: 3px; overflow-wrap: anywhere; }
</style>)";

std::string base64(const std::string& bytes) {
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

std::string html_head(const std::string& title) {
  return fmt::format("{}\n<title>{}</title></head><body>\n<h1>{}</h1>\n", kHead, escape(title),
                     escape(title));
}

std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings) {
  std::string text = "<h2>Plots</h2>\n";
  if (!drawings.problem.empty()) {
    text += "<p><b>Not all plots could be drawn:</b> " + escape(drawings.problem) +
            ". The tables hold the same numbers.</p>\n";
  }
  text += "<div class=\"grid\">\n";
  const std::size_t count = std::min(figures.size(), drawings.svg.size());
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
    text += fmt::format("<figure{}>{}<figcaption><b>{}</b>{}</figcaption></figure>\n",
                        pictures > 1 ? " class=\"row\"" : "",
                        pictures > 1 ? "<div>" + images + "</div>" : images, escape(first.title),
                        escape(first.caption));
  }
  return text + "</div>\n";
}

std::string facts_part(const PageFacts& facts) {
  const BuildFacts& build = facts.build;
  const MachineFacts& machine = facts.machine;
  return fmt::format(
      "<h2>How this was made</h2>\n<p><code>{}</code> in {:.0f} s</p>\n"
      "<p class=\"facts\">{}, commit {}{}; {}; flags {}; {}</p>\n"
      "<p class=\"facts\">{}, {} cores, {} MB, {}</p>\n",
      escape(facts.command), facts.seconds, escape(build.program), escape(build.commit),
      build.dirty ? " with changes" : "", escape(build.compiler), escape(build.flags),
      escape(build.libraries), escape(machine.cpu), machine.cores, machine.memory_kb / 1024,
      escape(machine.kernel));
}

}  // namespace kinex::lab
