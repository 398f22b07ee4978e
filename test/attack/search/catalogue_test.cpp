#include "collision_forge/attack/search/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "collision_forge/base/config/config_error.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kConfig = COLLISION_FORGE_SOURCE_DIR "/config";

CatalogueEntry entryOf(const std::string& name) {
  return namedEntries(readCatalogue(kConfig, "all"), {name}).at(0);
}

TEST(Catalogue, EveryScenarioHasCellsOrAReason) {
  EXPECT_THAT(catalogueNames(kConfig), ElementsAre("euro_ncap_2026", "nhtsa", "un_r157"));
  for (const CatalogueEntry& entry : readCatalogue(kConfig, "all")) {
    EXPECT_EQ(entry.cells.empty(), !entry.missing.empty()) << entry.name;
    EXPECT_FALSE(entry.text.empty()) << entry.name;
  }
}

/// The table of docs/catalogue.md: "| `NAME` | ... | scenarios | of these, can be requested |".
TEST(Catalogue, TheDocumentationCountsTheScenarios) {
  std::ifstream page(COLLISION_FORGE_SOURCE_DIR "/docs/catalogue.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  for (const std::string& name : catalogueNames(kConfig)) {
    const auto entries = readCatalogue(kConfig, name);
    const auto requested = std::count_if(entries.begin(), entries.end(),
                                         [](const auto& entry) { return entry.missing.empty(); });
    const std::size_t row = text.find("| `" + name + "` |");
    ASSERT_NE(row, std::string::npos) << name;
    const std::string line = text.substr(row, text.find('\n', row) - row);
    EXPECT_THAT(line, testing::EndsWith("| " + std::to_string(entries.size()) + " | " +
                                        std::to_string(requested) + " |"));
  }
}

TEST(Catalogue, AGridGivesACellPerCombination) {
  const CatalogueEntry entry = entryOf("CCRb");
  ASSERT_EQ(entry.cells.size(), 10u);
  const CatalogueCell& cell = entry.cells.front();
  EXPECT_EQ(cell.name, "euro_ncap_2026/CCRb deceleration=2 impact_location=0");
  EXPECT_EQ(cell.request.type, CollisionType::kRearEnd);
  EXPECT_EQ(cell.request.manoeuvre, Manoeuvre::kLeadBrakes);
  EXPECT_EQ(cell.request.attacker_class, AgentClass::kCar);
  EXPECT_DOUBLE_EQ(cell.request.deceleration->min, 1.0);
  EXPECT_DOUBLE_EQ(cell.request.deceleration->max, 3.0);
  EXPECT_DOUBLE_EQ(cell.request.impact_location->min, -0.125);
}

TEST(Catalogue, AGridOfWordsGivesACellPerWord) {
  const CatalogueEntry entry = entryOf("nhtsa/30_straight_crossing_paths");
  ASSERT_EQ(entry.cells.size(), 2u);
  EXPECT_EQ(entry.cells[0].request.from_side, Side::kLeft);
  EXPECT_EQ(entry.cells[1].request.from_side, Side::kRight);
}

TEST(Catalogue, ANameMayKeepCellsOfTheGrid) {
  EXPECT_EQ(entryOf("ccrb deceleration=4").cells.size(), 5u);
  EXPECT_EQ(entryOf("euro_ncap_2026/CCRb deceleration=4 impact_location=0.5").cells.size(), 1u);
  EXPECT_THROW(entryOf("CCRb deceleration=3"), std::invalid_argument);
  EXPECT_THROW(namedCells(readCatalogue(kConfig, "all"), "ELK_RE"), std::invalid_argument);
}

TEST(Catalogue, UnknownNamesAreErrorsWithTheKnownOnes) {
  try {
    readCatalogue(kConfig, "euro");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("known catalogues: all, euro_ncap_2026, nhtsa, un_r157"));
  }
  try {
    entryOf("CCRx");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("no scenario \"CCRx\""));
    EXPECT_THAT(error.what(), HasSubstr("CCRb"));
  }
}

/// Returns the error of reading an overlay with this text for the scenario "X" of nhtsa.yaml.
std::string errorWith(const std::string& scenario) {
  const std::string folder = testing::TempDir() + "/catalogue_overlay";
  std::filesystem::create_directories(folder + "/catalogue");
  std::ofstream(folder + "/catalogue/nhtsa.yaml")
      << "nhtsa: {scenarios: {X: " << scenario << "}}\n";
  try {
    readCatalogue(ConfigFolder(kConfig, folder), "nhtsa");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Catalogue, AnOverlayAddsScenariosAndFaultsAreNamed) {
  EXPECT_EQ(errorWith("{text: t, request: {type: rear_end}}"), "none");
  EXPECT_THAT(errorWith("{text: t, request: {type: rear_ends}}"), HasSubstr("rear_ends"));
  EXPECT_THAT(errorWith("{text: t, request: {typ: rear_end}}"), HasSubstr("typ"));
  EXPECT_THAT(errorWith("{text: t, request: {type: rear_end, manoeuvre: cut_in}}"),
              HasSubstr("manoeuvre = cut_in"));
  EXPECT_THAT(errorWith("{text: t, request: {type: rear_end}, grid: {gap: [1.0]}}"),
              HasSubstr("has no tolerance"));
}

}  // namespace
}  // namespace forge
