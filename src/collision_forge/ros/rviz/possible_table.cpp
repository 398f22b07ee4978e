#include "collision_forge/ros/rviz/possible_table.h"

#include <QHeaderView>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/short_id.h"

namespace forge {

namespace {

constexpr int kLetters = 58;  // characters per row

}  // namespace

PossibleTable::PossibleTable(QWidget* parent) : QTableWidget(parent) {
  setColumnCount(5);
  setHorizontalHeaderLabels({"collision", "in s", "by", "conf.", "manoeuvre"});
  verticalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setStretchLastSection(true);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeaderItem(3)->setToolTip("Confidence");
  setMinimumWidth(kLetters * fontMetrics().averageCharWidth());
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setShowGrid(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  connect(this, &QTableWidget::itemSelectionChanged, this, &PossibleTable::choose);
}

void PossibleTable::setCollisions(std::vector<collision_forge::PossibleCollision> collisions) {
  const QSignalBlocker nothing_is_chosen(this);
  collisions_ = std::move(collisions);
  setRowCount(static_cast<int>(collisions_.size()));
  for (int row = 0; row < rowCount(); ++row) addRow(row, collisions_[row]);
  clearSelection();
  resizeRowsToContents();
}

void PossibleTable::mark(int row) {
  const QSignalBlocker nothing_is_chosen(this);
  selectRow(row);
}

void PossibleTable::addRow(int row, const collision_forge::PossibleCollision& collision) {
  const QString attacker = QString::fromStdString(shortId(collision.attacker_id));
  const QString of_class = QString::fromStdString(collision.attacker_class);
  const QString by = collision.added ? "added " + of_class : of_class + " " + attacker;
  const QString texts[] = {QString::fromStdString(collision.collision_type),
                           QString::number(collision.tta, 'f', 1), by,
                           QString::fromStdString(percentText(collision.confidence)),
                           QString::fromStdString(collision.manoeuvre)};
  const QString more = QString("%4: contact after %1 s with %2 m/s, attacker %3")
                           .arg(collision.contact_after, 0, 'f', 2)
                           .arg(collision.impact_speed, 0, 'f', 1)
                           .arg(attacker, QString::fromStdString(collision.manoeuvre));
  for (int column = 0; column < columnCount(); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(more);
    setItem(row, column, item);
  }
}

void PossibleTable::choose() {
  const QModelIndexList rows = selectionModel()->selectedRows();
  if (!rows.isEmpty()) Q_EMIT chosen(collisions_[rows.first().row()]);
}

}  // namespace forge
