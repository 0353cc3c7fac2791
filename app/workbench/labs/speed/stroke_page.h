// The recordings of strokes with their marks: one level of the participants on the page, or all levels of one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "app/workbench/labs/speed/stroke_influence.h"
#include "app/workbench/labs/speed/stroke_traces.h"

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace tactus::workbench {

class Corrections;
class LabModel;
class SpeedLab;
class TraceRow;

class StrokePage : public Card {
  Q_OBJECT

 public:
  /// All outlive this.
  StrokePage(SpeedLab& lab, LabModel& model, Corrections& corrections, QWidget* parent = nullptr);

  /// Shows all levels of the participant, with this stroke chosen; at once, or as soon as the lab has them.
  void showStroke(const elicitation::StrokeKey& stroke);
  const StrokeInfluence& influence() const { return influence_; }

  const std::vector<TraceRow*>& rows() const { return rows_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

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
  void choose(const study::StrokeRecord& record);
  void followWanted();
  void followChosen();
  void correct(const study::StrokeRecord& before, const study::StrokeRecord& wanted, bool marks);

  SpeedLab& lab_;
  Corrections& corrections_;
  StrokeTraces traces_;
  StrokeInfluence influence_;
  std::optional<elicitation::StrokeKey> wanted_;  ///< to be shown as soon as the lab has its participant
  QComboBox* choice_;
  QLabel* moved_;
  QVBoxLayout* column_;
  std::vector<TraceRow*> rows_;
};

}  // namespace tactus::workbench
