#pragma once

#include <collision_forge/GenerateCollision.h>
#include <collision_forge/PossibleCollision.h>
#include <rviz/config.h>

#include <QMap>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace forge {

/// Form with the fields of a request of generate_collision.
class RequestForm : public QWidget {
  Q_OBJECT

 public:
  explicit RequestForm(QWidget* parent = nullptr);

  /// Returns the request in the fields, unchecked; `collision_type` is empty for "any". If the line
  /// in words has a text, the request has that text in place of type, time, manoeuvre and attacker.
  /// `stamp` and `alternative` are 0: the newest scene, all attacks.
  collision_forge::GenerateCollision::Request request() const;

  /// Sets type, time, attacker and manoeuvre from `collision`, and empties the line in words.
  void choose(const collision_forge::PossibleCollision& collision);
  /// Sets the selectable attackers (agent ids, in any order) beside "any"; the selection is kept.
  /// Attackers are shown by their short ids, as in the picture. Does nothing while the list is
  /// open.
  void setAttackers(QStringList ids);
  /// Sets the selectable methods beside "default"; the selection is kept if it is among them.
  void setMethods(const QStringList& names);

  /// Restore the fields from the panel's part of an RViz configuration, and save them there.
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;

 Q_SIGNALS:
  /// Emitted when a field changes, by the user, choose() or load().
  void changed();

 private:
  void createFields();
  void createLayout();
  void connectFields();
  void offerManoeuvres();  ///< sets the selectable manoeuvres of the selected type
  /// Returns the short id, or the full id if another agent has the same short id.
  QString shownId(const QString& id);

  QLineEdit* text_ = nullptr;  ///< the request in words
  QComboBox* type_ = nullptr;
  QDoubleSpinBox* tta_ = nullptr;  ///< s
  QComboBox* manoeuvre_ = nullptr;
  QComboBox* attacker_ = nullptr;
  QMap<QString, QString> ids_;   ///< full ids by shown text
  QComboBox* choice_ = nullptr;  ///< AttackerChoice
  QCheckBox* believable_ = nullptr;
  QCheckBox* adaptive_ = nullptr;
  QComboBox* mode_ = nullptr;
  QComboBox* method_ = nullptr;
  QSpinBox* alternatives_ = nullptr;  ///< number of attacks
  QSpinBox* seed_ = nullptr;
};

}  // namespace forge
