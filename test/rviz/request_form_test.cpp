#include "collision_forge/ros/rviz/request_form.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QLocale>

#include <algorithm>

namespace forge {
namespace {

collision_forge::PossibleCollision cutIn() {
  collision_forge::PossibleCollision collision;
  collision.collision_type = "lane_change";
  collision.tta = 3.5;
  collision.attacker_id = "a1";
  collision.manoeuvre = "cut_in";
  return collision;
}

TEST(RequestForm, RequestsTheChosenFields) {
  RequestForm form;
  form.choose(cutIn());
  const auto request = form.request();
  EXPECT_EQ(request.collision_type, "lane_change");
  EXPECT_EQ(request.tta, 3.5);
  EXPECT_EQ(request.attacker_id, "a1");
  EXPECT_EQ(request.manoeuvre, "cut_in");
  EXPECT_EQ(request.choice, "existing");
}

TEST(RequestForm, ATextReplacesTypeTimeAndAttacker) {
  RequestForm form;
  form.choose(cutIn());
  form.findChild<QLineEdit*>("text")->setText(" CCRb in 3 s ");
  const auto request = form.request();
  EXPECT_EQ(request.text, "CCRb in 3 s");
  EXPECT_EQ(request.collision_type, "");
  EXPECT_EQ(request.tta, 0.0);
  EXPECT_EQ(request.attacker_id, "");
  form.choose(cutIn());
  EXPECT_EQ(form.request().text, "");
}

TEST(RequestForm, RequestsAnyTypeUnlessOneIsChosen) {
  EXPECT_EQ(RequestForm().request().collision_type, "");
}

TEST(RequestForm, WritesNumbersWithAPointInEveryLocale) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));
  RequestForm form;
  form.choose(cutIn());
  EXPECT_EQ(form.findChild<QDoubleSpinBox*>()->text().toStdString(), "3.50 s");
  QLocale::setDefault(before);
}

TEST(RequestForm, OffersShortIdsAndRequestsTheFullId) {
  RequestForm form;
  collision_forge::PossibleCollision collision = cutIn();
  collision.attacker_id = "626d04ddfb6ad0fbce7bb269ab4d03e5";
  form.setAttackers({QString::fromStdString(collision.attacker_id)});
  form.choose(collision);
  const QList<QComboBox*> boxes = form.findChildren<QComboBox*>();
  const auto attacker = std::find_if(boxes.begin(), boxes.end(),
                                     [](const QComboBox* box) { return box->isEditable(); });
  EXPECT_EQ((*attacker)->currentText().toStdString(), "626d04");
  EXPECT_EQ(form.request().attacker_id, collision.attacker_id);
}

TEST(RequestForm, ResetsAManoeuvreThatTheNewTypeDoesNotHave) {
  RequestForm form;
  form.choose(cutIn());
  collision_forge::PossibleCollision rear_end = cutIn();
  rear_end.collision_type = "rear_end";
  rear_end.manoeuvre = "";
  form.choose(rear_end);
  EXPECT_EQ(form.request().collision_type, "rear_end");
  EXPECT_EQ(form.request().manoeuvre, "");
}

TEST(RequestForm, KeepsTheAttackerWhileOtherAgentsComeAndGo) {
  RequestForm form;
  form.choose(cutIn());
  form.setAttackers({"b2", "a1"});
  EXPECT_EQ(form.request().attacker_id, "a1");
  form.setAttackers({"b2"});
  EXPECT_EQ(form.request().attacker_id, "a1") << "it may come again";
}

TEST(RequestForm, IsSavedAndLoaded) {
  RequestForm saved;
  saved.setMethods({"search", "random"});
  saved.choose(cutIn());
  rviz::Config config;
  saved.save(config);
  RequestForm loaded;
  loaded.load(config);
  const auto expected = saved.request();
  const auto request = loaded.request();
  EXPECT_EQ(request.collision_type, expected.collision_type);
  EXPECT_EQ(request.tta, expected.tta);
  EXPECT_EQ(request.manoeuvre, expected.manoeuvre);
  EXPECT_EQ(request.attacker_id, expected.attacker_id);
  EXPECT_EQ(request.choice, expected.choice);
  EXPECT_EQ(request.alternatives, expected.alternatives);
}

}  // namespace
}  // namespace forge
