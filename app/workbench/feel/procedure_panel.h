// The steps of the procedure. The step for the current depth is highlighted.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/feel/procedure.h"

class QLabel;

namespace tactus::workbench {

class ElidedLabel;

class ProcedurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProcedurePanel(std::vector<ProcedureStep> steps, QWidget* parent = nullptr);

  /// Depth of the tip, mm.
  void setDepth(double depth_mm);
  enum class Room {
    kList,     ///< all steps, and the text of the current one
    kStep,     ///< the current step and its text
    kHeading,  ///< the name of the current step
  };
  void setRoom(Room room);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    QLabel* number;
    QLabel* title;
  };
  void show(std::size_t step);
  void fitText();

  std::vector<ProcedureStep> steps_;
  std::vector<Row> rows_;
  QWidget* list_;
  ElidedLabel* head_;  ///< the current step, if the list is hidden
  QLabel* text_;
  std::optional<std::size_t> shown_;
  int lines_ = 0;  ///< that the text has room for
};

}  // namespace tactus::workbench
