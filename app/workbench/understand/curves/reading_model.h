// The table beside the curves: the forces of the mean and of every expert at the reading place. A check mark shows or
// hides the line.
#pragma once

#include <string>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/model/scene_controller.h"

class QLabel;
class QTableView;

namespace tactus::workbench {

/// The mean or an expert, whether the line is visible.
struct ReadingRow {
  int index = 0;           ///< 0: the mean; i + 1: expert i
  std::string id;          ///< of the expert
  std::size_t number = 0;  ///< of the expert's color
  bool shown = true;
};

class ReadingModel : public Columns<ReadingRow> {
  Q_OBJECT

 public:
  enum { kWho, kForce };
  static constexpr int kMeanRow = 0;  ///< the row of expert i is i + 1

  explicit ReadingModel(const SceneController& scene, QObject* parent = nullptr);

  Qt::ItemFlags flags(const QModelIndex& index) const override {
    return Columns::flags(index) & ~Qt::ItemFlags(Qt::ItemIsSelectable | Qt::ItemNeverHasChildren);
  }
  /// Whether the line of `row` is visible.
  bool isShown(int index) const { return row(index).shown; }

 public slots:
  /// Makes the views read the forces again. Called by the visible view, so that hidden forces are never computed.
  void announceReading() { updateColumn(kForce); }

 signals:
  void rowShownChanged(int row, bool shown);

 private:
  void adoptModel();
  void show(int index, bool shown);
  const fuzzy::Evaluation& evaluation(const ReadingRow& one) const;
  QString nameOf(const ReadingRow& one) const;
  QString readingOf(const ReadingRow& one) const;

  const SceneController& scene_;
};

// The forces at the reading place, one row for the mean and each expert. It is also the legend of the curves.

class ReadingPanel : public Card {
  Q_OBJECT

 public:
  ReadingPanel(const SceneController& scene, ReadingModel& readings, QWidget* parent = nullptr);

 private:
  void showPlace();

  const SceneController& scene_;
  QLabel* place_;
  QTableView* table_;
  QLabel* hint_;
};

}  // namespace tactus::workbench
