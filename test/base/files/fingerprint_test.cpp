#include "collision_forge/base/files/fingerprint.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(Fingerprint, IsFnv1a) {
  // Published test vectors of FNV-1a, 64 bits.
  EXPECT_EQ(fingerprint(""), "cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fingerprint("foobar"), "85944171f73967e8");
  EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(Fingerprint, ContinuesOneBefore) {
  EXPECT_EQ(fingerprint("bar", fingerprint("foo")), "85944171f73967e8");
  EXPECT_EQ(hashOf("bar", hashOf("foo")), hashOf("foobar"));
}

TEST(Mixed, IsTheFinalizerOfSplitmix64) {
  // The first number of splitmix64 for seed 0: the finalizer of its first increment.
  EXPECT_EQ(mixed(0x9e3779b97f4a7c15u), 0xe220a8397b1dcdafu);
}

}  // namespace
}  // namespace forge
