#include "protocols/config_digest.h"

#include <gtest/gtest.h>

#include "formats/nuscenes_fixture.h"

namespace forge {
namespace {

TEST(ConfigDigest, NamesEveryYamlFileButTheDrawings) {
  const TemporaryFolder folder;
  folder.write("b.yaml", "");
  folder.write("a.yaml", "a");
  folder.write("drawing.yaml", "a");
  folder.write("notes.txt", "a");
  // FNV-1a of nothing and of "a", from the hash's own page of test vectors.
  EXPECT_EQ(digestConfig(folder.path()),
            (std::vector<std::string>{"config/a.yaml = af63dc4c8601ec8c",
                                      "config/b.yaml = cbf29ce484222325"}));
}

TEST(ConfigDigest, ChangesWithTheFile) {
  const TemporaryFolder folder;
  folder.write("a.yaml", "x: 1\n");
  const auto before = digestConfig(folder.path());
  folder.write("a.yaml", "x: 2\n");
  EXPECT_NE(digestConfig(folder.path()), before);
}

}  // namespace
}  // namespace forge
