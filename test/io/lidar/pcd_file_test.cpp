#include "collision_forge/io/lidar/pcd_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace forge {
namespace {

/// Two points of a radar file, with some of its fields.
std::string radarFile(const std::string& format = "binary") {
  std::string text =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z dyn_prop id rcs\nSIZE 4 4 4 1 2 4\nTYPE F F F I U F\nCOUNT 1 1 1 1 1 1\n"
      "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
      format + "\n";
  const auto put = [&](auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text.append(bytes, sizeof value);
  };
  for (const float x : {12.5F, 30.0F}) {
    put(x);
    put(-1.5F);
    put(0.0F);
    put(std::int8_t{-3});
    put(std::uint16_t{40000});
    put(7.25F);
  }
  return text;
}

PointCloud read(const std::string& text) { return readPcd({text.begin(), text.end()}); }

TEST(PcdFile, PointsKeepTheirFieldsAndBytes) {
  const PointCloud cloud = read(radarFile());
  ASSERT_EQ(cloud.pointCount(), 2u);
  EXPECT_EQ(cloud.point_step, 19u);
  const CloudLayout layout(cloud);
  EXPECT_EQ(layout.position(cloud.pointAt(0)), Eigen::Vector3d(12.5, -1.5, 0.0));
  EXPECT_EQ(layout.position(cloud.pointAt(1)), Eigen::Vector3d(30.0, -1.5, 0.0));
  const auto valueOf = [&](std::size_t field) {
    return FieldAccess(cloud.fields[field], false).get(cloud.pointAt(1));
  };
  EXPECT_EQ(cloud.fields[5].name, "rcs");
  EXPECT_EQ(valueOf(3), -3.0);
  EXPECT_EQ(valueOf(4), 40000.0);
  EXPECT_EQ(valueOf(5), 7.25);
}

TEST(PcdFile, AFileWithoutPointsIsAnEmptyCloud) {
  std::string text = radarFile();
  text = text.substr(0, text.find("binary\n") + 7);
  text.replace(text.find("POINTS 2"), 8, "POINTS 0");
  EXPECT_EQ(read(text).pointCount(), 0u);
}

TEST(PcdFile, WithoutCountEachFieldHasOneElement) {
  std::string text = radarFile();
  const std::string line = "COUNT 1 1 1 1 1 1\n";
  text.erase(text.find(line), line.size());
  const PointCloud cloud = read(text);
  EXPECT_EQ(cloud.point_step, 19u);
  ASSERT_EQ(cloud.fields.size(), 6u);
  for (const CloudField& field : cloud.fields) EXPECT_EQ(field.count, 1u) << field.name;
  EXPECT_EQ(cloud.data, read(radarFile()).data);
}

TEST(PcdFile, AHeaderMayHave64KiB) {
  const std::size_t most = 65536;
  const std::string text = radarFile();
  const std::size_t header = text.find("binary\n") + 7;
  const auto longerBy = [&](std::size_t bytes) { return "#" + std::string(bytes - 2, '-') + "\n"; };
  EXPECT_EQ(read(longerBy(most - header) + text).pointCount(), 2u);
  EXPECT_THROW(read(longerBy(most - header + 1) + text), CloudError);
}

TEST(PcdFile, FilesThatCannotBeReadAreNamedByTheirHeader) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = radarFile();
    return text.replace(text.find(from), from.size(), to);
  };
  const std::pair<std::string, std::string> cases[] = {
      {"", "no line DATA"},
      {"VERSION 0.7\n", "no line DATA"},
      {std::string(70000, '\n') + radarFile(), "no line DATA in its first 65536 bytes"},
      {changed("WIDTH", "BREADTH"), "'BREADTH' is no line of a .pcd header"},
      {changed("WIDTH", std::string(1000, 'W')), "'" + std::string(20, 'W') + "' is no line"},
      {"DATA binary\n", "FIELDS is missing"},
      {radarFile("ascii"), "DATA ascii"},
      {changed("SIZE 4 4 4 1 2 4", "SIZE 4 4 4 1 2"), "SIZE has 5 values instead of 6"},
      {changed("TYPE F", "TYPE I F"), "TYPE has 7"},
      {changed("SIZE 4", "SIZE 3"), "TYPE F of SIZE 3"},
      {changed("COUNT 1 1", "COUNT 1 2000000000"), "COUNT 2000000000 exceeds"},
      {changed("COUNT 1", "COUNT -1"), "COUNT '-1'"},
      {changed("COUNT 1 1 1 1", "COUNT 1 1 1 0"), "COUNT of the field dyn_prop is 0"},
      {changed("POINTS 2", "POINTS 3"), "POINTS 3 needs 57 bytes, the .pcd file has 38"},
      {changed("POINTS 2", "POINTS many"), "POINTS 'many'"}};
  for (const auto& [text, words] : cases) {
    try {
      read(text);
      ADD_FAILURE() << words;
    } catch (const CloudError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace forge
