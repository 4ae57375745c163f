// SPDX-License-Identifier: GPL-3.0-or-later
// EXPECT_INPUT_ERROR(statement, "fragment"): the statement throws InputError whose message has the
// text.
#ifndef KINEX_TESTS_EXPERIMENTS_EXPECT_INPUT_ERROR_H
#define KINEX_TESTS_EXPERIMENTS_EXPECT_INPUT_ERROR_H

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/formats/input_error.h"

#define EXPECT_INPUT_ERROR(statement, fragment)                           \
  try {                                                                   \
    statement;                                                            \
    ADD_FAILURE() << "no InputError with " << (fragment);                 \
  } catch (const kinex::formats::InputError& error) {                              \
    EXPECT_THAT(std::string(error.what()), testing::HasSubstr(fragment)); \
  }

#endif
