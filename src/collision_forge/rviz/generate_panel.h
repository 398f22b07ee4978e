#pragma once

#include <collision_forge/AttackMethods.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/GenerateCollision.h>
#include <ros/ros.h>
#include <rviz/panel.h>

#include <QFutureWatcher>
#include <QThreadPool>

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace forge {

/// Asks generate_collision for an attack on the scene as it stands now and shows the answer.
class GeneratePanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit GeneratePanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  /// Empty when nobody answered.
  using Answer = std::optional<collision_forge::GenerateCollision::Response>;

  void createFields();
  void createLayout();
  collision_forge::GenerateCollision::Request request() const;
  void generate();
  void showAnswer();
  void showAttack(const collision_forge::AttackConstPtr& attack);
  void showWhatBecame();
  void showMethods(const collision_forge::AttackMethods& methods);
  void showScene(const collision_forge::EncodedSceneConstPtr& scene);

  QComboBox* type_ = nullptr;
  QDoubleSpinBox* tta_ = nullptr;
  QComboBox* attacker_ = nullptr;
  QComboBox* choice_ = nullptr;
  QCheckBox* believable_ = nullptr;
  QCheckBox* adaptive_ = nullptr;
  QComboBox* mode_ = nullptr;
  QComboBox* method_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QPushButton* generate_ = nullptr;
  QLabel* result_ = nullptr;

  ros::NodeHandle node_;
  ros::Subscriber methods_subscriber_;
  ros::Subscriber scene_subscriber_;
  ros::Subscriber attack_subscriber_;
  collision_forge::AttackConstPtr attack_;           ///< the newest
  std::optional<collision_forge::Attack> answered_;  ///< by the newest answer
  QFutureWatcher<Answer> answer_;                    ///< of the call in flight
  QThreadPool
      caller_;  ///< last: it waits for the call in flight, then this library may be unloaded
};

}  // namespace forge
