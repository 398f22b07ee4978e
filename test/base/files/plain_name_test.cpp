#include "collision_forge/base/files/plain_name.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

TEST(NameFault, AcceptsPlainNames) {
  for (const std::string& name : {std::string("scene-0001"), std::string("a b"), std::string("..."),
                                  std::string("-"), std::string("\u00e9"), std::string(200, 'x')}) {
    EXPECT_EQ(nameFault(name), "");
    EXPECT_EQ(pathIn("/out", name), "/out/" + name);
  }
}

TEST(NameFault, RejectsNamesThatLeaveTheFolder) {
  const std::string text = "\" is not a valid file name: it ";
  EXPECT_EQ(nameFault(""), "\"" + text + "is empty");
  EXPECT_EQ(nameFault("."), "\"." + text + "is the name of a folder");
  EXPECT_EQ(nameFault(".."), "\".." + text + "is the name of a folder");
  EXPECT_EQ(nameFault("../evil"), "\"../evil" + text + "contains '/'");
  EXPECT_EQ(nameFault("/abs"), "\"/abs" + text + "contains '/'");
  EXPECT_EQ(nameFault(std::string("a\0b", 3)), "\"a\\x00b" + text + "contains a control character");
  EXPECT_EQ(nameFault("a\nb"), "\"a\\x0ab" + text + "contains a control character");
  EXPECT_EQ(nameFault(std::string(201, 'x')),
            "\"" + std::string(40, 'x') + "..." + text + "is longer than 200 bytes");
}

TEST(PathIn, StaysInTheFolder) {
  EXPECT_THROW(pathIn("/out", "../evil.bag"), std::runtime_error);
  EXPECT_THROW(pathIn("/out", "/abs/evil.bag"), std::runtime_error);
  EXPECT_THROW(pathIn("/out", ".."), std::runtime_error);
}

}  // namespace
}  // namespace forge
