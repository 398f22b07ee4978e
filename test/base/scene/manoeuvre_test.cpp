#include "collision_forge/base/scene/manoeuvre.h"

#include <gtest/gtest.h>

#include <set>

namespace forge {
namespace {

TEST(Manoeuvre, NamesAreReadBack) {
  std::set<std::string> names;
  for (const Manoeuvre manoeuvre : kManoeuvres) {
    EXPECT_EQ(manoeuvreFromString(toString(manoeuvre)), manoeuvre);
    names.insert(toString(manoeuvre));
  }
  EXPECT_EQ(names.size(), std::size(kManoeuvres));
  EXPECT_FALSE(manoeuvreFromString("u_turn"));
}

}  // namespace
}  // namespace forge
