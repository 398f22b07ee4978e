#include "collision_forge/ros/rviz/request_form.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>

#include <iterator>
#include <limits>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/base/scene/short_id.h"

namespace forge {

namespace {

constexpr char kAny[] = "any";
constexpr char kDefaultMethod[] = "default";
constexpr int kFieldLetters = 12;      // width of a field whose items change
constexpr int kMostAlternatives = 16;  // limit of GenerateCollision.srv
constexpr double kShortestTta = 0.5;   // s; limits of GenerateCollision.srv
constexpr double kLongestTta = 9.0;

// Keys in the .rviz file.
constexpr char kTextKey[] = "In Words";
constexpr char kTypeKey[] = "Collision Type";
constexpr char kTtaKey[] = "Time To Attack";
constexpr char kManoeuvreKey[] = "Manoeuvre";
constexpr char kAttackerKey[] = "Attacker";
constexpr char kChoiceKey[] = "Attacker Choice";
constexpr char kBelievableKey[] = "Believable";
constexpr char kAdaptiveKey[] = "Adaptive";
constexpr char kModeKey[] = "Mode";
constexpr char kMethodKey[] = "Method";
constexpr char kAlternativesKey[] = "Alternatives";
constexpr char kSeedKey[] = "Seed";

/// Returns the selected text; empty for the item `any`.
std::string chosenIn(const QComboBox& box, const char* any = kAny) {
  const QString text = box.currentText().trimmed();
  return text == any ? std::string() : text.toStdString();
}

/// Replaces the items; keeps the selection if it is still an item, or editable.
void offer(QComboBox& box, const char* any, const QStringList& items) {
  const QSignalBlocker no_change_of_settings(&box);
  const QString chosen = box.currentText();
  box.clear();
  box.addItem(any);
  box.addItems(items);
  box.setCurrentText(chosen);
}

/// Keeps the width of the box independent of its items.
void keepWidth(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(kFieldLetters);
}

QStringList itemsOf(const QComboBox& box) {
  QStringList items;
  for (int i = 0; i < box.count(); ++i) items.push_back(box.itemText(i));
  return items;
}

QHBoxLayout* besideEachOther(QWidget* left, const char* between, QWidget* right) {
  auto* row = new QHBoxLayout;
  row->addWidget(left, 1);
  if (*between) row->addWidget(new QLabel(between));
  row->addWidget(right, 1);
  return row;
}

}  // namespace

RequestForm::RequestForm(QWidget* parent) : QWidget(parent) {
  setLocale(QLocale::c());  // numbers with a point, as everywhere else
  createFields();
  createLayout();
  connectFields();
}

void RequestForm::createFields() {
  text_ = new QLineEdit;
  text_->setObjectName("text");
  text_->setPlaceholderText("truck cuts in from the left in 3 s");
  text_->setToolTip(
      "The request in English, or the name of a scenario such as CCRb; replaces type, time, "
      "manoeuvre and attacker");
  type_ = new QComboBox;
  type_->setObjectName("type");
  type_->addItem(kAny);
  for (const CollisionType type : kAllCollisionTypes) type_->addItem(toString(type));
  type_->setToolTip("any: the collision with the highest confidence at that time to attack");
  tta_ = new QDoubleSpinBox;
  tta_->setRange(kShortestTta, kLongestTta);
  tta_->setSingleStep(0.5);
  tta_->setValue(4.0);
  tta_->setSuffix(" s");
  manoeuvre_ = new QComboBox;
  manoeuvre_->setObjectName("manoeuvre");
  keepWidth(*manoeuvre_);
  offerManoeuvres();
  attacker_ = new QComboBox;
  attacker_->setEditable(true);
  attacker_->setInsertPolicy(QComboBox::NoInsert);
  keepWidth(*attacker_);
  attacker_->addItem(kAny);
  choice_ = new QComboBox;
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    choice_->addItem(toString(choice));
  }
  choice_->setToolTip("existing: a recorded vehicle; new: an added vehicle");
  believable_ = new QCheckBox("plausible");
  believable_->setChecked(true);
  adaptive_ = new QCheckBox("adaptive");
  mode_ = new QComboBox;
  for (const Mode mode : {Mode::kHistory, Mode::kReplay}) mode_->addItem(toString(mode));
  method_ = new QComboBox;
  keepWidth(*method_);
  method_->addItem(kDefaultMethod);
  alternatives_ = new QSpinBox;
  alternatives_->setRange(1, kMostAlternatives);
  alternatives_->setToolTip("Number of attacks; the table below lists them");
  seed_ = new QSpinBox;
  seed_->setObjectName("seed");
  seed_->setRange(0, std::numeric_limits<int>::max());
}

void RequestForm::createLayout() {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow("In words", text_);
  form->addRow("Collision", besideEachOther(type_, "in", tta_));
  form->addRow("Manoeuvre", manoeuvre_);
  form->addRow("Attacker", besideEachOther(attacker_, "", choice_));
  form->addRow("Drives", besideEachOther(believable_, "", adaptive_));
  form->addRow("Mode", besideEachOther(mode_, "by", method_));
  form->addRow("Attacks", besideEachOther(alternatives_, "seed", seed_));
}

