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

/// Form with the fields of a request of generate_collision. Its default: type "any" in 4 s, any
/// attacker and manoeuvre, plausible, mode history, default method, one attack, seed 0.
class RequestForm : public QWidget {
  Q_OBJECT

 public:
  explicit RequestForm(QWidget* parent = nullptr);

  /// Returns the request in the fields, unchecked; type, manoeuvre, attacker and method are empty
  /// for "any" and "default", an attacker has its full id. If the line in words has a text, the
  /// request has that text, and type, time, manoeuvre, attacker and choice are empty or 0. `stamp`
  /// and `alternative` are 0: the newest scene, all attacks.
  collision_forge::GenerateCollision::Request request() const;

  /// Sets type, time, attacker and manoeuvre from `collision`, and empties the line in words. The
  /// choice becomes "existing"; for an added attacker it becomes "new" and the attacker "any".
  void choose(const collision_forge::PossibleCollision& collision);
  /// Sets the selectable attackers (full agent ids, in any order) beside "any"; the selection is
  /// kept, also if it is not among them. Attackers are shown by their short ids, as in the picture,
  /// sorted by the shown text. Does nothing while the list is open.
  void setAttackers(QStringList ids);
  /// Sets the selectable methods beside "default"; the selection is kept if it is among them, else
  /// "default" is selected.
  void setMethods(const QStringList& names);

  /// load() restores the fields from the panel's part of an RViz configuration and keeps a field
  /// whose key is missing or whose saved type, manoeuvre, choice or mode is unknown (an unknown
  /// method or attacker becomes selected instead); save() writes all fields there.
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;

 Q_SIGNALS:
  /// Emitted when a field changes, by the user, choose() or load(); not by setAttackers() and
  /// setMethods().
  void changed();

 private:
  void createFields();     ///< creates the widgets below, with the defaults
  void createLayout();     ///< arranges the widgets
  void connectFields();    ///< lets every field emit changed()
  void offerManoeuvres();  ///< sets the selectable manoeuvres of the selected type
  /// Returns the short id, or the full id if another agent has the same short id.
  QString shownId(const QString& id);

  QLineEdit* text_ = nullptr;      ///< the request in words
  QComboBox* type_ = nullptr;      ///< "any" or a CollisionType
  QDoubleSpinBox* tta_ = nullptr;  ///< time to attack, s from t0
  QComboBox* manoeuvre_ = nullptr;
  QComboBox* attacker_ = nullptr;
  QMap<QString, QString> ids_;   ///< full ids by shown text
  QComboBox* choice_ = nullptr;  ///< AttackerChoice
  QCheckBox* believable_ = nullptr;
  QCheckBox* adaptive_ = nullptr;
  QComboBox* mode_ = nullptr;
  QComboBox* method_ = nullptr;
  QSpinBox* alternatives_ = nullptr;  ///< number of attacks, 1 to 16
  QSpinBox* seed_ = nullptr;
};

}  // namespace forge
