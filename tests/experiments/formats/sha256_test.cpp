// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/sha256.h"

#include <gtest/gtest.h>

namespace kinex {
namespace sha256_test {

// FIPS 180-4, example messages.
TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(formats::sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(formats::sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, GoesOnAfterHex) {
  formats::Sha256 digest;
  digest.add("a");
  digest.hex();
  digest.add("bc");
  EXPECT_EQ(digest.hex(), formats::sha256_hex("abc"));
}

}  // namespace sha256_test
}  // namespace kinex
