#include "collision_forge/rviz/player_buttons.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include "collision_forge/ros/topic_names.h"

namespace forge {

namespace {

constexpr int kLookPeriod = 500;  // ms, for players that come and go

/// Why the player did not do it; else what was said before.
template <typename Answer>
void showFailure(const Answer& answer, QLabel& label) {
  if (!answer) label.setText("The player does not answer.");
  if (answer && !answer->success) label.setText(QString::fromStdString(answer->message));
}

}  // namespace

PlayerButtons::PlayerButtons(QWidget* parent)
    : QWidget(parent),
      pausing_([this](const auto& answer) { showFailure(answer, *said_); }),
      going_([this](const auto& answer) { showFailure(answer, *said_); }) {
  createLayout();
  connect(pause_, &QPushButton::clicked, this, [this] {
    setPaused(!is_paused_);
    if (is_paused_) Q_EMIT moved();
  });
  connect(step_, &QPushButton::clicked, this, [this] { trigger(names::kPlayerStep); });
  connect(back_, &QPushButton::clicked, this, [this] { trigger(names::kPlayerBackToNow); });
  paused_subscriber_ = node_.subscribe(names::kPlayerPaused, 1, &PlayerButtons::showState, this);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &PlayerButtons::showWhetherThere);
  timer->start(kLookPeriod);
  showWhetherThere();
}

void PlayerButtons::createLayout() {
  pause_ = new QPushButton("Pause");
  pause_->setObjectName("pause");
  step_ = new QPushButton("Step");
  step_->setObjectName("step");
  step_->setToolTip("To the next frame of agents");
  back_ = new QPushButton("Back to now");
  back_->setObjectName("back_to_now");
  back_->setToolTip("To the instant at which the newest attack was asked for");
  said_ = new QLabel;
  said_->setObjectName("player_says");
  said_->setWordWrap(true);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(pause_, 0, 0);
  grid->addWidget(step_, 0, 1);
  grid->addWidget(back_, 0, 2);
  grid->addWidget(said_, 1, 0, 1, 3);
}

void PlayerButtons::pause() {
  if (isThere() && !is_paused_) setPaused(true);
}

void PlayerButtons::setPaused(bool is_paused) {
  std_srvs::SetBool::Request request;
  request.data = is_paused;
  pausing_.start(names::kPlayerPause, request);
}

void PlayerButtons::trigger(const char* service) {
  going_.start(service, {});
  Q_EMIT moved();
}

void PlayerButtons::showState(const std_msgs::Bool& is_paused) {
  is_paused_ = is_paused.data;
  pause_->setText(is_paused_ ? "Play" : "Pause");
  said_->setText(is_paused_ ? "Paused." : "Plays.");
}

void PlayerButtons::showWhetherThere() {
  const bool is_there = isThere();
  for (QPushButton* button : {pause_, step_, back_}) button->setEnabled(is_there);
  if (!is_there) said_->setText("No player: replay.launch starts one.");
}

}  // namespace forge
