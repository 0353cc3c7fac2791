// The steps of the procedure. The step for the current depth is highlighted.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/feel/placement.h"
#include "app/workbench/feel/procedure.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class ElidedLabel;

// The placement in numbers: strokes and depth during it, and the summary of the last one.

class PlacementCard : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementCard(QWidget* parent = nullptr);

  void setProgress(unsigned strokes, double depth_mm, const QString& region);
  void setSummary(const std::optional<PlacementSummary>& summary);
  /// Whether a run is in progress, so that another placement can begin.
  void setRunning(bool running);

 signals:
  void newPlacementRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* progress_;
  ElidedLabel* summary_;
  QPushButton* next_;
  QGridLayout* layout_ = nullptr;
  bool below_ = false;
  bool has_summary_ = false;  ///< of a finished placement
};

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
