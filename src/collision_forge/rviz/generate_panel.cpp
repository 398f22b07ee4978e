#include "collision_forge/rviz/generate_panel.h"

#include <collision_forge/Agent.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/ros/marker_parts.h"
#include "collision_forge/ros/possible_collisions.h"
#include "collision_forge/ros/topic_names.h"
#include "collision_forge/rviz/attack_words.h"
#include "collision_forge/rviz/player_buttons.h"
#include "collision_forge/rviz/possible_table.h"
#include "collision_forge/rviz/request_form.h"

namespace forge {

namespace {

using collision_forge::GenerateCollision;
using collision_forge::ListCollisions;

constexpr int kCountdownPeriod = 100;  // ms
constexpr int kCrashLines = 3;
constexpr int kAttackLines = 12;
constexpr int kTableLines = 11;

QLabel* label(const char* name, int lines) {
  auto* text = new QLabel;
  text->setObjectName(name);
  text->setWordWrap(true);
  text->setMinimumHeight(lines * text->fontMetrics().lineSpacing());
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  return text;
}

QPushButton* button(const char* name, const char* text) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  return button;
}

/// Why there is no answer; empty for one with code OK.
template <typename Answer>
QString problemOf(const Answer& answer, const char* service) {
  if (!answer) return QString("<b>No answer</b> from ") + ros::names::resolve(service).c_str();
  if (answer->code == GenerateCollision::Response::OK) return {};
  return failureText(answer->code, answer->message);
}

/// The answer and its alternatives, as if they had been asked for one by one.
std::vector<collision_forge::PossibleCollision> attacksIn(
    const GenerateCollision::Response& response, double tta) {
  collision_forge::CollisionAnswer answer;
  answer.collision_type = response.attack.pattern.collision_type;
  answer.tta = tta;
  answer.attack = response.attack;
  answer.alternatives = response.alternatives;
  answer.code = response.code;
  std::vector<collision_forge::PossibleCollision> attacks;
  listPossible({answer}, attacks);
  return attacks;
}

}  // namespace

GeneratePanel::GeneratePanel(QWidget* parent)
    : rviz::Panel(parent),
      generating_([this](const auto& answer) { showAnswer(answer); }),
      listing_([this](const auto& answer) { showPossible(answer); }) {
  createWidgets();
  createLayout();
  connect(form_, &RequestForm::changed, this, &rviz::Panel::configChanged);
  connect(generate_, &QPushButton::clicked, this, &GeneratePanel::generate);
  connect(list_, &QPushButton::clicked, this, &GeneratePanel::list);
  connect(table_, &PossibleTable::chosen, this, &GeneratePanel::choose);
  const auto forget_row = [this] { is_row_chosen_ = false; };
  connect(form_, &RequestForm::changed, this, forget_row);
  connect(player_, &PlayerButtons::moved, this, forget_row);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &GeneratePanel::showCrash);
  timer->start(kCountdownPeriod);
  subscribe();
}

void GeneratePanel::createWidgets() {
  player_ = new PlayerButtons;
  form_ = new RequestForm;
  generate_ = button("generate", "Generate");
  list_ = button("list", "What is possible?");
  list_->setToolTip("Pauses the player and lists the collisions that can be asked for there");
  table_ = new PossibleTable;
  table_->setObjectName("possible");
  table_->setToolTip("Choose a row to ask for it");
  table_->setMinimumHeight(kTableLines * table_->fontMetrics().lineSpacing());
  status_ = label("status", 1);
  status_->setText("No collision generated yet.");
  crash_ = label("crash", kCrashLines);
  QFont large = crash_->font();
  large.setPointSizeF(1.3 * large.pointSizeF());
  large.setBold(true);
  crash_->setFont(large);
  attack_text_ = label("attack", kAttackLines);
}

