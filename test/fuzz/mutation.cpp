#include "fuzz/mutation.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace forge {
namespace {

using Random = std::mt19937_64;

/// Texts that are difficult for parsers, mostly numbers.
const char* const kOddTexts[] = {"0",
                                 "-0.0",
                                 "-1",
                                 "1e308",
                                 "-1e308",
                                 "1e309",
                                 "1e-308",
                                 "5e-324",
                                 "3e38",
                                 "1e9",
                                 "1e7",
                                 "NaN",
                                 "nan",
                                 "inf",
                                 "-Infinity",
                                 "null",
                                 "true",
                                 "\"\"",
                                 "[]",
                                 "{}",
                                 "2147483648",
                                 "18446744073709551616",
                                 "-9223372036854775809",
                                 "0x10",
                                 "1.5",
                                 "../evil",
                                 ",",
                                 "\n",
                                 ":",
                                 "~",
                                 "\xff\xfe",
                                 "\\u0000",
                                 "0.000000000000000000000000000000001"};

std::size_t below(std::size_t bound, Random& random) {
  return bound == 0 ? 0 : static_cast<std::size_t>(random() % bound);
}

bool isOfNumber(char letter) {
  return std::isdigit(static_cast<unsigned char>(letter)) != 0 || std::strchr("+-.eE", letter);
}

/// Returns offset and length of the first number or word at or after a random offset.
std::pair<std::size_t, std::size_t> textIn(const std::string& bytes, Random& random) {
  const bool is_number = random() % 4 != 0;
  const auto belongs = [&](char letter) {
    return letter != '\0' &&
           (is_number ? isOfNumber(letter) : std::isalnum(static_cast<unsigned char>(letter)) != 0);
  };
  const auto start = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size(), random));
  const auto begin = std::find_if(start, bytes.end(), belongs);
  const auto end = std::find_if_not(begin, bytes.end(), belongs);
  return {static_cast<std::size_t>(begin - bytes.begin()), static_cast<std::size_t>(end - begin)};
}

void changeByte(std::string& bytes, Random& random) {
  if (!bytes.empty()) bytes[below(bytes.size(), random)] = static_cast<char>(random());
}

/// Overwrites 4 or 8 bytes by a number that is unusual for a length or a value.
void changeWord(std::string& bytes, Random& random) {
  constexpr std::uint64_t kOddWords[] = {
      0, 1, 0x7f, 0xff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7ff0000000000000, 0x7ff8000000000000};
  const std::uint64_t word = kOddWords[below(std::size(kOddWords), random)];
  const std::size_t size = random() % 2 == 0 ? 4 : 8;
  if (bytes.size() >= size) {
    std::memcpy(bytes.data() + below(bytes.size() - size + 1, random), &word, size);
  }
}

void changeText(std::string& bytes, Random& random) {
  const auto [begin, size] = textIn(bytes, random);
  bytes.replace(begin, size, kOddTexts[below(std::size(kOddTexts), random)]);
}

std::string somePart(const std::string& bytes, Random& random) {
  constexpr std::size_t kLongest = 200;  // bytes
  return bytes.substr(below(bytes.size(), random), 1 + below(kLongest, random));
}

void leavePartOut(std::string& bytes, Random& random) {
  const std::size_t size = somePart(bytes, random).size();
  bytes.erase(below(bytes.size(), random), size);
}

void putPartIn(std::string& bytes, const std::string& part, Random& random) {
  bytes.insert(below(bytes.size() + 1, random), part);
}

}  // namespace

std::string mutantOf(const std::vector<std::string>& seeds, std::mt19937_64& random) {
  std::string bytes = seeds[below(seeds.size(), random)];
  const std::size_t changes = 1 + below(4, random);
  for (std::size_t i = 0; i < changes; ++i) {
    switch (below(8, random)) {
      case 0:
        leavePartOut(bytes, random);
        break;
      case 1:
        putPartIn(bytes, somePart(bytes, random), random);
        break;
      case 2:
        putPartIn(bytes, somePart(seeds[below(seeds.size(), random)], random), random);
        break;
      case 3:
        bytes.resize(bytes.size() - below(bytes.size() / 8, random));
        break;
      case 4:
        changeByte(bytes, random);
        break;
      case 5:
        changeWord(bytes, random);
        break;
      default:
        changeText(bytes, random);
    }
  }
  return bytes;
}

}  // namespace forge
