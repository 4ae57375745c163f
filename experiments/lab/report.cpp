// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/report.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>

namespace kinex::lab {

namespace {

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

constexpr int kUnfolded = 4;  // figures of a page with more

// The pictures, embedded, and the reason why some are missing; empty if there are none to draw. Where
// there are many the first are unfolded, the others a line each: a browser draws what is opened.
Html plots_part(const std::vector<Figure>& figures, const Drawings& drawings) {
  Html text;
  if (!drawings.problem.empty()) {
    text += html("<p><b>Not all plots could be drawn:</b> {}. The tables hold the same numbers.</p>\n",
                 drawings.problem);
  }
  const std::size_t count = std::min(figures.size(), drawings.svg.size());
  const bool folds = std::count_if(figures.begin(), figures.end(),
                                   [](const Figure& one) { return !one.joins; }) > 2 * kUnfolded;
  Html drawn;
  int frames = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Figure& first = figures[i];
    Html images;
    int pictures = 0;
    for (std::size_t j = i; j < count && (j == i || figures[j].joins); ++j) {
      i = j;
      if (drawings.svg[j].empty()) continue;
      ++pictures;
      images += html("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">",
                     picture_title(figures[j]), base64(drawings.svg[j]));
    }
    if (pictures == 0) continue;
    const Html row = Html::markup(pictures > 1 ? " class=\"row\"" : "");
    if (pictures > 1) images = html("<div>{}</div>", images);
    const std::string id = anchor_of("plot " + first.title);
    if (!folds) {
      drawn += html("<figure id=\"{}\"{}>{}<figcaption><b>{}</b>{}</figcaption></figure>\n", id, row,
                    images, first.title, first.caption);
    } else {
      drawn += html("<details id=\"{}\"{}{}><summary>{}</summary><figure>{}<figcaption>{}</figcaption>"
                    "</figure></details>\n",
                    id, row, Html::markup(frames < kUnfolded ? " open" : ""), first.title, images,
                    first.caption);
    }
    ++frames;
  }
  return drawn.empty() ? text : text + html("<div class=\"grid\">\n{}</div>\n", drawn);
}

const char* dirt_of(const PageFacts& facts) { return facts.build.dirty ? " with changes" : ""; }

// Command, build, machine.
Html facts_part(const PageFacts& facts) {
  const BuildFacts& build = facts.build;
  const MachineFacts& machine = facts.machine;
  const std::string before =
      facts.taken.before > 0
          ? fmt::format(", after {:.0f} s of parts that earlier commands had finished, each counted for itself",
                        facts.taken.before)
          : "";
  return html(
      "<p><code>{}</code> in {:.0f} s{}</p>\n"
      "<p class=\"facts\">{}, commit {}{}; {}; flags {}; {}</p>\n"
      "<p class=\"facts\">{}, {} cores, {} MB, {}</p>\n",
      facts.command, facts.taken.now, before, build.program, build.commit, dirt_of(facts), build.compiler,
      build.flags, build.libraries, machine.cpu, machine.cores, machine.memory_kb / 1024,
      machine.kernel);
}

}  // namespace

Html note_part(const std::string& text) { return html("<p class=\"facts\">{}</p>\n", text); }

Html origin_part(const std::string& scene, const PageFacts& facts) {
  return note_part(scene + "commit " + facts.build.commit + dirt_of(facts));
}

Html commands_part(const std::string& commands) { return html("<pre>{}</pre>\n", commands); }

std::string report_page(const Report& report, const Drawings& drawings, const PageFacts& facts) {
  Html lead = report.lead;
  if (report.interrupted) {
    lead += Html::markup("<p><b>Interrupted:</b> only what was finished is here.</p>\n");
  }
  HtmlPage page(report.title, report.verdict, report.good && !report.interrupted,
                lead + note_part(report.question));
  for (const HtmlSection& section : report.before) page.add(section);
  page.add({"plots", "Plots", plots_part(report.figures, drawings)});
  for (const HtmlSection& section : report.after) page.add(section);
  page.add({"origin", "How this was made", facts_part(facts)});
  return page.text();
}

}  // namespace kinex::lab
