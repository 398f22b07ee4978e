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

/// Controls of the node `player`: pause, step, back to now, a slider for the position in the bag,
/// and a clock. Disabled without a player.
class PlayerButtons : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerButtons(QWidget* parent = nullptr);

  /// Pauses the player, if there is one and it plays.
  void pause();

 Q_SIGNALS:
  /// Emitted when the player is started, stepped or moved to another time.
  void moved();
  /// Emitted with the reason when the player rejects a command.
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
  void showPresence();
  bool isThere() const { return paused_subscriber_.getNumPublishers() > 0; }

  QPushButton* pause_ = nullptr;
  QPushButton* step_ = nullptr;
  QPushButton* back_ = nullptr;
  QSlider* slider_ = nullptr;  ///< in units of kSliderStep
  QLabel* clock_ = nullptr;
  QLabel* said_ = nullptr;
  bool is_paused_ = false;
  double position_ = 0.0;  ///< s from the start of the bag

  ros::NodeHandle node_;
  ros::Subscriber paused_subscriber_;
  std::vector<ros::Subscriber> subscribers_;
  ServiceCall<std_srvs::SetBool> pausing_;
  ServiceCall<std_srvs::Trigger> going_;
  ServiceCall<collision_forge::Seek> seeking_;
};

}  // namespace forge
