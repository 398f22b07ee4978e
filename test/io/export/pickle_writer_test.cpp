#include "collision_forge/io/export/pickle_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "io/export/inlined.h"

namespace forge {
namespace {

TEST(PickleWriter, AnEmptyDictIsWritten) { EXPECT_EQ(PickleWriter().content().json, "{}"); }

TEST(PickleWriter, ItemsOfArraysStandBesideTheJsonInOrder) {
  PickleWriter writer;
  writer.array("a", {1.0, -2.0});
  writer.array("m", {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 2);
  const PickleContent content = writer.content();
  EXPECT_EQ(content.json, R"({"a":{"ndarray":[2],"dtype":"f8","at":0},)"
                          R"("m":{"ndarray":[3,2],"dtype":"f8","at":2}})");
  double items[8];
  ASSERT_EQ(content.items.size(), sizeof(items));
  std::memcpy(items, content.items.data(), sizeof(items));
  EXPECT_EQ(std::vector<double>(items, items + 8),
            (std::vector<double>{1.0, -2.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
}

TEST(PickleWriter, ValuesNestAndListsHoldDictsAndMatrices) {
  EXPECT_EQ(inlined([](PickleWriter& writer) {
              writer.beginArray("list");
              writer.beginObject();
              writer.flags("f", {true, false});
              writer.null("n");
              writer.endObject();
              writer.array(nullptr, {1.5, 2.5}, 2);
              writer.endArray();
              writer.texts("t", {"a", ""});
            }),
            R"({"list":[{"f":[true,false],"n":null},[[1.5,2.5]]],"t":["a",""]})");
}

TEST(PickleWriter, AWholeNumberStaysAFloat) {
  PickleWriter writer;
  writer.number("n", 3.0);
  EXPECT_EQ(writer.content().json, R"({"n":{"ndarray":[],"dtype":"f8","at":0}})");
}

TEST(PickleWriter, RefusesNumbersThatAreNotFinite) {
  PickleWriter writer;
  EXPECT_THROW(writer.array("position", {0.0, HUGE_VAL}, 2), std::invalid_argument);
  try {
    writer.number("heading", -HUGE_VAL);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "field heading = -inf is not finite");
  }
}

}  // namespace
}  // namespace forge
