// The force lab on the screen: Table 2, the words by each method, and below them the judgements, their checks and the
// delivered forces.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/labs/force/judgement_grid.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/word_intervals.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSplitter;
class QTabWidget;

namespace tactus::workbench {

class ElidedLabel;

// The delivered against the commanded force of every judgement, in the colors of the participants.

/// A judgement with what was in the hand.
struct DeliveredForce {
  std::size_t participant = 0;  ///< index in the names
  double commanded_n = 0;
  std::optional<double> least_n;  ///< the least force in the hand while it was judged
  std::optional<double> felt_n;   ///< commanded force plus the friction of the device
};

struct DeliveredForces {
  std::vector<std::string> participants;
  std::vector<DeliveredForce> forces;  ///< those for which it is known
  std::size_t unknown = 0;             ///< judgements without a measured force
};

DeliveredForces deliveredForces(const std::vector<session::JudgedForce>& all);

class ChartView;

class DeliveredPlot : public QWidget {
  Q_OBJECT

 public:
  explicit DeliveredPlot(QWidget* parent = nullptr);

  void setForces(const DeliveredForces& forces);
  /// Adds `tool` beside the summary; it is there while there is something to draw.
  void addTool(QWidget* tool);

  ChartView& chart() { return *chart_; }

 private:
  ChartView* chart_;
  QLabel* summary_;
  QHBoxLayout* head_;
  QWidget* tool_ = nullptr;
};

// From the lowest to the highest force that each participant called by each word: a lane for each word, in it a line
// for each participant, and as a surface the share of these intervals at each force.

class WordIntervalPlot : public QWidget {
  Q_OBJECT

 public:
  explicit WordIntervalPlot(QWidget* parent = nullptr);

  /// `end_n`: where the axis of the force ends at least.
  void setIntervals(const fuzzy::Variable& words, const std::vector<elicitation::WordInterval>& intervals,
                    double end_n);
  /// Adds `tool` beside the summary; it is there while there is something to draw.
  void addTool(QWidget* tool);
  const QString& summary() const { return summary_text_; }
  ChartView& chart() { return *chart_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void nameAxes();
  void namePeople();

  ChartView* chart_;
  ElidedLabel* summary_;
  QHBoxLayout* people_;  ///< their names in their colors
  QHBoxLayout* head_;
  QString force_text_;
  QStringList words_;
  QString summary_text_;
  QWidget* tool_ = nullptr;
};

class ForceLab;
class ForceTermsView;
class JudgementView;
class SettingsPrice;
class VotesView;

class ForceLabView : public LabView {
  Q_OBJECT

 public:
  /// Both outlive this.
  ForceLabView(ForceLab& lab, const SettingsPrice& price, QWidget* parent = nullptr);

  VotesView& votes() { return *votes_; }
  ForceTermsView& terms() { return *terms_; }
  JudgementView& judgements() { return *judgements_; }
  WordIntervalPlot& intervals() { return *intervals_; }
  QTabWidget& details() { return *details_; }
  /// Chooses a judgement.
  void showJudgement(const std::string& participant, const std::string& series, double force_n);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void divide();
  void refreshState();
  void followSeries();

  ForceLab& lab_;
  const SettingsPrice& price_;
  VotesView* votes_;
  ForceTermsView* terms_;
  JudgementView* judgements_;
  Columns<ParticipantChecks>* checks_;
  DeliveredPlot* delivered_;
  WordIntervalPlot* intervals_;
  QTabWidget* details_;
  QComboBox* series_;
  QSplitter* top_;
  bool narrow_ = false;
};

}  // namespace tactus::workbench
