// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/number_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace kinex {

namespace {

using Unsigned128 = unsigned __int128;
constexpr std::uint64_t kTen19 = 10'000'000'000'000'000'000u;
constexpr std::size_t kBlock = 19;  // digits of a block below kTen19

void append_word(std::string& out, std::uint64_t value) {
  std::array<char, 24> buffer;
  out.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

// With its leading zeros.
void append_block(std::string& out, std::uint64_t value) {
  const std::size_t from = out.size();
  append_word(out, value);
  out.insert(from, kBlock - (out.size() - from), '0');
}

void append_integer(std::string& out, mpz_srcptr value) {
  static_assert(GMP_NUMB_BITS == 64);
  const std::size_t limbs = mpz_size(value);
  if (limbs > 2) {
    const std::size_t from = out.size();
    out.resize(from + mpz_sizeinbase(value, 10) + 2);
    mpz_get_str(out.data() + from, 10, value);
    out.resize(from + std::strlen(out.data() + from));
    return;
  }
  if (mpz_sgn(value) < 0) out += '-';
  if (limbs < 2) return append_word(out, mpz_getlimbn(value, 0));
  const Unsigned128 whole =
      static_cast<Unsigned128>(mpz_getlimbn(value, 1)) << 64 | mpz_getlimbn(value, 0);
  const Unsigned128 high = whole / kTen19;  // below 3.5 * 10^19
  if (high < kTen19) {
    append_word(out, static_cast<std::uint64_t>(high));
  } else {
    append_word(out, static_cast<std::uint64_t>(high / kTen19));
    append_block(out, static_cast<std::uint64_t>(high % kTen19));
  }
  append_block(out, static_cast<std::uint64_t>(whole % kTen19));
}

}  // namespace

void append(std::string& out, const Integer& value) { append_integer(out, value.raw()); }

void append(std::string& out, const Rational& value) {
  append_integer(out, mpq_numref(value.raw()));
  if (value.is_integer()) return;
  out += '/';
  append_integer(out, mpq_denref(value.raw()));
}

}  // namespace kinex
