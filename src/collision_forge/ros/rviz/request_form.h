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

/// Form with the fields of a request.
class RequestForm : public QWidget {
  Q_OBJECT

 public:
  explicit RequestForm(QWidget* parent = nullptr);

  /// Returns the request; `collision_type` is empty for "any". If the line in words has a text, the
  /// request has that text in place of type, time, manoeuvre and attacker.
  collision_forge::GenerateCollision::Request request() const;

  /// Sets type, time, attacker and manoeuvre from `collision`.
  void choose(const collision_forge::PossibleCollision& collision);
  /// Sets the selectable attackers and methods; the selection is kept. Attackers are shown by their
  /// short ids, as in the picture.
  void setAttackers(QStringList ids);
  void setMethods(const QStringList& names);

  /// Restore the fields from the panel's part of an RViz configuration, and save them there.
  void load(const rviz::Config& config);
  void save(rviz::Config config) const;

 Q_SIGNALS:
  /// Emitted when the user changes a field.
  void changed();

 private:
  void createFields();
  void createLayout();
  void connectFields();
  void offerManoeuvres();
  QString shownId(const QString& id);

  QLineEdit* text_ = nullptr;
  QComboBox* type_ = nullptr;
  QDoubleSpinBox* tta_ = nullptr;
  QComboBox* manoeuvre_ = nullptr;
  QComboBox* attacker_ = nullptr;
  QMap<QString, QString> ids_;  ///< full ids by shown text
  QComboBox* choice_ = nullptr;
  QCheckBox* believable_ = nullptr;
  QCheckBox* adaptive_ = nullptr;
  QComboBox* mode_ = nullptr;
  QComboBox* method_ = nullptr;
  QSpinBox* alternatives_ = nullptr;
  QSpinBox* seed_ = nullptr;
};

}  // namespace forge