void RequestForm::connectFields() {
  connect(type_, &QComboBox::currentTextChanged, this, &RequestForm::offerManoeuvres);
  for (QComboBox* box : {type_, manoeuvre_, attacker_, choice_, mode_, method_}) {
    connect(box, &QComboBox::currentTextChanged, this, &RequestForm::changed);
  }
  for (QCheckBox* box : {believable_, adaptive_}) {
    connect(box, &QCheckBox::toggled, this, &RequestForm::changed);
  }
  connect(text_, &QLineEdit::textChanged, this, &RequestForm::changed);
  connect(tta_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &RequestForm::changed);
  for (QSpinBox* box : {alternatives_, seed_}) {
    connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &RequestForm::changed);
  }
}

/// Offers the manoeuvres of the selected type.
void RequestForm::offerManoeuvres() {
  QStringList names;
  const auto type = collisionTypeFromString(type_->currentText().toStdString());
  if (type && *type != CollisionType::kAny) {
    for (const Manoeuvre manoeuvre : manoeuvresOf(*type)) names.push_back(toString(manoeuvre));
  }
  offer(*manoeuvre_, kAny, names);
}

collision_forge::GenerateCollision::Request RequestForm::request() const {
  collision_forge::GenerateCollision::Request request;
  request.believable = believable_->isChecked() ? "true" : "false";
  request.mode = mode_->currentText().toStdString();
  request.seed = static_cast<std::uint64_t>(seed_->value());
  request.text = text_->text().trimmed().toStdString();
  if (request.text.empty()) {
    request.collision_type = chosenIn(*type_);
    request.tta = tta_->value();
    request.manoeuvre = chosenIn(*manoeuvre_);
    const QString attacker = QString::fromStdString(chosenIn(*attacker_));
    request.attacker_id = ids_.value(attacker, attacker).toStdString();
    request.choice = choice_->currentText().toStdString();
  }
  request.adaptive = adaptive_->isChecked();
  request.alternatives = static_cast<std::uint32_t>(alternatives_->value());
  request.method = chosenIn(*method_, kDefaultMethod);
  return request;
}

void RequestForm::choose(const collision_forge::PossibleCollision& collision) {
  text_->clear();
  type_->setCurrentText(QString::fromStdString(collision.collision_type));
  tta_->setValue(collision.tta);
  manoeuvre_->setCurrentText(QString::fromStdString(collision.manoeuvre));
  attacker_->setCurrentText(
      collision.added ? kAny : shownId(QString::fromStdString(collision.attacker_id)));
  choice_->setCurrentText(
      toString(collision.added ? AttackerChoice::kNew : AttackerChoice::kExisting));
}

/// Returns the short id; the full id if another agent has the same short id.
QString RequestForm::shownId(const QString& id) {
  const QString shown = QString::fromStdString(shortId(id.toStdString()));
  const QString& known = ids_.contains(shown) ? ids_[shown] : ids_[shown] = id;
  return known == id ? shown : id;
}

void RequestForm::setAttackers(QStringList ids) {
  for (QString& id : ids) id = shownId(id);
  ids.sort();
  if (QStringList(kAny) + ids == itemsOf(*attacker_) || attacker_->view()->isVisible()) return;
  offer(*attacker_, kAny, ids);
}

void RequestForm::setMethods(const QStringList& names) { offer(*method_, kDefaultMethod, names); }

void RequestForm::load(const rviz::Config& config) {
  const auto load_text = [&config](const char* key, QComboBox* box) {
    QString text;
    if (config.mapGetString(key, &text)) box->setCurrentText(text);
  };
  const auto load_check = [&config](const char* key, QCheckBox* box) {
    bool is_checked = false;
    if (config.mapGetBool(key, &is_checked)) box->setChecked(is_checked);
  };
  const auto load_number = [&config](const char* key, QSpinBox* box) {
    int number = 0;
    if (config.mapGetInt(key, &number)) box->setValue(number);
  };
  QString text;
  if (config.mapGetString(kTextKey, &text)) text_->setText(text);
  load_text(kTypeKey, type_);
  load_text(kManoeuvreKey, manoeuvre_);
  load_text(kAttackerKey, attacker_);
  load_text(kChoiceKey, choice_);
  load_check(kBelievableKey, believable_);
  load_check(kAdaptiveKey, adaptive_);
  load_text(kModeKey, mode_);
  QString method;
  if (config.mapGetString(kMethodKey, &method)) {
    if (method_->findText(method) < 0) method_->addItem(method);
    method_->setCurrentText(method);
  }
  float tta = 0;
  if (config.mapGetFloat(kTtaKey, &tta)) tta_->setValue(tta);
  load_number(kAlternativesKey, alternatives_);
  load_number(kSeedKey, seed_);
}

void RequestForm::save(rviz::Config config) const {
  config.mapSetValue(kTextKey, text_->text());
  config.mapSetValue(kTypeKey, type_->currentText());
  config.mapSetValue(kTtaKey, tta_->value());
  config.mapSetValue(kManoeuvreKey, manoeuvre_->currentText());
  config.mapSetValue(kAttackerKey, attacker_->currentText());
  config.mapSetValue(kChoiceKey, choice_->currentText());
  config.mapSetValue(kBelievableKey, believable_->isChecked());
  config.mapSetValue(kAdaptiveKey, adaptive_->isChecked());
  config.mapSetValue(kModeKey, mode_->currentText());
  config.mapSetValue(kMethodKey, method_->currentText());
  config.mapSetValue(kAlternativesKey, alternatives_->value());
  config.mapSetValue(kSeedKey, seed_->value());
}

}  // namespace forge
