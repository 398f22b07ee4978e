#pragma once

#include <collision_forge/PossibleCollision.h>

#include <QTableWidget>

#include <vector>

namespace forge {

/// Table of feasible collisions, one per row.
class PossibleTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit PossibleTable(QWidget* parent = nullptr);

  /// Replaces all rows.
  void setCollisions(std::vector<collision_forge::PossibleCollision> collisions);
  /// The collisions in the order of the rows.
  const std::vector<collision_forge::PossibleCollision>& collisions() const { return collisions_; }
  /// Selects a row without emitting chosen().
  void mark(int row);

 Q_SIGNALS:
  /// Emitted when the user selects a row.
  void chosen(const collision_forge::PossibleCollision& collision);

 private:
  void choose();
  void addRow(int row, const collision_forge::PossibleCollision& collision);

  std::vector<collision_forge::PossibleCollision> collisions_;  ///< index: row
};

}  // namespace forge
