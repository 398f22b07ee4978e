#include "collision_forge/io/export/export_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "io/export/crash_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

TEST(CrashWriter, WritesOnlyToItsFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() + "/out");
  for (const std::string& format : exportFormats()) {
    const auto writer = makeCrashWriter(format, planFor(folder.path() + "/out"));
    for (const std::string& name : {std::string("../evil"), folder.path() + "/evil"}) {
      CrashRecord record = slowCarRecord();
      record.name = name;
      try {
        writer->write(record);
        FAIL() << format;
      } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("is not a valid file name")) << format;
      }
    }
  }
  EXPECT_TRUE(fs::is_empty(folder.path() + "/out"));
}

}  // namespace
}  // namespace forge
