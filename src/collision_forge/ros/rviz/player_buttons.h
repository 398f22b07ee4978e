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

/// Controls of the node `player`: pause or play, step (to the next frame of agents), back to now
/// (t0 of the newest attack), a slider for the position in the bag, and a clock. Disabled while no
/// player is there (isThere(), checked every 0.5 s).
class PlayerButtons : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerButtons(QWidget* parent = nullptr);

  /// Asks the player to pause, if there is one and it plays; does not wait.
  void pause();

 Q_SIGNALS:
  /// Emitted when the user starts or steps the player or moves it to another time, before the
  /// player responds; not when the user pauses it.
  void moved();
  /// Emitted with the reason when the player rejects a command or does not respond.
  void failed(const QString& problem);

 private:
  void createLayout();
  void setPaused(bool is_paused);            // calls player/pause; true: pause, false: play
  void trigger(const char* service);         // calls player/step or player/back_to_now by its name
  void showProblem(const QString& problem);  // emits failed() unless empty
  void seek();                               // calls player/seek with the slider's position
  void showPosition(const std_msgs::Float64& position);  // of player/position
  void showClock();                                      // updates clock and slider
  void showLength(const std_msgs::Float64& length);      // of player/length
  void showState(const std_msgs::Bool& is_paused);       // of player/paused
  void showPresence();  // timer callback: enables the widgets if there is a player
  /// Returns true if a node publishes player/paused.
  bool isThere() const { return paused_subscriber_.getNumPublishers() > 0; }

  QPushButton* pause_ = nullptr;
  QPushButton* step_ = nullptr;
  QPushButton* back_ = nullptr;
  QSlider* slider_ = nullptr;  ///< position in the bag, in steps of 0.1 s
  QLabel* clock_ = nullptr;    ///< "12.3 s of 19.5 s"
  QLabel* said_ = nullptr;     ///< "Paused.", "Plays.", or that there is no player
  bool is_paused_ = false;     ///< newest player/paused; false before the first
  double position_ = 0.0;      ///< newest player/position, s from the bag's first frame of agents

  ros::NodeHandle node_;
  ros::Subscriber paused_subscriber_;
  std::vector<ros::Subscriber> subscribers_;
  ServiceCall<std_srvs::SetBool> pausing_;      ///< player/pause
  ServiceCall<std_srvs::Trigger> going_;        ///< player/step and player/back_to_now
  ServiceCall<collision_forge::Seek> seeking_;  ///< player/seek
};

}  // namespace forge
