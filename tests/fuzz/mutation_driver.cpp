// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds a harness with mutated copies of corpus files: the same inputs every time, with any
// compiler. usage: DRIVER COUNT SEED FOLDER..        all files below the folders, then COUNT
// mutations
//        DRIVER --one K SEED FOLDER..      mutation K alone, written to standard output first
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fuzz/harness.h"

extern "C" void __sanitizer_set_death_callback(void (*callback)()) __attribute__((weak));

namespace {

constexpr std::size_t kLongestInput = 4096;
constexpr int kGoodWeight = 20;

unsigned long long current_input = 0;

void name_input() {
  char text[80];
  const int size = std::snprintf(text, sizeof text, "fuzz: at mutation %llu\n", current_input);
  if (::write(STDERR_FILENO, text, static_cast<std::size_t>(size)) < 0) std::_Exit(1);
}

std::vector<std::string> read_corpus(int count, char** folders) {
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < count; ++i) {
    for (const auto& file : std::filesystem::recursive_directory_iterator(folders[i])) {
      if (file.is_regular_file()) paths.push_back(file.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    // Mutations of good files get deeper.
    const int copies = path.string().find("/good/") == std::string::npos ? 1 : kGoodWeight;
    for (int i = 0; i < copies; ++i) texts.push_back(text.str());
  }
  return texts;
}

class Mutator {
 public:
  Mutator(const std::vector<std::string>& corpus, std::uint64_t seed)
      : corpus_(corpus), random_(seed) {}

  std::string next() {
    std::string text = pick();
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(text);
    if (text.size() > kLongestInput) text.resize(kLongestInput);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }
  const std::string& pick() { return corpus_[below(corpus_.size())]; }

  void change(std::string& text) {
    static const char* const kTokens[] = {
        "0",    "-1",   "1/3",   "\"1/0\"", "1e9",    "1e-9",  "\"1e99999\"", "NaN",   "null",
        "true", "[]",   "{}",    "[",       "]",      "{",     "}",           ",",     ":",
        "\"",   "\\u0", "\n",    "\r",      "\0",     "\xff",  "#",           "/",     "0x1p-5",
        "1.5",  "\"\"", "\"a\"", " 2 ",     "\"id\"", "\"t\"", "4 1 0 0 0 1", "99999", "-0"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(24), text.size() - at);
    switch (below(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.insert(at, kTokens[below(std::size(kTokens))]);
        break;
      case 2:
        text.replace(at, length, kTokens[below(std::size(kTokens))]);
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(at, text.substr(at, length));
        break;
      case 5: {
        const std::string& other = pick();
        const std::size_t from = below(other.size() + 1);
        text = text.substr(0, at) + other.substr(from);
        break;
      }
      default:  // a digit for another
        for (std::size_t i = at; i < text.size(); ++i) {
          if (text[i] < '0' || text[i] > '9') continue;
          text[i] = static_cast<char>('0' + below(10));
          break;
        }
    }
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

void feed(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int argc, char** argv) {
  const bool one = argc > 1 && std::strcmp(argv[1], "--one") == 0;
  const int first = one ? 2 : 1;
  if (argc < first + 3) {
    std::fprintf(stderr, "usage: %s [--one] COUNT SEED FOLDER..\n", argv[0]);
    return 2;
  }
  const std::vector<std::string> corpus = read_corpus(argc - first - 2, argv + first + 2);
  if (corpus.empty()) {
    std::fprintf(stderr, "fuzz: the corpus is empty\n");
    return 1;
  }
  std::signal(SIGABRT, [](int) { name_input(); });
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(name_input);
  const unsigned long long count = std::strtoull(argv[first], nullptr, 10);
  Mutator mutator(corpus, std::strtoull(argv[first + 1], nullptr, 10));
  if (!one) {
    for (std::size_t i = 0; i < corpus.size(); ++i) {
      if (i == 0 || corpus[i] != corpus[i - 1]) feed(corpus[i]);
    }
  }
  for (unsigned long long i = 1; i <= count; ++i) {
    current_input = i;
    const std::string text = mutator.next();
    if (one && i < count) continue;
    if (one) std::fwrite(text.data(), 1, text.size(), stdout);
    feed(text);
  }
  std::fprintf(stderr, "fuzz: %zu files, %llu mutations\n", corpus.size(), count);
  return 0;
}
