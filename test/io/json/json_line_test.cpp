#include "collision_forge/io/json/json_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <typename Read>
std::string complaintOf(const std::string& text, const Read& read) {
  try {
    const JsonLine line("list: line 3", text);
    JsonObject object = line.root();
    read(object);
    object.finish();
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

const auto kNothing = [](JsonObject&) {};

TEST(JsonLine, ReportsPresentKeys) {
  const JsonLine line("", R"({"a":null,"l":[{"y":2}],"n":null})");
  JsonObject object = line.root();
  EXPECT_TRUE(object.has("a"));
  EXPECT_FALSE(object.has("b"));
  EXPECT_FALSE(object.textOrNull("a"));
  EXPECT_FALSE(object.has("a")) << "it has been read";
  EXPECT_FALSE(object.objectsOrNull("n", 1));
  auto list = object.objectsOrNull("l", 1);
  ASSERT_TRUE(list);
  EXPECT_EQ(list->at(0).number("y"), 2.0);
  EXPECT_THAT(complaintOf(R"({"l":1})", [](JsonObject& other) { other.objectsOrNull("l", 1); }),
              HasSubstr("l = 1 is not an array"));
}

TEST(JsonLine, ListsAreCountedBeforeTheirElementsAreRead) {
  EXPECT_EQ(complaintOf(R"({"l":[{},{}]})", [](JsonObject& object) { object.objects("l", 2); }),
            "");
  const std::string three = R"({"l":[1,{},{}]})";
  const auto problem = HasSubstr("field l = [...] has 3 elements, more than 2");
  EXPECT_THAT(complaintOf(three, [](JsonObject& object) { object.objects("l", 2); }), problem);
  EXPECT_THAT(complaintOf(three, [](JsonObject& object) { object.objectsOrNull("l", 2); }),
              problem);
}

TEST(JsonLine, ReadsEveryType) {
  const JsonLine line("", R"({"t":"a\"b","n":-1.5e3,"c":18446744073709551615,"f":true,
                              "o":{"x":1},"v":[1,-2.5],"w":["a",""],"l":[{"y":2},{"y":3}],"z":null})");
  JsonObject object = line.root();
  EXPECT_EQ(object.text("t"), "a\"b");
  EXPECT_EQ(object.number("n"), -1500.0);
  EXPECT_EQ(object.count("c"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(object.flag("f"));
  EXPECT_EQ(object.numbers("v"), (std::vector<double>{1.0, -2.5}));
  EXPECT_EQ(object.texts("w"), (std::vector<std::string>{"a", ""}));
  JsonObject inner = object.object("o");
  EXPECT_EQ(inner.number("x"), 1.0);
  inner.finish();
  std::vector<JsonObject> list = object.objects("l", 2);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].number("y"), 3.0);
  EXPECT_FALSE(object.textOrNull("z"));
  EXPECT_FALSE(object.numberOrNull("z"));
  EXPECT_FALSE(object.objectOrNull("z"));
  EXPECT_EQ(object.numberOrNull("n"), -1500.0);
  EXPECT_EQ(object.textOrNull("t"), "a\"b");
  EXPECT_TRUE(object.objectOrNull("o"));
  object.finish();
}

TEST(JsonLine, WrongTypesNamePositionFieldAndValue) {
  const std::string text = R"({"a":7})";
  const auto at = AllOf(HasSubstr("list: line 3: field a = 7"), HasSubstr("is n"));
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.text("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.textOrNull("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.flag("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.object("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.objectOrNull("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.objects("a", 9); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.numbers("a"); }), at);
  EXPECT_THAT(complaintOf(text, [](JsonObject& object) { object.texts("a"); }), at);
  const std::string mixed = R"({"a":[1,"x"]})";
  EXPECT_THAT(complaintOf(mixed, [](JsonObject& object) { object.numbers("a"); }),
              HasSubstr("field a = [...] holds \"x\", which is not a number"));
  EXPECT_THAT(complaintOf(mixed, [](JsonObject& object) { object.texts("a"); }),
              HasSubstr("field a = [...] holds 1, which is not a string"));
  const auto text_at = HasSubstr("field a = \"7\" is n");
  const std::string quoted = R"({"a":"7"})";
  EXPECT_THAT(complaintOf(quoted, [](JsonObject& object) { object.number("a"); }), text_at);
  EXPECT_THAT(complaintOf(quoted, [](JsonObject& object) { object.numberOrNull("a"); }), text_at);
  EXPECT_THAT(complaintOf(quoted, [](JsonObject& object) { object.count("a"); }), text_at);
}

TEST(JsonLine, NamesMissingUnknownAndDuplicateFields) {
  EXPECT_THAT(complaintOf("{}", [](JsonObject& object) { object.number("a"); }),
              HasSubstr("list: line 3: field a is missing"));
  EXPECT_THAT(complaintOf(R"({"stray":"x"})", kNothing),
              HasSubstr("field stray = \"x\" is an unknown field"));
  EXPECT_THAT(complaintOf(R"({"a":1,"a":1})", kNothing), HasSubstr("field a = 1 is a duplicate"));
  EXPECT_THAT(complaintOf(R"({"a\u0000b":1,"a\u0000b":2})", kNothing),
              HasSubstr("field a\\u0000b = 1 is a duplicate"));
  EXPECT_THAT(complaintOf(R"({"a\u0000b":1})", kNothing),
              HasSubstr("field a\\u0000b = 1 is an unknown field"));
  EXPECT_THAT(complaintOf(R"({"o":{"x":1,"x":2}})", [](JsonObject& object) { object.object("o"); }),
              HasSubstr("field o.x"));
  EXPECT_THAT(complaintOf(R"({"l":[{},{"y":"?"}]})",
                          [](JsonObject& object) { object.objects("l", 2)[1].number("y"); }),
              HasSubstr("field l[1].y = \"?\""));
}

TEST(JsonLine, InvalidJsonNamesTheByte) {
  EXPECT_THAT(complaintOf(R"({"a":1)", kNothing),
              HasSubstr("list: line 3: invalid JSON at byte 6"));
  for (const char* text : {"{", "{} {}", R"({"a":NaN})", R"({"a":1e999})", "{\"a\":\"\xff\"}"}) {
    EXPECT_THAT(complaintOf(text, kNothing), HasSubstr("invalid JSON at byte")) << text;
  }
  EXPECT_THAT(complaintOf("[1]", kNothing), HasSubstr("list: line 3: [...] is not an object"));
}

TEST(JsonLine, RejectsNumbersBeyondTheRangeOfDouble) {
  for (const std::string number : {"1e400", "NaN", "Infinity", "-Infinity"}) {
    EXPECT_THAT(complaintOf("{\"a\":" + number + "}", kNothing), HasSubstr("list: line 3: invalid"))
        << number;
  }
  EXPECT_EQ(complaintOf("{\"a\":0." + std::string(348, '0') + "1}",
                        [](JsonObject& object) { EXPECT_EQ(object.number("a"), 0.0); }),
            "");
}

TEST(JsonLine, SurvivesDeepNesting) {
  const std::string deep = R"({"a":)" + std::string(200'000, '[') + std::string(200'000, ']') + "}";
  EXPECT_THAT(complaintOf(deep, [](JsonObject& object) { object.number("a"); }),
              HasSubstr("field a = [...] is not a number"));
}

TEST(JsonLineWriter, WritesWithoutSpaces) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("t", "a\"\n");
  writer.number("n", 0.1);
  writer.count("c", 7);
  writer.flag("f", false);
  writer.null("z");
  writer.numbers("v", {1.0, -2.5});
  writer.texts("w", {"a", "\""});
  writer.beginArray("l");
  writer.beginObject();
  writer.endObject();
  writer.endArray();
  writer.endObject();
  EXPECT_EQ(
      writer.line(),
      R"({"t":"a\"\n","n":0.1,"c":7,"f":false,"z":null,"v":[1,-2.5],"w":["a","\""],"l":[{}]})");
}

std::string written(double value) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.number("n", value);
  writer.endObject();
  const std::string line = writer.line();
  return line.substr(5, line.size() - 6);
}

TEST(JsonLineWriter, NumbersAreTheShortestThatReadBack) {
  EXPECT_EQ(written(5.0), "5");
  EXPECT_EQ(written(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(written(9007199254740993.0), "9007199254740992");
  EXPECT_EQ(written(5e-324), "5e-324");
  EXPECT_EQ(written(1531883530.949817), "1531883530.949817");
}

TEST(JsonLineWriter, RejectsNumbersThatAreNotFinite) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    JsonLineWriter single;
    single.beginObject();
    EXPECT_THROW(single.number("n", value), std::invalid_argument);
    JsonLineWriter several;
    several.beginObject();
    EXPECT_THROW(several.numbers("n", {1.0, value}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace forge
