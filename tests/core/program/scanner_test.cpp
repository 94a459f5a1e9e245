#include "core/program/text/scanner.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "core/program/text/read_fault.h"

namespace feedscope {
namespace {

TEST(Scanner, NumbersAreTheNearestDoubles) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t digits = random() >> (random() % 60);
    std::string text = fmt::format("{}", digits % 1000000000);
    if (const std::size_t decimals = random() % 19; decimals > 0) {
      text += fmt::format(".{:0{}}", random() >> 4, decimals).substr(0, decimals + 1);
    }
    Scanner scanner(text);
    EXPECT_EQ(scanner.number(), std::strtod(text.c_str(), nullptr)) << text;
    EXPECT_TRUE(scanner.at_end()) << text;
  }
}

TEST(Scanner, NumbersEndWhereTheyEnd) {
  const auto read = [](std::string_view text, bool comma) {
    Scanner scanner(text);
    const std::optional<double> value = scanner.number(comma);
    return fmt::format("{} at {}", value ? fmt::format("{}", *value) : "none", scanner.at());
  };
  EXPECT_EQ(read("12.5X", false), "12.5 at 4");
  EXPECT_EQ(read("  .5", false), "0.5 at 4");
  EXPECT_EQ(read("5.", false), "5 at 2");
  EXPECT_EQ(read("1e5", false), "1 at 1");
  EXPECT_EQ(read("1,5", false), "1 at 1");
  EXPECT_EQ(read("1,5", true), "1.5 at 3");
  EXPECT_EQ(read(",5", true), "0.5 at 2");
  EXPECT_EQ(read("1.5,3", true), "1.5 at 3");
  EXPECT_EQ(read("000000000000000000012,25", true), "12.25 at 24");
  EXPECT_EQ(read(".", false), "none at 0");
  EXPECT_EQ(read("X1", false), "none at 0");
}

TEST(Scanner, RefusesNumbersThatAreNoneOrTooLarge) {
  for (const std::string text : {"1..2", "1.2.3", "2000000000", "99999999999999999999999", "1000000000.5"}) {
    Scanner scanner(text);
    EXPECT_THROW(scanner.number(), ReadFault) << text;
  }
  const std::string huge(400, '9');
  EXPECT_THROW(Scanner(huge).number(), ReadFault);
}

}  // namespace
}  // namespace feedscope
