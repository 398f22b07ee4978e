#include "collision_forge/ros/rviz/possible_table.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QScrollBar>

namespace forge {
namespace {

collision_forge::PossibleCollision possible(const std::string& type, bool added) {
  collision_forge::PossibleCollision collision;
  collision.collision_type = type;
  collision.tta = 3.0;
  collision.attacker_id = "0123456789";
  collision.attacker_class = "truck";
  collision.added = added;
  collision.manoeuvre = "cut_in";
  collision.confidence = 0.875;
  return collision;
}

TEST(PossibleTable, ShowsOneCollisionPerRow) {
  PossibleTable table;
  table.setCollisions({possible("lane_change", false), possible("rear_end", true)});
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.item(0, 0)->text(), "lane_change");
  EXPECT_EQ(table.item(0, 1)->text(), "3.0");
  EXPECT_EQ(table.item(0, 2)->text(), "truck 012345");
  EXPECT_EQ(table.item(0, 4)->text(), "cut_in");
  EXPECT_EQ(table.item(0, 3)->text(), "88 %");
  EXPECT_EQ(table.item(1, 2)->text(), "added truck");
  table.setCollisions({});
  EXPECT_EQ(table.rowCount(), 0);
}

TEST(PossibleTable, MarksARowWithoutEmittingChosen) {
  PossibleTable table;
  table.setCollisions({possible("lane_change", false), possible("rear_end", true)});
  bool is_chosen = false;
  QObject::connect(&table, &PossibleTable::chosen, [&is_chosen] { is_chosen = true; });
  table.mark(1);
  EXPECT_EQ(table.selectionModel()->selectedRows().first().row(), 1);
  EXPECT_FALSE(is_chosen);
}

TEST(PossibleTable, EmitsChosenForASelectedRowButNotWhenFilled) {
  PossibleTable table;
  std::vector<std::string> chosen;
  QObject::connect(&table, &PossibleTable::chosen, [&chosen](const auto& collision) {
    chosen.push_back(collision.collision_type);
  });
  table.setCollisions({possible("lane_change", false), possible("rear_end", true)});
  table.selectRow(1);
  table.setCollisions({possible("ltap", false)});
  EXPECT_EQ(chosen, std::vector<std::string>{"rear_end"});
  table.selectRow(0);
  EXPECT_EQ(chosen.back(), "ltap");
}

}  // namespace
}  // namespace forge
