#include "collision_forge/base/config/config_file.h"

#include <gtest/gtest.h>

#include <functional>

namespace forge {

struct Wheel {
  double radius = 0.0;
  double pressure = 0.0;
};

static void readOptions(Section& section, Wheel& wheel, double pressure = 0.0) {
  wheel.radius = section.positive("radius");
  wheel.pressure = pressure;
}

namespace {

Section sectionOf(const std::string& text) { return openConfigText("car.yaml", text); }

/// Returns the error message of `read` on a text; "" if it succeeds.
std::string complaint(const std::string& text, const std::function<void(Section&)>& read) {
  try {
    Section section = sectionOf(text);
    read(section);
    section.finish();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Section, ReadsValues) {
  Section section = sectionOf(
      "{length: 4.5, doors: 5, name: Zoe, share: 1, angle: 3.1416, list: [1, -2], plus: [1, 2], "
      "rising: [0, 0.5, 0.5, 1]}");
  EXPECT_EQ(section.positive("length"), 4.5);
  EXPECT_EQ(section.count("doors", 0), 5);
  EXPECT_EQ(section.text("name"), "Zoe");
  EXPECT_EQ(section.share("share"), 1.0);
  EXPECT_EQ(section.angle("angle"), 3.1416);
  EXPECT_EQ(section.numbers("list", -2.0, 1.0), (std::vector<double>{1.0, -2.0}));
  EXPECT_EQ(section.positives("plus"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(section.risingShares("rising"), (std::vector<double>{0.0, 0.5, 0.5, 1.0}));
  section.finish();
}

TEST(Section, ErrorsNameFileKeyValueAndRange) {
  EXPECT_EQ(
      complaint("wheel: {radius: -1}", [](Section& s) { s.section("wheel").positive("radius"); }),
      "car.yaml: wheel.radius = -1 is not positive");
  EXPECT_EQ(complaint("a: 2", [](Section& s) { s.within("a", 0.0, 1.5); }),
            "car.yaml: a = 2 is not within 0 to 1.5");
  EXPECT_EQ(complaint("a: -2", [](Section& s) { s.nonNegative("a"); }),
            "car.yaml: a = -2 is not within 0 to inf");
  EXPECT_EQ(complaint("a: x", [](Section& s) { s.positive("a"); }),
            "car.yaml: a = x is not a number");
  EXPECT_EQ(complaint("a: .nan", [](Section& s) { s.positive("a"); }),
            "car.yaml: a = .nan is not finite");
  EXPECT_EQ(complaint("a: 1.5", [](Section& s) { s.count("a", 0); }),
            "car.yaml: a = 1.5 is not an integer");
  EXPECT_EQ(complaint("a: [0, 2]", [](Section& s) { s.risingShares("a"); }),
            "car.yaml: a = 2 is not within 0 to 1");
  EXPECT_EQ(complaint("a: [1]", [](Section& s) { s.text("a"); }),
            "car.yaml: a = [1] is not a string");
}

TEST(Section, NamesMissingUnknownAndDuplicateKeys) {
  EXPECT_EQ(complaint("{}", [](Section& s) { s.positive("a"); }), "car.yaml: a is missing");
  EXPECT_EQ(complaint("a: {b: 1}", [](Section& s) { s.section("a").finish(); }),
            "car.yaml: a.b = 1 is an unknown key");
  EXPECT_EQ(complaint("{a: 1, a: 2}", [](Section&) {}), "car.yaml: a = 2 is given twice");
  EXPECT_EQ(complaint("a: 1", [](Section& s) { s.section("a"); }),
            "car.yaml: a = 1 is not a mapping");
  EXPECT_NE(complaint("a: [", [](Section&) {}).find("car.yaml: "), std::string::npos);
}

TEST(Section, PathsAreRelativeToTheFile) {
  EXPECT_EQ(openConfigText("etc/car.yaml", "a: b/c").path("a"), "etc/b/c");
  EXPECT_EQ(openConfigText("etc/car.yaml", "a: /b/c").path("a"), "/b/c");
  EXPECT_EQ(openConfigText("etc/car.yaml", "a: \"\"").path("a"), "");
}

TEST(Section, ReadsStructsWithReadOptions) {
  Wheel wheel;
  Section section = sectionOf("{front: {radius: 0.3}, rear: {radius: 0.4, width: 1}}");
  section.read("front", wheel);
  EXPECT_EQ(wheel.radius, 0.3);
  try {
    section.read("rear", wheel, 2.5);
    FAIL() << "no complaint";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "car.yaml: rear.width = 1 is an unknown key");
  }
  EXPECT_EQ(wheel.pressure, 2.5);
}

}  // namespace
}  // namespace forge
