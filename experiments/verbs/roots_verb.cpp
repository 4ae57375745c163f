// SPDX-License-Identifier: GPL-3.0-or-later
// kinex roots: the real roots of polynomials, exactly.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "core/numbers/real_root.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/polynomial_file.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

constexpr int kMaxDigits = 100000;

struct RootsOptions {
  std::string file;
  int digits = 20;
  bool json = false;
};

std::string json_line(int degree, std::vector<RootWithMultiplicity>& roots, int digits,
                      RootCounters& counters) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("degree").number(degree).key("roots").begin_array();
  for (auto& [root, multiplicity] : roots) {
    // The interval as it was isolated: the decimal below narrows it.
    const std::string lower = root.lower().to_string();
    const std::string upper = root.upper().to_string();
    json.begin_object().key("multiplicity").number(multiplicity);
    json.key("interval").begin_array().string(lower).string(upper).end_array();
    json.key("decimal").string(decimal(root, digits, counters)).end_object();
  }
  json.end_array().end_object();
  return text + "\n";
}

std::string plain_lines(const formats::PolynomialLine& entry, std::vector<RootWithMultiplicity>& roots,
                        int digits, RootCounters& counters) {
  std::string text = "line " + std::to_string(entry.line) + ": degree " +
                     std::to_string(entry.polynomial.degree()) + ", " +
                     formats::counted(roots.size(), "distinct real root", "distinct real roots") +
                     "\n";
  for (std::size_t i = 0; i < roots.size(); ++i) {
    RealRoot& root = roots[i].root;
    const std::string lower = root.lower().to_string();
    const std::string upper = root.upper().to_string();
    text += "  root " + std::to_string(i + 1) + ", multiplicity " +
            std::to_string(roots[i].multiplicity) + ", in [" + lower + ", " + upper + "], " +
            decimal(root, digits, counters) + "\n";
  }
  return text;
}

void find_roots(const RootsOptions& options, const Voice& voice) {
  if (options.digits < 0 || options.digits > kMaxDigits) {
    throw formats::InputError("--digits", "", std::to_string(options.digits) + " digits",
                     "write a number from 0 to " + std::to_string(kMaxDigits));
  }
  const std::string text = formats::read_text_file(options.file);
  for (const formats::PolynomialLine& entry : formats::parse_polynomials(text, options.file)) {
    RootCounters counters;
    std::vector<RootWithMultiplicity> roots = isolate_real_roots(entry.polynomial, counters);
    print(options.json ? json_line(entry.polynomial.degree(), roots, options.digits, counters)
                       : plain_lines(entry, roots, options.digits, counters));
    voice.detail("line " + std::to_string(entry.line) + ": " +
                 formats::counted(counters.refinements, "refinement", "refinements") + ", " +
                 formats::counted(counters.gcds, "gcd", "gcds") + ", coefficients of at most " +
                 formats::counted(counters.max_bits, "bit", "bits"));
  }
}

}  // namespace

void add_roots_verb(CLI::App& app, int&) {
  auto options = std::make_shared<RootsOptions>();
  CLI::App* verb = app.add_subcommand("roots", "Real roots of polynomials, exactly");
  verb->add_option("FILE", options->file,
                   "One polynomial per line: degree c0 c1 .. cd, integers, fractions or decimals, "
                   "degree up to 400; # begins a comment; - reads standard input")
      ->required();
  verb->add_option("--digits", options->digits, "Digits after the decimal point (20)");
  verb->add_flag("--json", options->json, "One JSON object a line");
  add_voice(*verb, "Print the roots and errors",
            "Count the work of each line, on standard error");
  verb->footer("Example: the roots of t^2 - 2\n  echo '2 -2 0 1' | kinex roots - --digits 30");
  verb->callback([options, verb] { find_roots(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
