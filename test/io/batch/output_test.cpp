#include "collision_forge/io/batch/output.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

TEST(Output, AFolderThatIsNamedTwiceIsLockedOnce) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const OutputLocks locks = lockFolders({out, "", folder.path() + "/./out"});
  EXPECT_EQ(locks.size(), 1u);
  EXPECT_THROW(lockFolders({folder.path(), out}), std::runtime_error);
  EXPECT_EQ(lockFolders({folder.path()}).size(), 1u) << "given back after the failure";
}

}  // namespace
}  // namespace forge
