#include "collision_forge/io/batch/printable.h"

#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

namespace forge {
namespace {

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("\033[2J\033]0;title\a"), "\\x1b[2J\\x1b]0;title\\x07");
  EXPECT_EQ(printable("a\rb\x7f" + std::string(1, '\0')), "a\\x0db\\x7f\\x00");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\xc2\\x9b31m")
      << "CSI as one character";
}

TEST(Printable, EscapesInvalidUtf8) {
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(printable("cut \xE6\x9D"), "cut \\xe6\\x9d");
  EXPECT_EQ(printable("\xC0\xAF\xFF"), "\\xc0\\xaf\\xff");
}

TEST(PrintableOutput, EscapesCout) {
  std::ostringstream shown;
  std::streambuf* const before = std::cout.rdbuf(shown.rdbuf());
  {
    const PrintableOutput output;
    std::cout << "id \033[31m" << 7 << "\nZ\xC3"
              << "\xBCrich";
  }
  EXPECT_EQ(std::cout.rdbuf(before), shown.rdbuf());
  EXPECT_EQ(shown.str(), "id \\x1b[31m7\nZürich");
}

}  // namespace
}  // namespace forge
