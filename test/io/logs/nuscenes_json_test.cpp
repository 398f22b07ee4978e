#include "collision_forge/io/logs/nuscenes_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string errorOfTable(const std::string& content) {
  const TemporaryFolder folder;
  const std::string path = folder.write("table.json", content);
  return errorOf([&] { readTable(path, {"token"}, [](const JsonRow&) {}); });
}

TEST(NuScenesJson, skipsUnknownFieldsOfAnyShape) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "table.json",
      R"([{"x": {"token": "inner", "y": [1, {"n": 2}]}, "token": "a", "z": [[1, 2], ["n"]],
           "n": -12, "w": null, "v": true}, {"n": 9007199254740993, "token": "b\u00e9\""}])");
  std::vector<std::string> tokens;
  std::vector<std::int64_t> numbers;
  readTable(path, {"token", "n"}, [&](const JsonRow& row) {
    tokens.emplace_back(row.token());
    numbers.push_back(row.integer(1));
  });
  EXPECT_THAT(tokens, ElementsAre("a", "b\u00e9\""));
  EXPECT_THAT(numbers, ElementsAre(-12, 9007199254740993));
}

TEST(NuScenesJson, readsNumbersToTheLastBit) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "table.json", R"([{"token": "a", "n": [0.1, -1.7976931348623157e308, 5E-324]}])");
  readTable(path, {"token", "n"}, [&](const JsonRow& row) {
    EXPECT_THAT(row.numbers<3>(1), ElementsAre(0.1, -1.7976931348623157e308, 5e-324));
  });
}

TEST(NuScenesJson, namesTheByteWhereAFileIsCutOff) {
  const std::string whole = R"([{"token": "a"}, {"token": "b"}])";
  EXPECT_EQ(errorOfTable(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THAT(errorOfTable(whole.substr(0, size)), HasSubstr("table.json: invalid JSON at byte "))
        << size;
  }
  EXPECT_THAT(errorOfTable(whole.substr(0, 16)), HasSubstr("at byte 16"));
}

TEST(NuScenesJson, survivesNestingThatWouldExhaustTheStack) {
  const std::string deep(1000000, '[');
  EXPECT_THAT(errorOfTable("[{\"x\": " + deep), HasSubstr("is nested too deeply"));
}

TEST(NuScenesJson, namesAFileThatIsNotThere) {
  EXPECT_THAT(errorOf([] { readTable("/nowhere/a.json", {"token"}, [](const JsonRow&) {}); }),
              HasSubstr("/nowhere/a.json: cannot be opened: No such file"));
}

}  // namespace
}  // namespace forge
