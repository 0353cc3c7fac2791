// The table beside the curves: the forces of the mean and of every expert at the reading place. A check mark shows or
// hides the line.
#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "app/workbench/model/scene_controller.h"

class QLabel;
class QTableView;

namespace tactus::workbench {

class ReadingModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kWho, kForce, kColumnCount };
  static constexpr int kMeanRow = 0;  ///< the row of expert i is i + 1

  explicit ReadingModel(const SceneController& scene, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Whether the line of `row` is visible.
  bool isShown(int row) const { return shown_[static_cast<std::size_t>(row)]; }

 public slots:
  /// Makes the views read the forces again. Called by the visible view, so that hidden forces are never computed.
  void announceReading();

 signals:
  void rowShownChanged(int row, bool shown);

 private:
  void adoptModel();
  const fuzzy::Evaluation& evaluation(int row) const;
  QString nameOf(int row) const;
  QString readingOf(int row) const;

  const SceneController& scene_;
  std::vector<bool> shown_;
  std::vector<std::string> ids_;      ///< ids of the experts
  std::vector<std::size_t> numbers_;  ///< of the experts, for their colors
};

// The forces at the reading place, one row for the mean and each expert. It is also the legend of the curves.

class ReadingModel;
class SceneController;

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
