#include "properties/random_cases.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace forge {
namespace {

std::uint64_t numberOr(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return otherwise;
  std::uint64_t value = 0;
  const char* end = text + std::strlen(text);
  const auto [read, error] = std::from_chars(text, end, value);
  if (error != std::errc() || read != end || text == end) {
    throw std::invalid_argument(std::string(variable) + " = \"" + text + "\" is no number");
  }
  return value;
}

std::string nameOfTest() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

/// Returns the text on how to repeat one case.
std::string repetition(std::uint64_t seed) {
  return "PROPERTY_SEED=" + std::to_string(seed) +
         " PROPERTY_CASES=1 properties_tests --gtest_filter=" + nameOfTest();
}

}  // namespace

CaseRange caseRange() {
  const CaseRange usual;
  return {numberOr("PROPERTY_CASES", usual.count), numberOr("PROPERTY_SEED", usual.first_seed)};
}

void forAllCases(const std::function<void(Random&)>& check, double share) {
  const CaseRange range = caseRange();
  const double count = std::ceil(share * static_cast<double>(range.count));
  for (std::uint64_t i = 0; static_cast<double>(i) < count; ++i) {
    const std::uint64_t seed = range.first_seed + i;
    SCOPED_TRACE(repetition(seed));
    Random random(seed);
    check(random);
    if (testing::Test::HasFailure()) return;
  }
}

void forMostCases(double least_share, const std::function<bool(Random&)>& check) {
  constexpr double kShare = 0.3;  // of the cases, because each runs two searches
  const CaseRange range = caseRange();
  std::uint64_t tried = 0, differing = 0;
  std::ostringstream seeds;
  forAllCases(
      [&](Random& random) {
        const std::uint64_t seed = range.first_seed + tried++;
        if (check(random)) return;
        ++differing;
        seeds << " " << seed;
      },
      kShare);
  std::cout << nameOfTest() << ": " << differing << " of " << tried << " cases differ"
            << (differing > 0 ? "; seeds" : "") << seeds.str() << std::endl;
  EXPECT_GE(static_cast<double>(tried - differing), least_share * static_cast<double>(tried));
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace forge
