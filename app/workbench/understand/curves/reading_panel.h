// The forces at the place that is read, one row for the mean and each expert. It is the legend of the curves as well.
#pragma once

#include "app/workbench/kit/card.h"

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
