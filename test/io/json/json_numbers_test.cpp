#include "collision_forge/io/json/json_numbers.h"

#include <gtest/gtest.h>
#include <rapidjson/memorystream.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace forge {
namespace {

/// Returns the number read from JSON text, or the code of the error.
std::string readAs(const std::string& text, double* value) {
  rapidjson::Document document;
  rapidjson::MemoryStream stream(text.data(), text.size());
  const rapidjson::ParseResult result = parseExactly<rapidjson::kParseNoFlags>(stream, document);
  if (result.IsError()) return "code " + std::to_string(result.Code());
  *value = document.GetDouble();
  return "";
}

double readNumber(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(readAs(text, &value), "") << text;
  return value;
}

TEST(JsonNumbers, ShortNumbersOfManyZerosAreRead) {
  EXPECT_EQ(readNumber("0." + std::string(348, '0') + "1"), 0.0);
  EXPECT_EQ(readNumber("0." + std::string(322, '0') + "1"), 1e-323);
  EXPECT_EQ(readNumber("128.74836467836484838364836483643636483648e-336"),
            std::strtod("128.74836467836484838364836483643636483648e-336", nullptr));
  EXPECT_EQ(readNumber("-1e-999999999999"), 0.0);
  EXPECT_EQ(
      readNumber("1" + std::string(300, '0') + "." + std::string(2000, '7') + "e-300"),
      std::strtod(("1" + std::string(300, '0') + "." + std::string(2000, '7') + "e-300").c_str(),
                  nullptr));
}

TEST(JsonNumbers, AreTheNearestDouble) {
  const unsigned seed = 20261125;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    text += std::to_string(random() % 10);
    const std::size_t digits = random() % 60;
    if (digits > 0) text += '.';
    for (std::size_t digit = 0; digit < digits; ++digit) text += std::to_string(random() % 10);
    text += 'e' + std::to_string(static_cast<int>(random() % 640) - 335);
    const double nearest = std::strtod(text.c_str(), nullptr);
    if (std::isfinite(nearest)) {
      EXPECT_EQ(readNumber(text), nearest) << text;
    } else {
      double value = 0.0;
      EXPECT_NE(readAs(text, &value), "") << text;
    }
  }
}

TEST(JsonNumbers, IntegersStayIntegers) {
  rapidjson::Document document;
  const char* const text = "[0,-0,7,-7,18446744073709551615,-9223372036854775808,1.0]";
  rapidjson::MemoryStream stream(text, std::strlen(text));
  ASSERT_FALSE(parseExactly<rapidjson::kParseNoFlags>(stream, document).IsError());
  EXPECT_TRUE(document[0].IsUint());
  EXPECT_TRUE(document[1].IsDouble()) << "integers have no -0";
  EXPECT_TRUE(std::signbit(document[1].GetDouble()));
  EXPECT_EQ(document[2].GetUint(), 7u);
  EXPECT_EQ(document[3].GetInt(), -7);
  EXPECT_EQ(document[4].GetUint64(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(document[5].GetInt64(), std::numeric_limits<std::int64_t>::min());
  EXPECT_FALSE(document[6].IsInt());
}

TEST(JsonNumbers, RejectsNumbersBeyondTheRangeOfDouble) {
  const std::string too_big = "code " + std::to_string(rapidjson::kParseErrorNumberTooBig);
  double value = 0.0;
  for (const std::string text :
       {"1e400", "-1e309", "1.7976931348623159e308", "17976931348623159e292"}) {
    EXPECT_EQ(readAs(text, &value), too_big) << text;
  }
  EXPECT_EQ(readAs("1" + std::string(400, '0'), &value), too_big);
  for (const std::string text : {"NaN", "Infinity", "-Infinity", "1e", ".5", "0x1", "+1"}) {
    EXPECT_NE(readAs(text, &value), "") << text;
  }
}

}  // namespace
}  // namespace forge