void GeneratePanel::createLayout() {
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(generate_);
  buttons->addWidget(list_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(player_);
  column->addWidget(form_);
  column->addLayout(buttons);
  column->addWidget(status_);
  column->addWidget(table_, 1);
  column->addWidget(crash_);
  column->addWidget(attack_text_);
}

/// RViz handles ROS callbacks in the thread of the GUI.
void GeneratePanel::subscribe() {
  subscribers_ = {node_.subscribe(names::kAttackMethods, 1, &GeneratePanel::showMethods, this),
                  node_.subscribe(names::kEncodedScene, 1, &GeneratePanel::showScene, this),
                  node_.subscribe(names::kAttack, 1, &GeneratePanel::showAttack, this),
                  node_.subscribe(names::kTestedReport, 1, &GeneratePanel::showTested, this)};
}

void GeneratePanel::generate() {
  generate_->setEnabled(false);
  status_->setText("Generating ...");
  GenerateCollision::Request request = form_->request();
  if (is_row_chosen_) request.stamp = listed_;
  asked_tta_ = request.tta;
  generating_.start(names::kGenerateCollision, request);
}

void GeneratePanel::choose(const collision_forge::PossibleCollision& collision) {
  form_->choose(collision);
  is_row_chosen_ = true;
}

void GeneratePanel::setTable(const std::vector<collision_forge::PossibleCollision>& collisions,
                             const ros::Time& now) {
  table_->setCollisions(collisions);
  listed_ = now;
  is_row_chosen_ = false;
}

void GeneratePanel::showAnswer(const ServiceCall<GenerateCollision>::Answer& answer) {
  generate_->setEnabled(true);
  const QString problem = problemOf(answer, names::kGenerateCollision);
  status_->setText(problem.isEmpty() ? "An attack was found." : problem);
  if (!problem.isEmpty() || answer->alternatives.empty()) return;
  const auto attacks = attacksIn(*answer, asked_tta_);
  status_->setText(QString("%1 attacks, the first is driven.").arg(attacks.size()));
  setTable(attacks, answer->attack.header.stamp);
}

void GeneratePanel::list() {
  player_->pause();
  list_->setEnabled(false);
  status_->setText("Looking for what is possible ...");
  ListCollisions::Request request;
  request.request = form_->anyRequest();
  request.method = form_->method();
  listing_.start(names::kListCollisions, request);
}

void GeneratePanel::showPossible(const ServiceCall<ListCollisions>::Answer& answer) {
  list_->setEnabled(true);
  const QString problem = problemOf(answer, names::kListCollisions);
  status_->setText(problem);
  if (!problem.isEmpty()) return;
  setTable(answer->collisions, answer->now);
  status_->setText(answer->collisions.empty() ? "Nothing is possible at this instant."
                                              : "Possible now; choose one, then Generate.");
}

void GeneratePanel::showAttack(const collision_forge::AttackConstPtr& attack) {
  attack_ = attack;
  attack_text_->setText(attackText(*attack));
  showCrash();
}

void GeneratePanel::showCrash() {
  if (!attack_ || ros::Time::now().isZero()) return;
  const QString text = crashText(*attack_, tested_.get(), ros::Time::now());
  if (text != crash_->text()) crash_->setText(text);
}

void GeneratePanel::showScene(const collision_forge::EncodedSceneConstPtr& scene) {
  const collision_forge::SceneSnapshot& snapshot = scene->snapshot;
  QStringList ids;
  for (const auto& agent : snapshot.agents) {
    const bool is_here =
        !agent.states.empty() && agent.states.back().stamp == snapshot.header.stamp;
    if (is_here && canAttackClass(agent.agent_class)) {
      ids.push_back(QString::fromStdString(agent.id));
    }
  }
  form_->setAttackers(ids);
}

void GeneratePanel::showMethods(const collision_forge::AttackMethods& methods) {
  QStringList method_names;
  for (const std::string& name : methods.names) method_names.push_back(name.c_str());
  form_->setMethods(method_names);
}

void GeneratePanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  form_->load(config);
}

void GeneratePanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  form_->save(config);
}

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::GeneratePanel, rviz::Panel)
