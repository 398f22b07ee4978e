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
/// moves; else it requests for the newest scene. For type "any" without a text in words it first
/// calls list_collisions for the time to attack in the form, then requests the collision with the
/// highest confidence.
class GeneratePanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit GeneratePanel(QWidget* parent = nullptr);

  /// Called by RViz: restores the fields of the form and the planner from the .rviz file.
  void load(const rviz::Config& config) override;
  /// Called by RViz: stores these values there.
  void save(rviz::Config config) const override;

 private:
  void createWidgets();    ///< creates the widgets below; createLayout() gives them a parent
  void createLayout();     ///< arranges the widgets
  QWidget* createTexts();  ///< returns a scroll area with `status_`, `crash_` and `attack_text_`
  void subscribe();        ///< subscribes to the topics of the functions show...() below
  /// Shows the status of the newest call. `text`: rich text; `whole`: tooltip.
  void showStatus(const QString& text, const QString& whole = {});

  // Calls of services, started by the buttons.
  /// Requests the selected row, or else what the form says.
  void generate();
  /// Calls generate_collision with `request` and disables the button until the response.
  void ask(collision_forge::GenerateCollision::Request request);
  /// Lists the collisions of all types, attackers and manoeuvres at the usual times to attack
  /// (config/requests.yaml).
  void list();
  /// Pauses the player and calls list_collisions for all types with the other fields of `each`, one
  /// attack each; `ttas`: times to attack, s from t0; empty: the usual ones.
  void listPossibleCollisions(collision_forge::GenerateCollision::Request each,
                              const std::vector<double>& ttas);
  /// Selects the row with the highest confidence and requests it. The table must have rows.
  void requestMostConfident();
  /// Pauses the player and calls test_planner for the newest attack, which must not be null; the
  /// policy is adaptive for an adaptive attack, else fixed.
  void testPlanner();

  /// Copies the row that the user selected into the form, and keeps it in `row_`.
  void choose(const collision_forge::PossibleCollision& collision);
  /// Replaces the rows. `request`: the request behind them; `now`: its t0.
  void setTable(const std::vector<collision_forge::PossibleCollision>& collisions,
                collision_forge::GenerateCollision::Request request, const ros::Time& now);
  /// Returns the request that gives the attack of a row: `listed_` with the type, time and number
  /// of the row (only the number if the request is in words).
  collision_forge::GenerateCollision::Request requestOf(
      const collision_forge::PossibleCollision& row) const;

  // Each shows the response of a service as status, the first two also as table rows (the first one
  // only if it has several attacks); empty: no response.
  void showAnswer(const ServiceCall<collision_forge::GenerateCollision>::Answer& answer);
  void showPossible(const ServiceCall<collision_forge::ListCollisions>::Answer& answer);
  void showOutcome(const ServiceCall<collision_forge::TestPlanner>::Answer& answer);

  // Messages of topics, in the GUI thread. showAttack() enables the test of planners, unless the
  // attack is empty.
  void showAttack(const collision_forge::AttackConstPtr& attack);
  void showTested(const collision_forge::CollisionReportConstPtr& report) { tested_ = report; }
  void showCrash();  ///< timer callback: shows countdown or verdict at the present time
  /// Offers the methods in the form.
  void showMethods(const collision_forge::AttackMethods& methods);
  /// Offers the agents at t0 whose class can attack (canAttackClass()) in the form.
  void showScene(const collision_forge::EncodedSceneConstPtr& scene);

  PlayerButtons* player_ = nullptr;
  RequestForm* form_ = nullptr;
  QPushButton* generate_ = nullptr;
  QPushButton* list_ = nullptr;
  QComboBox* planner_ = nullptr;  ///< planner that `test_` tests
  QPushButton* test_ = nullptr;
  PossibleTable* table_ = nullptr;
  QLabel* status_ = nullptr;       ///< status of the newest call
  QLabel* crash_ = nullptr;        ///< countdown or verdict
  QLabel* attack_text_ = nullptr;  ///< the newest attack

  /// The request behind the rows of the table; its stamp is their t0. requestOf() sets type, time
  /// and number of a row.
  collision_forge::GenerateCollision::Request listed_;
  /// Row that generate() requests; empty: none is selected, or the form or the player was changed.
  std::optional<collision_forge::PossibleCollision> row_;
  /// The running list_collisions serves generate(): its response leads to requestMostConfident().
  bool requests_most_confident_ = false;
  collision_forge::GenerateCollision::Request generate_request_;  ///< newest generate_collision
  collision_forge::GenerateCollision::Request list_request_;      ///< newest list_collisions

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
  collision_forge::AttackConstPtr attack_;           ///< the newest; null: none received
  collision_forge::CollisionReportConstPtr tested_;  ///< the newest; null: none received
  ServiceCall<collision_forge::GenerateCollision> generating_;
  ServiceCall<collision_forge::ListCollisions> listing_;
  ServiceCall<collision_forge::TestPlanner> testing_;
};

}  // namespace forge
