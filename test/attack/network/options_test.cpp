#include "collision_forge/attack/network/options.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

TEST(EgoHead, RejectsAnUnknownName) {
  try {
    egoHeadFromString("anchors");
    FAIL() << "no complaint";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("anchors"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace forge
