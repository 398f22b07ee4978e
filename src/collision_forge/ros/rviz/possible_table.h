#pragma once

#include <collision_forge/PossibleCollision.h>

#include <QTableWidget>

#include <vector>

namespace forge {

/// Table of feasible collisions, one per row: type, requested time to attack (s), attacker (class
/// and short id; "added" for an added one), confidence (percent), manoeuvre. Empty at first.
class PossibleTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit PossibleTable(QWidget* parent = nullptr);

  /// Replaces all rows, in the order of `collisions`; no row is selected, chosen() is not emitted.
  void setCollisions(std::vector<collision_forge::PossibleCollision> collisions);
  /// Returns the collisions in the order of the rows.
  const std::vector<collision_forge::PossibleCollision>& collisions() const { return collisions_; }
  /// Selects a row (index from 0, must exist) without emitting chosen().
  void mark(int row);

 Q_SIGNALS:
  /// Emitted when the user selects a row.
  void chosen(const collision_forge::PossibleCollision& collision);

 private:
  /// Emits chosen() for the selected row, if any.
  void choose();
  /// Fills the row with the index `row`, which must exist, with the texts of `collision`.
  void addRow(int row, const collision_forge::PossibleCollision& collision);

  std::vector<collision_forge::PossibleCollision> collisions_;  ///< index: row
};

}  // namespace forge
