#include "collision_forge/ros/rviz/player_buttons.h"

#include <QGridLayout>
#include <QLabel>
#include <QProxyStyle>
#include <QPushButton>
#include <QSlider>
#include <QTimer>

#include <cmath>
#include <initializer_list>

#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

namespace {

constexpr int kLookPeriod = 500;     // ms between two checks for a player
constexpr double kSliderStep = 0.1;  // s
constexpr char kLongestClock[] = "000.0 s of 000.0 s";

/// A click moves the slider to the clicked position, not by a page.
class SliderStyle : public QProxyStyle {
 public:
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override {
    if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
    return QProxyStyle::styleHint(hint, option, widget, answer);
  }
};

/// Returns the reason of a failed command; empty on success.
template <typename Answer>
QString problemOf(const Answer& answer) {
  if (!answer) return "The player does not respond.";
  return answer->success ? QString() : QString::fromStdString(answer->message);
}

}  // namespace

PlayerButtons::PlayerButtons(QWidget* parent)
    : QWidget(parent),
      pausing_([this](const auto& answer) { showProblem(problemOf(answer)); }),
      going_([this](const auto& answer) { showProblem(problemOf(answer)); }),
      seeking_([this](const auto& answer) { showProblem(problemOf(answer)); }) {
  createLayout();
  connect(pause_, &QPushButton::clicked, this, [this] {
    setPaused(!is_paused_);
    if (is_paused_) Q_EMIT moved();
  });
  connect(step_, &QPushButton::clicked, this, [this] { trigger(names::kPlayerStep); });
  connect(back_, &QPushButton::clicked, this, [this] { trigger(names::kPlayerBackToNow); });
  connect(slider_, &QSlider::sliderReleased, this, &PlayerButtons::seek);
  connect(slider_, &QSlider::actionTriggered, this, [this] {
    if (!slider_->isSliderDown()) seek();  // moved by a key or the wheel
  });
  subscribers_ = {node_.subscribe(names::kPlayerPosition, 1, &PlayerButtons::showPosition, this),
                  node_.subscribe(names::kPlayerLength, 1, &PlayerButtons::showLength, this)};
  paused_subscriber_ = node_.subscribe(names::kPlayerPaused, 1, &PlayerButtons::showState, this);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &PlayerButtons::showPresence);
  timer->start(kLookPeriod);
  showPresence();
}

void PlayerButtons::createLayout() {
  pause_ = new QPushButton("Pause");
  pause_->setObjectName("pause");
  step_ = new QPushButton("Step");
  step_->setObjectName("step");
  step_->setToolTip("Plays up to the next frame of agents");
  back_ = new QPushButton("Back to now");
  back_->setObjectName("back_to_now");
  back_->setToolTip("To t0 of the newest attack");
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("position");
  slider_->setToolTip("To another time of the bag");
  auto* style = new SliderStyle;
  style->setParent(slider_);
  slider_->setStyle(style);
  clock_ = new QLabel;
  clock_->setObjectName("clock");
  clock_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  clock_->setFixedWidth(clock_->fontMetrics().horizontalAdvance(kLongestClock));
  said_ = new QLabel;
  said_->setObjectName("player_says");
  said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  said_->setFixedHeight(said_->fontMetrics().lineSpacing());
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(pause_, 0, 0);
  grid->addWidget(step_, 0, 1);
  grid->addWidget(back_, 0, 2);
  for (int column = 0; column < 3; ++column) grid->setColumnStretch(column, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->addWidget(clock_, 1, 2);
  grid->addWidget(said_, 2, 0, 1, 3);
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
  if (going_.start(service, {})) Q_EMIT moved();
}

void PlayerButtons::showProblem(const QString& problem) {
  if (!problem.isEmpty()) Q_EMIT failed(problem);
}

void PlayerButtons::seek() {
  collision_forge::Seek::Request request;
  request.instant = kSliderStep * slider_->sliderPosition();
  if (seeking_.start(names::kPlayerSeek, request)) Q_EMIT moved();
}

void PlayerButtons::showPosition(const std_msgs::Float64& position) {
  position_ = position.data;
  showClock();
}

void PlayerButtons::showLength(const std_msgs::Float64& length) {
  slider_->setMaximum(static_cast<int>(std::lround(length.data / kSliderStep)));
  showClock();
}

void PlayerButtons::showClock() {
  clock_->setText(QString("%1 s of %2 s")
                      .arg(position_, 0, 'f', 1)
                      .arg(kSliderStep * slider_->maximum(), 0, 'f', 1));
  if (slider_->isSliderDown()) return;
  slider_->setValue(static_cast<int>(std::lround(position_ / kSliderStep)));
}

void PlayerButtons::showState(const std_msgs::Bool& is_paused) {
  is_paused_ = is_paused.data;
  pause_->setText(is_paused_ ? "Play" : "Pause");
  said_->setText(is_paused_ ? "Paused." : "Plays.");
}

void PlayerButtons::showPresence() {
  const bool is_there = isThere();
  for (QWidget* widget : std::initializer_list<QWidget*>{pause_, step_, back_, slider_, clock_}) {
    widget->setEnabled(is_there);
  }
  if (!is_there) said_->setText("No player: replay.launch starts one.");
}

}  // namespace forge
