// SPDX-License-Identifier: GPL-3.0-or-later
// Sha256: a running SHA-256 digest (FIPS 180-4, by OpenSSL's EVP).
#ifndef KINEX_EXPERIMENTS_FORMATS_SHA256_H
#define KINEX_EXPERIMENTS_FORMATS_SHA256_H

#include <memory>
#include <string>
#include <string_view>

namespace kinex::formats {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(std::string_view bytes);
  // 64 lower-case hexadecimal digits of everything added so far; more may be added afterwards.
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string sha256_hex(std::string_view bytes);

}  // namespace kinex::formats

#endif
