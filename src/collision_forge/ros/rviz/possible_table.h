#pragma once

#include <collision_forge/PossibleCollision.h>

#include <QTableWidget>

#include <vector>

namespace forge {

/// Collisions that can be asked for, one a row.
class PossibleTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit PossibleTable(QWidget* parent = nullptr);

  void setCollisions(std::vector<collision_forge::PossibleCollision> collisions);
  const std::vector<collision_forge::PossibleCollision>& collisions() const { return collisions_; }
  /// Marks a row as if it was chosen, without chosen().
  void mark(int row);

 Q_SIGNALS:
  /// By a click or by the keyboard.
  void chosen(const collision_forge::PossibleCollision& collision);

 private:
  void choose();
  void addRow(int row, const collision_forge::PossibleCollision& collision);

  std::vector<collision_forge::PossibleCollision> collisions_;  ///< by row
};

}  // namespace forge
