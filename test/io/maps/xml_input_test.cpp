#include "collision_forge/io/maps/xml_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/maps/map_error.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(XmlInput, ANumberMayHaveAPlusSignAnExponentAndSpaceAroundIt) {
  EXPECT_EQ(finiteNumber(" +1.5e2\n"), 150.0);
  EXPECT_EQ(finiteNumber("-.5"), -0.5);
}

TEST(XmlInput, TextsThatAreNotOneFiniteNumberHaveNoNumber) {
  for (const char* const text :
       {"", " ", "+", "1 2", "1,5", "0x10", "nan", "inf", "1e999", "five", "+-1"}) {
    EXPECT_EQ(finiteNumber(text), std::nullopt) << text;
  }
}

TEST(XmlInput, AWrongAttributeIsNamedWithItsElementAndValue) {
  pugi::xml_document document;
  document.load_string(R"(<map><node id="7" x="far"/><point x="1"/></map>)");
  const pugi::xml_node map = document.document_element();
  EXPECT_THAT(
      [&] { numberIn(map.child("node"), "x", "F"); },
      ThrowsMessage<MapError>("F: <node id=\"7\">: attribute x is \"far\", not a finite number"));
  EXPECT_THAT([&] { numberIn(map.child("point"), "y", "F"); },
              ThrowsMessage<MapError>("F: <point> at byte 28: attribute y is missing"));
  EXPECT_EQ(numberIn(map.child("point"), "x", "F"), 1.0);
}

TEST(XmlInput, MalformedXmlIsRefusedWithItsPosition) {
  const TemporaryFolder folder;
  folder.write("map.xml", "<map><lane></map>");
  pugi::xml_document document;
  EXPECT_THAT([&] { loadXml(folder.path() + "/map.xml", document); },
              ThrowsMessage<MapError>(HasSubstr("map.xml: invalid XML at byte 1")));
  EXPECT_THAT([&] { loadXml("/nowhere/map.xml", document); },
              ThrowsMessage<MapError>(HasSubstr("/nowhere/map.xml: cannot be read")));
}

}  // namespace
}  // namespace forge
