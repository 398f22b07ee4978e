#pragma once

#include <collision_forge/AttackMethods.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/ListCollisions.h>
#include <collision_forge/TestPlanner.h>
#include <ros/ros.h>
#include <rviz/panel.h>

#include <optional>

#include "collision_forge/ros/rviz/service_call.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace forge {

class PlayerButtons;
class PossibleTable;
class RequestForm;

/// Panel with player controls, a request form, a table of feasible collisions and planner tests. It
/// calls generate_collision and shows the newest attack of any client. For a selected row it
/// repeats the request of that row at the t0 of the table, until a field is changed or the player
/// moves; else it requests for the newest scene. For type "any" it first calls list_collisions,
/// then requests the collision with the highest confidence.
class GeneratePanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit GeneratePanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void createWidgets();
  void createLayout();
  QWidget* createTexts();
  void subscribe();
  /// Shows the status of the newest call. `whole`: tooltip.
  void say(const QString& text, const QString& whole = {});
  void generate();
  void ask(collision_forge::GenerateCollision::Request request);
  void list();
  void listPossibleCollisions(collision_forge::GenerateCollision::Request each,
                              const std::vector<double>& ttas);
  void requestMostConfident();
  void testPlanner();
  void choose(const collision_forge::PossibleCollision& collision);
  void setTable(const std::vector<collision_forge::PossibleCollision>& collisions,
                collision_forge::GenerateCollision::Request request, const ros::Time& now);
  collision_forge::GenerateCollision::Request requestOf(
      const collision_forge::PossibleCollision& row) const;
  void showAnswer(const ServiceCall<collision_forge::GenerateCollision>::Answer& answer);
  void showPossible(const ServiceCall<collision_forge::ListCollisions>::Answer& answer);
  void showOutcome(const ServiceCall<collision_forge::TestPlanner>::Answer& answer);
  void showAttack(const collision_forge::AttackConstPtr& attack);
  void showTested(const collision_forge::CollisionReportConstPtr& report) { tested_ = report; }
  void showCrash();
  void showMethods(const collision_forge::AttackMethods& methods);
  void showScene(const collision_forge::EncodedSceneConstPtr& scene);

  PlayerButtons* player_ = nullptr;
  RequestForm* form_ = nullptr;
  QPushButton* generate_ = nullptr;
  QPushButton* list_ = nullptr;
  QComboBox* planner_ = nullptr;
  QPushButton* test_ = nullptr;
  PossibleTable* table_ = nullptr;
  QLabel* status_ = nullptr;       ///< status of the newest call
  QLabel* crash_ = nullptr;        ///< countdown or verdict
  QLabel* attack_text_ = nullptr;  ///< the newest attack

  /// The request behind the rows of the table, without type, time and number of a row.
  collision_forge::GenerateCollision::Request listed_;
  std::optional<collision_forge::PossibleCollision> row_;  ///< selected row
  bool requests_most_confident_ = false;  ///< the running list_collisions should select one
  collision_forge::GenerateCollision::Request asked_;  ///< newest generate_collision
  collision_forge::GenerateCollision::Request each_;   ///< newest list_collisions

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  collision_forge::AttackConstPtr attack_;           ///< the newest
  collision_forge::CollisionReportConstPtr tested_;  ///< the newest
  ServiceCall<collision_forge::GenerateCollision> generating_;
  ServiceCall<collision_forge::ListCollisions> listing_;
  ServiceCall<collision_forge::TestPlanner> testing_;
};

}  // namespace forge
