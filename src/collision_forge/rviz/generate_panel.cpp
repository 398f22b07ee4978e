#include "collision_forge/rviz/generate_panel.h"

#include <collision_forge/Agent.h>

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QtConcurrent>

#include <cmath>
#include <limits>
#include <pluginlib/class_list_macros.hpp>

#include "collision_forge/ros/topic_names.h"
#include "collision_forge/scene/collision_request.h"
#include "collision_forge/scene/track.h"

namespace forge {

namespace {

using collision_forge::GenerateCollision;

constexpr char kAnyAttacker[] = "any";
constexpr char kDefaultMethod[] = "default";
constexpr int kShortestAttackerField = 12;  // letters
constexpr int kResultLines = 13;

// Keys in the .rviz file.
constexpr char kTypeKey[] = "Collision Type";
constexpr char kTtaKey[] = "Time To Accident";
constexpr char kAttackerKey[] = "Attacker";
constexpr char kChoiceKey[] = "Attacker Choice";
constexpr char kBelievableKey[] = "Believable";
constexpr char kAdaptiveKey[] = "Adaptive";
constexpr char kModeKey[] = "Mode";
constexpr char kSeedKey[] = "Seed";
constexpr char kMethodKey[] = "Method";

QString attackText(const collision_forge::Attack& attack) {
  const auto& report = attack.report;
  QString text = QString("<b>%1</b> by %2")
                     .arg(QString::fromStdString(attack.pattern.collision_type),
                          QString::fromStdString(report.attacker_id).toHtmlEscaped() +
                              (attack.trajectory.added ? ", added" : ""));
  if (attack.adaptive) {
    text += QString("<br>%1: %2")
                .arg(QString::fromStdString(attack.phase),
                     QString::fromStdString(attack.decision).toHtmlEscaped());
  }
  if (!report.contact) return text + "<br>No contact is foreseen.";
  const double contact_time = (report.contact_time - report.header.stamp).toSec();
  return text + QString(
                    "<table>"
                    "<tr><td>Contact in</td><td align=right>%1 s</td></tr>"
                    "<tr><td>Relative heading</td><td align=right>%2 deg</td></tr>"
                    "<tr><td>Sides</td><td align=right>%3 to ego's %4</td></tr>"
                    "<tr><td>Impact speed</td><td align=right>%5 m/s</td></tr>"
                    "<tr><td>Overlap</td><td align=right>%6 %</td></tr>"
                    "<tr><td>Confidence</td><td align=right>%7</td></tr>"
                    "<tr><td>Manoeuvre</td><td align=right>%8</td></tr></table>%9")
                    .arg(contact_time, 0, 'f', 2)
                    .arg(report.relative_heading * 180 / M_PI, 0, 'f', 0)
                    .arg(QString::fromStdString(report.attacker_side),
                         QString::fromStdString(report.ego_side))
                    .arg(report.impact_speed, 0, 'f', 1)
                    .arg(100 * report.overlap, 0, 'f', 0)
                    .arg(report.confidence, 0, 'f', 2)
                    .arg(QString::fromStdString(report.manoeuvre),
                         report.believable
                             ? QString()
                             : "Not believable: it " +
                                   QString::fromStdString(report.unbelievable).toHtmlEscaped());
}

QString failureText(const GenerateCollision::Response& response) {
  return QString("<b>%1</b> (%2)<br>%3")
      .arg(toString(static_cast<StatusCode>(response.code)))
      .arg(response.code)
      .arg(QString::fromStdString(response.message).toHtmlEscaped());
}

QStringList attackersIn(const collision_forge::SceneSnapshot& scene) {
  QStringList ids;
  for (const auto& agent : scene.agents) {
    const bool is_known = agent.agent_class <= collision_forge::Agent::STATIC_OBJECT;
    const bool is_here = !agent.states.empty() && agent.states.back().stamp == scene.header.stamp;
    if (is_known && is_here && canAttack(static_cast<AgentClass>(agent.agent_class))) {
      ids.push_back(QString::fromStdString(agent.id));
    }
  }
  ids.sort();
  ids.push_front(kAnyAttacker);
  return ids;
}

QStringList itemsOf(const QComboBox& box) {
  QStringList items;
  for (int i = 0; i < box.count(); ++i) items.push_back(box.itemText(i));
  return items;
}

}  // namespace

GeneratePanel::GeneratePanel(QWidget* parent) : rviz::Panel(parent) {
  createFields();
  createLayout();
  connect(generate_, &QPushButton::clicked, this, &GeneratePanel::generate);
  connect(&answer_, &QFutureWatcherBase::finished, this, &GeneratePanel::showAnswer);
  for (QComboBox* box : {type_, attacker_, choice_, mode_, method_}) {
    connect(box, &QComboBox::currentTextChanged, this, &rviz::Panel::configChanged);
  }
  for (QCheckBox* box : {believable_, adaptive_}) {
    connect(box, &QCheckBox::toggled, this, &rviz::Panel::configChanged);
  }
  connect(tta_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          &rviz::Panel::configChanged);
  connect(seed_, qOverload<int>(&QSpinBox::valueChanged), this, &rviz::Panel::configChanged);
  // RViz handles ROS callbacks in the thread of the GUI.
  methods_subscriber_ =
      node_.subscribe(names::kAttackMethods, 1, &GeneratePanel::showMethods, this);
  scene_subscriber_ = node_.subscribe(names::kEncodedScene, 1, &GeneratePanel::showScene, this);
  attack_subscriber_ = node_.subscribe(names::kAttack, 1, &GeneratePanel::showAttack, this);
}

void GeneratePanel::createFields() {
  type_ = new QComboBox;
  for (const CollisionType type : kCollisionTypes) type_->addItem(toString(type));
  tta_ = new QDoubleSpinBox;
  tta_->setRange(0.5, 9.0);  // as in GenerateCollision.srv
  tta_->setSingleStep(0.5);
  tta_->setValue(4.0);
  tta_->setSuffix(" s");
  attacker_ = new QComboBox;
  attacker_->setEditable(true);
  attacker_->setInsertPolicy(QComboBox::NoInsert);
  attacker_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  attacker_->setMinimumContentsLength(kShortestAttackerField);
  attacker_->addItem(kAnyAttacker);
  choice_ = new QComboBox;
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    choice_->addItem(toString(choice));
  }
  believable_ = new QCheckBox("believable");
  believable_->setChecked(true);
  adaptive_ = new QCheckBox("sees and reacts");
  mode_ = new QComboBox;
  for (const Mode mode : {Mode::kHistory, Mode::kReplay}) mode_->addItem(toString(mode));
  method_ = new QComboBox;
  method_->addItem(kDefaultMethod);
  seed_ = new QSpinBox;
  seed_->setRange(0, std::numeric_limits<int>::max());
  generate_ = new QPushButton("Generate");
  result_ = new QLabel("No collision generated yet.");
  result_->setWordWrap(true);
  result_->setMinimumHeight(kResultLines * result_->fontMetrics().lineSpacing());
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  result_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

void GeneratePanel::createLayout() {
  auto* form = new QFormLayout;
  form->addRow("Collision type", type_);
  form->addRow("Time to accident", tta_);
  form->addRow("Attacker", attacker_);
  form->addRow("Existing or new", choice_);
  auto* drives = new QHBoxLayout;
  drives->addWidget(believable_);
  drives->addWidget(adaptive_);
  form->addRow("Drives", drives);
  form->addRow("Mode", mode_);
  form->addRow("Method", method_);
  form->addRow("Seed", seed_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(generate_);
  column->addWidget(result_, 1);
}

GenerateCollision::Request GeneratePanel::request() const {
  GenerateCollision::Request request;
  request.collision_type = type_->currentText().toStdString();
  request.tta = tta_->value();
  const QString attacker = attacker_->currentText().trimmed();
  if (attacker != kAnyAttacker) request.attacker_id = attacker.toStdString();
  request.choice = choice_->currentText().toStdString();
  request.believable = believable_->isChecked() ? "true" : "false";
  request.adaptive = adaptive_->isChecked();
  request.mode = mode_->currentText().toStdString();
  if (method_->currentText() != kDefaultMethod) {
    request.method = method_->currentText().toStdString();
  }
  request.seed = static_cast<std::uint64_t>(seed_->value());
  return request;
}

void GeneratePanel::generate() {
  generate_->setEnabled(false);
  result_->setText("Generating ...");
  answer_.setFuture(QtConcurrent::run(&caller_, [request = request()]() -> Answer {
    GenerateCollision::Response response;
    if (!ros::service::call(names::kGenerateCollision, request, response)) return std::nullopt;
    return response;
  }));
}

void GeneratePanel::showAnswer() {
  generate_->setEnabled(true);
  const Answer answer = answer_.result();
  answered_.reset();
  if (!answer) {
    const QString name = QString::fromStdString(node_.resolveName(names::kGenerateCollision));
    result_->setText("<b>No answer</b> from " + name);
  } else if (answer->code == GenerateCollision::Response::OK) {
    answered_ = answer->attack;
    result_->setText(attackText(*answered_));
    if (attack_) showWhatBecame();
  } else {
    result_->setText(failureText(*answer));
  }
}

void GeneratePanel::showAttack(const collision_forge::AttackConstPtr& attack) {
  attack_ = attack;
  if (answered_) showWhatBecame();
}

/// Of the attack that was answered: where its attacker reacts, the newest says more.
void GeneratePanel::showWhatBecame() {
  if (!answered_->adaptive || !attack_->adaptive) return;
  if (attack_->header.stamp != answered_->header.stamp) return;
  if (attack_->report.attacker_id != answered_->report.attacker_id) return;
  result_->setText(attackText(*attack_));
}

void GeneratePanel::showScene(const collision_forge::EncodedSceneConstPtr& scene) {
  const QStringList ids = attackersIn(scene->snapshot);
  if (ids == itemsOf(*attacker_) || attacker_->view()->isVisible()) return;
  const QSignalBlocker no_change_of_settings(attacker_);
  const QString chosen = attacker_->currentText();
  attacker_->clear();
  attacker_->addItems(ids);
  attacker_->setCurrentText(chosen);
}

void GeneratePanel::showMethods(const collision_forge::AttackMethods& methods) {
  const QSignalBlocker no_change_of_settings(method_);
  const QString chosen = method_->currentText();
  method_->clear();
  method_->addItem(kDefaultMethod);
  for (const std::string& name : methods.names) method_->addItem(QString::fromStdString(name));
  method_->setCurrentText(chosen);
}

void GeneratePanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  const auto load_text = [&config](const char* key, QComboBox* box) {
    QString text;
    if (config.mapGetString(key, &text)) box->setCurrentText(text);
  };
  load_text(kTypeKey, type_);
  load_text(kAttackerKey, attacker_);
  load_text(kChoiceKey, choice_);
  bool is_believable = true;
  if (config.mapGetBool(kBelievableKey, &is_believable)) believable_->setChecked(is_believable);
  bool is_adaptive = false;
  if (config.mapGetBool(kAdaptiveKey, &is_adaptive)) adaptive_->setChecked(is_adaptive);
  load_text(kModeKey, mode_);
  QString method;
  if (config.mapGetString(kMethodKey, &method)) {
    if (method_->findText(method) < 0) method_->addItem(method);
    method_->setCurrentText(method);
  }
  float tta = 0;
  if (config.mapGetFloat(kTtaKey, &tta)) tta_->setValue(tta);
  int seed = 0;
  if (config.mapGetInt(kSeedKey, &seed)) seed_->setValue(seed);
}

void GeneratePanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kTypeKey, type_->currentText());
  config.mapSetValue(kTtaKey, tta_->value());
  config.mapSetValue(kAttackerKey, attacker_->currentText());
  config.mapSetValue(kChoiceKey, choice_->currentText());
  config.mapSetValue(kBelievableKey, believable_->isChecked());
  config.mapSetValue(kAdaptiveKey, adaptive_->isChecked());
  config.mapSetValue(kModeKey, mode_->currentText());
  config.mapSetValue(kMethodKey, method_->currentText());
  config.mapSetValue(kSeedKey, seed_->value());
}

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::GeneratePanel, rviz::Panel)
