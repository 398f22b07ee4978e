#pragma once

#include <collision_forge/Seek.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QWidget>

#include <vector>

#include "collision_forge/ros/rviz/service_call.h"

class QLabel;
class QPushButton;
class QSlider;

namespace forge {

/// Pause, step and back to now for the node `player`, and where it is in its bag: a slider that can
/// be moved, and a clock. Without a player they are disabled.
class PlayerButtons : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerButtons(QWidget* parent = nullptr);

  /// Where there is a player that plays.
  void pause();

 Q_SIGNALS:
  /// The player was told to play on, to step, to go back or to go to another instant.
  void moved();
  /// Why it did not do that.
  void failed(const QString& problem);

 private:
  void createLayout();
  void setPaused(bool is_paused);
  void trigger(const char* service);
  void showProblem(const QString& problem);
  void seek();
  void showPosition(const std_msgs::Float64& position);
  void showClock();
  void showLength(const std_msgs::Float64& length);
  void showState(const std_msgs::Bool& is_paused);
  void showWhetherThere();
  bool isThere() const { return paused_subscriber_.getNumPublishers() > 0; }

  QPushButton* pause_ = nullptr;
  QPushButton* step_ = nullptr;
  QPushButton* back_ = nullptr;
  QSlider* slider_ = nullptr;  ///< in kSliderStep
  QLabel* clock_ = nullptr;
  QLabel* said_ = nullptr;
  bool is_paused_ = false;
  double position_ = 0.0;  ///< s

  ros::NodeHandle node_;
  ros::Subscriber paused_subscriber_;
  std::vector<ros::Subscriber> subscribers_;
  ServiceCall<std_srvs::SetBool> pausing_;
  ServiceCall<std_srvs::Trigger> going_;
  ServiceCall<collision_forge::Seek> seeking_;
};

}  // namespace forge
