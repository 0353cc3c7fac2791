// The forces at the reading place, one row for the mean and each expert. It is also the legend of the curves.
#pragma once

#include "app/workbench/kit/cards.h"

class QLabel;
class QTableView;

namespace tactus::workbench {

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
