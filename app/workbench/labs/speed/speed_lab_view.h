// The speed lab on the screen: settings at the left; recordings, clusters and terms, numbers behind tabs.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "elicitation/tracing/sources.h"

class QComboBox;
class QLabel;
class QTabWidget;
class QToolButton;
class QVBoxLayout;

namespace tactus::workbench {

class Corrections;
class LabModel;
class SettingRow;
class SettingsPrice;
class SpeedLab;
class SpeedTermPlot;
class TraceRow;

// The recordings of strokes with their marks: one level of the participants on the page, or all levels of one.

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
  void refreshState();
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

// The settings of the speed lab: clusters, fuzziness, membership at the ramps' ends, trimming, centers, averaging.

class SpeedSettingsPanel : public Card {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit SpeedSettingsPanel(SpeedLab& lab, QWidget* parent = nullptr);

 private:
  void refreshState();

  SpeedLab& lab_;
  SettingRow* clusters_;
  SettingRow* fuzziness_;
  SettingRow* alpha_;
  SettingRow* trim_;
  QComboBox* centres_;
  QComboBox* averaging_;
  QLabel* note_;
};

class SpeedLabView : public LabView {
  Q_OBJECT

 public:
  /// All outlive this.
  SpeedLabView(SpeedLab& lab, LabModel& model, Corrections& corrections, const SettingsPrice& price,
               QWidget* parent = nullptr);

  /// Turns to the strokes, with this one chosen.
  void showStroke(const elicitation::StrokeKey& stroke);
  SpeedTermPlot& terms() { return *terms_; }

  /// The pages, for pictures of them.
  QTabWidget& pages() { return *pages_; }
  StrokePage& strokes() { return *strokes_; }

 private:
  QWidget* makePager();
  void refreshState();

  SpeedLab& lab_;
  SpeedTermPlot* terms_;
  StrokePage* strokes_;
  QTabWidget* pages_;
  QToolButton* back_;
  QToolButton* on_;
  QLabel* place_;
  QLabel* nothing_;
};

}  // namespace tactus::workbench
