#include "collision_forge/io/logs/nuscenes_tokens.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace forge {
namespace {

std::string hexToken(unsigned number) {
  char digits[33];
  std::snprintf(digits, sizeof digits, "%032x", number);
  return digits;
}

TEST(NuScenesTokens, anyStringKeepsItsNumberAndText) {
  TokenIndex index;
  const std::string tokens[] = {"",
                                "a",
                                "0123456789abcdef0123456789abcdef",
                                "0123456789ABCDEF0123456789ABCDEF",
                                std::string(32, '0'),
                                "0123456789abcdef0123456789abcdeg",
                                std::string(1000, 'x')};
  std::uint32_t number = 0;
  for (const std::string& token : tokens) {
    EXPECT_FALSE(index.find(token).has_value());
    EXPECT_EQ(index.add(token), std::make_pair(number, true));
    EXPECT_EQ(index.add(token), std::make_pair(number, false));
    ++number;
  }
  for (number = 0; number < index.size(); ++number) {
    EXPECT_EQ(index.text(number), tokens[number]);
    EXPECT_EQ(index.find(tokens[number]), number);
  }
}

TEST(NuScenesTokens, growsWithBothKindsOfTokens) {
  constexpr unsigned kCount = 20000;
  TokenIndex index;
  for (unsigned i = 0; i < kCount; ++i) {
    index.add(i % 3 == 0 ? std::to_string(i) : hexToken(i));
  }
  ASSERT_EQ(index.size(), kCount);
  for (unsigned i = 0; i < kCount; ++i) {
    const std::string token = i % 3 == 0 ? std::to_string(i) : hexToken(i);
    ASSERT_EQ(index.find(token), i);
    ASSERT_EQ(index.text(i), token);
  }
  EXPECT_FALSE(index.find(hexToken(kCount + 1)).has_value());
}

}  // namespace
}  // namespace forge
