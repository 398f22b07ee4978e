#include "collision_forge/planner_test/sweeps/sweep_parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const SweepOptions kOptions = [] {
  SweepOptions options{{{"impact_speed", 1.0}, {"overlap", 0.1}}};
  for (const RangeControl& control : kRangeControls) options.tolerances[control.name] = 0.5;
  return options;
}();

std::string refusalOf(const std::string& text, bool takes_intervals = false) {
  try {
    parseSweepAxis(text, takes_intervals);
    return "";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::StartsWith(text + ": "));
    return error.what();
  }
}

TEST(SweepAxis, HasTheValuesOfAStepOrAList) {
  EXPECT_THAT(parseSweepAxis("overlap=0:0.35:0.1", false).values, ElementsAre(0.0, 0.1, 0.2, 0.3));
  EXPECT_THAT(parseSweepAxis("tta=5,3.5", false).values, ElementsAre(5.0, 3.5));
  const SweepAxis classes = parseSweepAxis("class=truck,CAR", false);
  EXPECT_EQ(classes.parameter->text(classes.values[0]), "truck");
  EXPECT_EQ(classes.parameter->text(classes.values[1]), "car");
}

TEST(SweepAxis, AnErrorNamesTheValueAndWhatIsAllowed) {
  EXPECT_THAT(refusalOf("speed=1:2:1"), HasSubstr("\"speed\" is none of the parameters tta, "));
  EXPECT_THAT(refusalOf("overlp=1"), HasSubstr("did you mean overlap?"));
  EXPECT_THAT(refusalOf("tta"), HasSubstr("NAME=MIN:MAX:STEP"));
  EXPECT_THAT(refusalOf("tta=-1:3:1"), HasSubstr("\"-1\" is not a number from 0.1 to 60"));
  EXPECT_THAT(refusalOf("overlap=0.5,nan"), HasSubstr("\"nan\" is not a number from 0 to 1"));
  EXPECT_THAT(refusalOf("tta=6:3:1"), HasSubstr("MIN must be below MAX"));
  EXPECT_THAT(refusalOf("tta=3:6:0"), HasSubstr("\"0\" is not a number"));
  EXPECT_THAT(refusalOf("tta=3:6"), HasSubstr("a step is missing"));
  EXPECT_THAT(refusalOf("tta=3,3"), HasSubstr("\"3\" is given twice"));
  EXPECT_THAT(refusalOf("class=animal"), HasSubstr("is none of car, truck, "));
  EXPECT_THAT(refusalOf("tta=3:6:1e-9"), HasSubstr("is not a number from 3e-05 to 3"));
  EXPECT_EQ(refusalOf("tta=3:6", true), "");
}

TEST(SweepParameter, EveryOneSetsAFieldOfItsOwn) {
  std::set<std::string> lines = {requestLine({"scene", 0.0, {}})};
  for (const SweepParameter& parameter : sweepParameters()) {
    SceneRequest asked{"scene", 0.0, {}};
    parameter.set(asked, parameter.words.empty() ? 0.6 * parameter.max : 1.0, kOptions);
    EXPECT_TRUE(lines.insert(requestLine(asked)).second) << parameter.name;
  }
}

TEST(SweepParameter, ARangeIsTheValueWithItsToleranceWithinTheBounds) {
  SceneRequest asked;
  sweepParameter("impact_speed").set(asked, 6.0, kOptions);
  EXPECT_EQ(asked.request.impact_speed->min, 5.0);
  EXPECT_EQ(asked.request.impact_speed->max, 7.0);
  sweepParameter("overlap").set(asked, 0.95, kOptions);
  EXPECT_EQ(asked.request.overlap->max, 1.0);
}

TEST(Grid, HasEveryCombinationWithTheLastAxisFastest) {
  const std::vector<SweepAxis> axes = {parseSweepAxis("tta=3,4", false),
                                       parseSweepAxis("overlap=0.2,0.5,0.8", false)};
  const auto cells = gridOf(axes);
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_THAT(cells[0], ElementsAre(3.0, 0.2));
  EXPECT_THAT(cells[1], ElementsAre(3.0, 0.5));
  EXPECT_THAT(cells[5], ElementsAre(4.0, 0.8));
  const SweepAxis fine = parseSweepAxis("tta=1:60:0.1", false);
  EXPECT_THROW(gridOf({fine, fine, fine}), std::invalid_argument);
}

TEST(LatinHypercube, HasOneSampleInEveryStratum) {
  const std::vector<SweepAxis> axes = {parseSweepAxis("tta=2:6", true),
                                       parseSweepAxis("class=car,truck", true)};
  const auto cells = latinHypercubeOf(axes, 40, 7);
  std::set<int> strata;
  for (const auto& cell : cells) strata.insert(static_cast<int>((cell[0] - 2.0) / 0.1));
  EXPECT_EQ(strata.size(), 40u);
  EXPECT_EQ(
      std::count_if(cells.begin(), cells.end(), [](const auto& cell) { return cell[1] == 0; }), 20);
  EXPECT_EQ(latinHypercubeOf(axes, 40, 7), cells);
  EXPECT_NE(latinHypercubeOf(axes, 40, 8), cells);
}

}  // namespace
}  // namespace forge
