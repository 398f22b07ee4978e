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

/// RViz panel that controls the player, lists the possible collisions, calls generate_collision,
/// shows the state of the newest attack (also of one requested elsewhere) and tests planners in it.
/// A selected table row is requested at the t0 of the table, until a field is changed or the player
/// is moved; other requests use the newest scene. For type "any", the panel lists the possible
/// collisions and requests the one with the highest confidence.
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
  /// Shows the status of the newest call; `whole` is its tooltip.
  void say(const QString& text, const QString& whole = {});
  void generate();
  void ask(collision_forge::GenerateCollision::Request request);
  void list();
  void askWhatIsPossible(collision_forge::GenerateCollision::Request each,
                         const std::vector<double>& ttas);
  void askForSurest();
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

  /// Request of the table. Each row replaces its type, TTA and alternative number.
  collision_forge::GenerateCollision::Request listed_;
  std::optional<collision_forge::PossibleCollision> row_;  ///< selected row
  bool is_surest_wanted_ = false;  ///< request the most confident row when the list arrives
  collision_forge::GenerateCollision::Request asked_;  ///< newest request to generate_collision
  collision_forge::GenerateCollision::Request each_;   ///< newest request to list_collisions

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  collision_forge::AttackConstPtr attack_;           ///< the newest
  collision_forge::CollisionReportConstPtr tested_;  ///< the newest
  ServiceCall<collision_forge::GenerateCollision> generating_;
  ServiceCall<collision_forge::ListCollisions> listing_;
  ServiceCall<collision_forge::TestPlanner> testing_;
};

}  // namespace forge
