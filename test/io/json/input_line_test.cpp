#include "collision_forge/io/json/input_line.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace forge {
namespace {

InputLimits fourBytes() {
  InputLimits limits;
  limits.max_line = 4;
  return limits;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; readInputLine(stream, line, "file", fourBytes());) lines.push_back(line);
  return lines;
}

/// Returns the error message for the first line, and the second line.
std::pair<std::string, std::string> complaintAndNextOf(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  try {
    readInputLine(stream, line, "file: line 7", fourBytes());
  } catch (const InputError& error) {
    const std::string complaint = error.what();
    return {complaint, readInputLine(stream, line, "", fourBytes()) ? line : "none"};
  }
  return {};
}

TEST(ReadInputLine, ReadsAsGetlineDoes) {
  for (const std::string& text :
       {std::string(), std::string("\n"), std::string("a"), std::string("abcd\nefgh"),
        std::string("\n\nab\n"), std::string("a\0\r\nb\n", 6)}) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    EXPECT_EQ(linesOf(text), lines) << text;
  }
}

TEST(ReadInputLine, RejectsALongLineAndContinuesAfterIt) {
  const std::string refusal = "file: line 7: length = 5 bytes is more than max_line = 4";
  EXPECT_EQ(complaintAndNextOf("abcde\nfg\n"), std::make_pair(refusal, std::string("fg")));
  EXPECT_EQ(complaintAndNextOf("abcde\n"), std::make_pair(refusal, std::string("none")));
  EXPECT_EQ(complaintAndNextOf("abcde"), std::make_pair(refusal, std::string("none")));
}

TEST(ReadInputLine, ReportsTheLengthOfALineThatItDoesNotHold) {
  const std::string refusal = "file: line 7: length = 100000 bytes is more than max_line = 4";
  const std::string text(100000, 'a');
  EXPECT_EQ(complaintAndNextOf(text + "\nfg"), std::make_pair(refusal, std::string("fg")));
  EXPECT_EQ(complaintAndNextOf(text), std::make_pair(refusal, std::string("none")));
}

TEST(ReadInputLine, DoesNotHoldARejectedLine) {
  std::istringstream stream(std::string(100000, 'a'));
  std::string line;
  EXPECT_THROW(readInputLine(stream, line, "file", fourBytes()), InputError);
  EXPECT_LE(line.capacity(), 64u);
}

}  // namespace
}  // namespace forge
