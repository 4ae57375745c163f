// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3 on real motion: the nearest stars, in linear motion for 10,000 years.
#include <fstream>
#include <sstream>

#include "tests/shared_data.h"
#include "tests/structures/triangulation/delaunay_3_support.h"

namespace kinex::delaunay_3_test {
namespace delaunay_3_stars_test {

// Parsecs, and parsecs per million years.
TEST(Delaunay3, NearestStars) {
  const std::string path = shared_data("nearest_stars.csv");
  KINEX_REQUIRE_DATA(path);
  std::ifstream file(path);
  std::string line;
  std::vector<Trajectory> motions;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream fields(line);
    std::string field;
    std::getline(fields, field, ',');  // its name
    std::array<Rational, 6> numbers;
    for (Rational& number : numbers) {
      std::getline(fields, field, ',');
      const auto read = Rational::parse(field);
      ASSERT_TRUE(read) << field;
      number = *read;
    }
    motions.push_back(
        moving({numbers[0], numbers[3]}, {numbers[1], numbers[4]}, {numbers[2], numbers[5]}));
  }
  ASSERT_GT(motions.size(), 100u);
  World world(test::scene_of(motions, 0, Rational(Integer(1), Integer(100))), "exact",
              AuditLevel::kEnd);
  world.run().expect_clean();
  EXPECT_GT(world.ledger().external, 100u);
  ::testing::Test::RecordProperty("events", std::to_string(world.ledger().external));
}

}  // namespace delaunay_3_stars_test
}  // namespace kinex::delaunay_3_test
