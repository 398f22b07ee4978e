#include "collision_forge/ros/rviz/generate_panel.h"

#include <collision_forge/Agent.h>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/possible_collisions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/rviz/attack_words.h"
#include "collision_forge/ros/rviz/player_buttons.h"
#include "collision_forge/ros/rviz/possible_table.h"
#include "collision_forge/ros/rviz/request_form.h"

namespace forge {

namespace {

using collision_forge::GenerateCollision;
using collision_forge::ListCollisions;
using collision_forge::TestPlanner;

constexpr int kCountdownPeriod = 100;  // ms
constexpr int kCrashLines = 3;
constexpr int kSpacing = 4;  // pixels
constexpr int kTableLines = 6;
constexpr int kStatusLines = 2;
constexpr int kTextLines = 16;             // of the three texts together
constexpr char kPlannerKey[] = "Planner";  // in the .rviz file

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

/// Returns the failure as rich text; empty for a response with code OK.
template <typename Answer>
QString problemOf(const Answer& answer, const char* service) {
  if (!answer) return QString("<b>No response</b> from ") + ros::names::resolve(service).c_str();
  if (answer->code == GenerateCollision::Response::OK) return {};
  return failureText(answer->code, answer->message);
}

QString firstLine(const std::string& text) {
  return QString::fromStdString(text.substr(0, text.find('\n'))).toHtmlEscaped();
}

QString notUnderstoodText(const std::vector<std::string>& words) {
  QStringList list;
  for (const std::string& word : words) list.push_back(word.c_str());
  return (" Not understood: " + list.join(", ")).toHtmlEscaped();
}

/// Returns the attack and its alternatives as table rows.
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
      listing_([this](const auto& answer) { showPossible(answer); }),
      testing_([this](const auto& answer) { showOutcome(answer); }) {
  createWidgets();
  createLayout();
  connect(form_, &RequestForm::changed, this, &rviz::Panel::configChanged);
  connect(generate_, &QPushButton::clicked, this, &GeneratePanel::generate);
  connect(list_, &QPushButton::clicked, this, &GeneratePanel::list);
  connect(test_, &QPushButton::clicked, this, &GeneratePanel::testPlanner);
  connect(planner_, &QComboBox::currentTextChanged, this, &rviz::Panel::configChanged);
  connect(table_, &PossibleTable::chosen, this, &GeneratePanel::choose);
  const auto forget_row = [this] { row_.reset(); };
  connect(form_, &RequestForm::changed, this, forget_row);
  connect(player_, &PlayerButtons::moved, this, forget_row);
  connect(player_, &PlayerButtons::failed, this, [this](const QString& text) { showStatus(text); });
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
  list_->setToolTip("Pauses the player and lists the feasible collisions at that time");
  planner_ = new QComboBox;
  planner_->setObjectName("planner");
  for (const std::string& name : plannerNames()) planner_->addItem(name.c_str());
  test_ = button("test_planner", "Test planner");
  test_->setToolTip(
      "Pauses the player and tests the planner in closed loop against the newest attack");
  test_->setEnabled(false);
  table_ = new PossibleTable;
  table_->setObjectName("possible");
  table_->setToolTip("Select a row to request it");
  table_->setMinimumHeight(kTableLines * table_->fontMetrics().lineSpacing());
  status_ = label("status", kStatusLines);
  showStatus("Set the request, then press Generate.");
  crash_ = label("crash", kCrashLines);
  QFont large = crash_->font();
  large.setPointSizeF(1.2 * large.pointSizeF());
  large.setBold(true);
  crash_->setFont(large);
  crash_->setMinimumHeight(kCrashLines * crash_->fontMetrics().lineSpacing());
  attack_text_ = label("attack", 1);
}

void GeneratePanel::createLayout() {
  auto* buttons = new QGridLayout;
  buttons->addWidget(generate_, 0, 0);
  buttons->addWidget(list_, 0, 1);
  buttons->addWidget(planner_, 1, 0);
  buttons->addWidget(test_, 1, 1);
  for (int column = 0; column < 2; ++column) buttons->setColumnStretch(column, 1);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(kSpacing);
  for (QWidget* fixed : std::initializer_list<QWidget*>{player_, form_}) {
    fixed->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  }
  column->addWidget(player_);
  column->addWidget(form_);
  column->addLayout(buttons);
  column->addWidget(table_, 1);
  column->addWidget(createTexts(), 1);
}

/// The texts scroll, so that a long one does not move the other widgets.
QWidget* GeneratePanel::createTexts() {
  auto* texts = new QWidget;
  auto* column = new QVBoxLayout(texts);
  column->setContentsMargins(0, 0, 0, 0);
  for (QLabel* text : {status_, crash_, attack_text_}) column->addWidget(text);
  column->addStretch(1);
  auto* area = new QScrollArea;
  area->setWidget(texts);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumHeight(kTextLines * fontMetrics().lineSpacing());
  return area;
}

/// RViz handles ROS callbacks in the thread of the GUI.
void GeneratePanel::subscribe() {
  subscribers_ = {node_.subscribe(names::kAttackMethods, 1, &GeneratePanel::showMethods, this),
                  node_.subscribe(names::kEncodedScene, 1, &GeneratePanel::showScene, this),
                  node_.subscribe(names::kAttack, 1, &GeneratePanel::showAttack, this),
                  node_.subscribe(names::kTestedReport, 1, &GeneratePanel::showTested, this)};
}

void GeneratePanel::generate() {
  if (row_) return ask(requestOf(*row_));
  const GenerateCollision::Request request = form_->request();
  if (!request.collision_type.empty() || !request.text.empty()) return ask(request);
  requests_most_confident_ = true;
  listPossibleCollisions(request, {request.tta});
}

void GeneratePanel::showStatus(const QString& text, const QString& whole) {
  status_->setText(text);
  status_->setToolTip(whole);
}

void GeneratePanel::ask(GenerateCollision::Request request) {
  generate_->setEnabled(false);
  showStatus("Generating ...");
  generate_request_ = request;
  generating_.start(names::kGenerateCollision, request);
}

void GeneratePanel::choose(const collision_forge::PossibleCollision& collision) {
  form_->choose(collision);
  row_ = collision;
}

void GeneratePanel::setTable(const std::vector<collision_forge::PossibleCollision>& collisions,
                             GenerateCollision::Request request, const ros::Time& now) {
  table_->setCollisions(collisions);
  listed_ = std::move(request);
  listed_.stamp = now;
  row_.reset();
}

GenerateCollision::Request GeneratePanel::requestOf(
    const collision_forge::PossibleCollision& row) const {
  GenerateCollision::Request request = listed_;
  if (request.text.empty()) {
    request.collision_type = row.collision_type;
    request.tta = row.tta;
  }
  request.alternative = row.alternative;
  return request;
}

void GeneratePanel::showAnswer(const ServiceCall<GenerateCollision>::Answer& answer) {
  generate_->setEnabled(true);
  const QString problem = problemOf(answer, names::kGenerateCollision);
  QString found = "An attack was found.";
  if (answer && !answer->not_understood.empty()) found += notUnderstoodText(answer->not_understood);
  showStatus(problem.isEmpty() ? found : problem);
  if (!problem.isEmpty() || answer->alternatives.empty()) return;
  const auto attacks = attacksIn(*answer, generate_request_.tta);
  showStatus(QString("%1 attacks; the first is injected.").arg(attacks.size()));
  setTable(attacks, generate_request_, answer->attack.header.stamp);
}

void GeneratePanel::list() {
  requests_most_confident_ = false;
  GenerateCollision::Request each = form_->request();
  each.attacker_id.clear();
  each.choice.clear();
  each.manoeuvre.clear();
  each.text.clear();
  listPossibleCollisions(each, {});
}

/// Calls list_collisions for all types.
void GeneratePanel::listPossibleCollisions(GenerateCollision::Request each,
                                           const std::vector<double>& ttas) {
  player_->pause();
  for (QPushButton* button : {list_, generate_}) button->setEnabled(false);
  showStatus("Listing possible collisions ...");
  each.collision_type.clear();
  each.tta = 0.0;
  each.alternatives = 1;
  list_request_ = each;
  ListCollisions::Request request;
  request.ttas = ttas;
  request.request = requestIn(each);
  request.method = each.method;
  listing_.start(names::kListCollisions, request);
}

void GeneratePanel::showPossible(const ServiceCall<ListCollisions>::Answer& answer) {
  for (QPushButton* button : {list_, generate_}) button->setEnabled(true);
  const QString problem = problemOf(answer, names::kListCollisions);
  showStatus(problem);
  if (!problem.isEmpty()) return;
  setTable(answer->collisions, list_request_, answer->now);
  if (answer->collisions.empty()) {
    return showStatus(firstLine(answer->message), QString::fromStdString(answer->message));
  }
  showStatus("Select a collision, then press Generate.");
  if (requests_most_confident_) requestMostConfident();
}

/// Requests the table row with the highest confidence.
void GeneratePanel::requestMostConfident() {
  const auto& collisions = table_->collisions();
  const auto surest =
      std::max_element(collisions.begin(), collisions.end(),
                       [](const auto& a, const auto& b) { return a.confidence < b.confidence; });
  table_->mark(static_cast<int>(std::distance(collisions.begin(), surest)));
  GenerateCollision::Request request = requestOf(*surest);
  request.alternatives = form_->request().alternatives;
  request.alternative = 0;  // returned together with its alternatives
  ask(request);
}

void GeneratePanel::testPlanner() {
  player_->pause();
  test_->setEnabled(false);
  showStatus("Testing " + planner_->currentText() + " ...");
  TestPlanner::Request request;
  request.planner = planner_->currentText().toStdString();
  request.attacker_policy = attack_->adaptive ? "adaptive" : "fixed";
  testing_.start(names::kTestPlanner, request);
}

void GeneratePanel::showOutcome(const ServiceCall<TestPlanner>::Answer& answer) {
  test_->setEnabled(true);
  const QString problem = problemOf(answer, names::kTestPlanner);
  showStatus(problem.isEmpty() ? outcomeText(answer->outcome) : problem);
}

void GeneratePanel::showAttack(const collision_forge::AttackConstPtr& attack) {
  attack_ = attack;
  test_->setEnabled(!isNone(*attack));
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
  QString planner;
  if (config.mapGetString(kPlannerKey, &planner)) planner_->setCurrentText(planner);
}

void GeneratePanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  form_->save(config);
  config.mapSetValue(kPlannerKey, planner_->currentText());
}

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::GeneratePanel, rviz::Panel)
