// The recordings of strokes with their marks: one level of the participants on the page, or all levels of one.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "app/workbench/labs/speed/stroke_traces.h"

class QComboBox;
class QVBoxLayout;

namespace tactus::workbench {

class Corrections;
class SpeedLab;
class TraceRow;

class StrokePage : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  StrokePage(SpeedLab& lab, Corrections& corrections, QWidget* parent = nullptr);

  const std::vector<TraceRow*>& rows() const { return rows_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Cell {
    std::string participant;
    std::string level;
    QString title;
    std::size_t number;
  };
  std::vector<Cell> cells() const;
  void fillChoice();
  void follow();
  void putBack();
  void correct(const study::StrokeRecord& before, const study::StrokeRecord& wanted, bool marks);

  SpeedLab& lab_;
  Corrections& corrections_;
  StrokeTraces traces_;
  QComboBox* choice_;
  QVBoxLayout* column_;
  std::vector<TraceRow*> rows_;
};

}  // namespace tactus::workbench
