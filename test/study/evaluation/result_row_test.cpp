#include "collision_forge/study/evaluation/result_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

ResultRow sampleRow() {
  ResultRow row;
  row.name = "data_hcis_v4.5_x";
  row.scene = "scene-0001";
  row.type = CollisionType::kLtap;
  row.tta = 2.5;
  row.method = "search";
  row.seed = 3;
  row.status = "OK";
  row.meets = {true, false};
  row.contact_after = -0.1;
  row.relative_heading = M_PI / 4.0;
  row.confidence = 0.75;
  row.off_road_share = 0.123456;
  row.note = "max_speed 26.000 > 25.000";
  return row;
}

TEST(ResultRow, LineHasTheColumnsOfTheHeader) {
  EXPECT_EQ(csvHeader(Protocol::kPublished),
            "name,scene,type,tta,method,seed,status,collision,similar,contact_after,"
            "relative_heading,confidence,off_road_share,note");
  EXPECT_EQ(toCsv(sampleRow()),
            "data_hcis_v4.5_x,scene-0001,ltap,2.5,search,3,OK,1,0,-0.100,45.00,0.7500,"
            "0.1235,max_speed 26.000 > 25.000");
}

TEST(ResultRow, RequestsHaveMoreColumns) {
  ResultRow row = sampleRow();
  row.request.emplace();
  const std::string header = csvHeader(Protocol::kPublished, RowsOf::kRequests);
  EXPECT_NE(header.find(",off_road_share,road_allows,believable,attacker,class,note"),
            std::string::npos);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(toCsv(row)), commas(header));
  auto copy = rowFromCsv(toCsv(row), Protocol::kPublished);
  ASSERT_TRUE(copy && copy->request);
  EXPECT_FALSE(copy->request->road_allows);
  EXPECT_FALSE(copy->request->believable);
  EXPECT_EQ(copy->request->attacker, "");
  EXPECT_FALSE(copy->request->attacker_class);
  row.request->road_allows = true;
  row.request->believable = false;
  row.request->attacker = "car-1";
  row.request->attacker_class = AgentClass::kCar;
  EXPECT_EQ(commas(toCsv(row)), commas(header));
  copy = rowFromCsv(toCsv(row), Protocol::kPublished);
  ASSERT_TRUE(copy && copy->request);
  EXPECT_EQ(copy->request->road_allows, true);
  EXPECT_EQ(copy->request->believable, false);
  EXPECT_EQ(copy->request->attacker, "car-1");
  EXPECT_EQ(copy->request->attacker_class, AgentClass::kCar);
  EXPECT_EQ(copy->note, row.note);
  EXPECT_EQ(toCsv(*copy), toCsv(row));
  EXPECT_FALSE(rowFromCsv(toCsv(sampleRow()), Protocol::kPublished)->request);
}

TEST(ResultRow, NamesWithCommasOrLineEndsAreRejected) {
  ResultRow row = sampleRow();
  row.scene = "scene, the first";
  EXPECT_THROW(toCsv(row), std::runtime_error);
}

TEST(ResultRow, RoundTrips) {
  const auto row = rowFromCsv(toCsv(sampleRow()), Protocol::kPublished);
  ASSERT_TRUE(row);
  EXPECT_EQ(row->name, "data_hcis_v4.5_x");
  EXPECT_EQ(row->scene, "scene-0001");
  EXPECT_EQ(row->type, CollisionType::kLtap);
  EXPECT_EQ(row->tta, 2.5);
  EXPECT_EQ(row->method, "search");
  EXPECT_EQ(row->seed, 3u);
  EXPECT_EQ(row->status, "OK");
  EXPECT_EQ(row->meets, (std::vector<bool>{true, false}));
  EXPECT_EQ(row->contact_after, -0.1);
  EXPECT_NEAR(*row->relative_heading, M_PI / 4.0, 1e-9);
  EXPECT_EQ(row->confidence, 0.75);
  EXPECT_EQ(row->off_road_share, 0.1235);
  EXPECT_EQ(row->note, "max_speed 26.000 > 25.000");
}

TEST(ResultRow, MalformedLinesAreRejected) {
  const std::string line = toCsv(sampleRow());
  EXPECT_FALSE(rowFromCsv("", Protocol::kPublished));
  EXPECT_FALSE(rowFromCsv(csvHeader(Protocol::kPublished), Protocol::kPublished));
  EXPECT_FALSE(rowFromCsv(line, Protocol::kStrict));
  ResultRow turned = sampleRow();
  turned.relative_heading = 2.0 * M_PI;
  EXPECT_FALSE(rowFromCsv(toCsv(turned), Protocol::kPublished)) << "no heading";
  ResultRow sure = sampleRow();
  sure.confidence = 1e12;
  EXPECT_FALSE(rowFromCsv(toCsv(sure), Protocol::kPublished)) << "no confidence";
  EXPECT_FALSE(rowFromCsv(line.substr(0, line.find(",0,-0.1")), Protocol::kPublished));
  std::string other = line;
  EXPECT_FALSE(rowFromCsv(other.replace(other.find("ltap"), 4, "xyzw"), Protocol::kPublished));
  other = line;
  EXPECT_FALSE(rowFromCsv(other.replace(other.find("2.5"), 3, "two"), Protocol::kPublished));
  other = line;
  EXPECT_FALSE(rowFromCsv(other.replace(other.find("OK,1"), 4, "OK,2"), Protocol::kPublished));
  other = line;
  EXPECT_FALSE(rowFromCsv(other.replace(other.find("45.00"), 5, "north"), Protocol::kPublished));
}

TEST(ReadResultRows, ReturnsTheRowsOfOneItem) {
  const std::string line = toCsv(sampleRow());
  const auto rows =
      readResultRows("here", line + "\n" + line, Protocol::kPublished, sampleRow().name);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(toCsv(rows[1]), line);
}

TEST(ReadResultRows, NamesALineOfAnotherItem) {
  const std::string line = toCsv(sampleRow());
  for (const auto& [lines, name] :
       {std::pair{line, std::string("another")}, std::pair{line + "\nx", sampleRow().name}}) {
    try {
      readResultRows("results.csv: line 2", lines, Protocol::kPublished, name);
      FAIL() << lines;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find("results.csv: line 2: \""), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace forge
