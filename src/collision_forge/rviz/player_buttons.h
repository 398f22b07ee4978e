#pragma once

#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <QWidget>

#include "collision_forge/rviz/service_call.h"

class QLabel;
class QPushButton;

namespace forge {

/// Pause, step and back to now for the node `player`; without one they are disabled.
class PlayerButtons : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerButtons(QWidget* parent = nullptr);

  /// Where there is a player that plays.
  void pause();

 Q_SIGNALS:
  /// It was told to play on, to step or to go back.
  void moved();

 private:
  void createLayout();
  void setPaused(bool is_paused);
  void trigger(const char* service);
  void showState(const std_msgs::Bool& is_paused);
  void showWhetherThere();
  bool isThere() const { return paused_subscriber_.getNumPublishers() > 0; }

  QPushButton* pause_ = nullptr;
  QPushButton* step_ = nullptr;
  QPushButton* back_ = nullptr;
  QLabel* said_ = nullptr;
  bool is_paused_ = false;

  ros::NodeHandle node_;
  ros::Subscriber paused_subscriber_;
  ServiceCall<std_srvs::SetBool> pausing_;
  ServiceCall<std_srvs::Trigger> going_;
};

}  // namespace forge
