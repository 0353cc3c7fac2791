// The ways from the judgements to the words of the force, side by side: what each gives, and which one the model uses.
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/plot/chart.h"

class QHBoxLayout;
class QLabel;
class QRadioButton;

namespace tactus::workbench {

class VertexPick;

// The words of the force from one method, drawn over the shares of the answers that they come from (Fig. 3e).

class ForceTermsPlot : public ChartView {
  Q_OBJECT

 public:
  explicit ForceTermsPlot(QWidget* parent = nullptr);

  /// `words` gives the colors; `votes` the shares; the axis ends at `end_n`. `former`: the words of the model before
  /// the last change of the settings, dashed; empty: none.
  void setTerms(const fuzzy::Variable& words, const std::vector<fuzzy::Term>& terms,
                const std::vector<elicitation::VoteStep>& votes, double end_n, const std::vector<fuzzy::Term>& former);

  /// Words of before are drawn: some are others.
  bool hasGhosts() const { return has_ghosts_; }
  VertexPick& corners() { return *corners_; }

 signals:
  /// The user clicked a corner of a word.
  void vertexAsked(const std::string& term, std::size_t point);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// As many ticks, and as much of the text, as there is room for.
  void fitAxis();

  VertexPick* corners_;
  bool has_ghosts_ = false;
  QString axis_text_;
  QString axis_unit_;
};

class ForceTermsView : public QWidget {
  Q_OBJECT

 public:
  explicit ForceTermsView(QWidget* parent = nullptr);

  /// `chosen`: the method of the model. `former`: its words before the last change of the settings; empty: unchanged.
  void setVotes(const ForceVotes& votes, elicitation::ForceTermsFrom chosen, const std::vector<fuzzy::Term>& former);
  /// What a method would do to the force; empty: not known, or it is the method of the model.
  void setEffect(elicitation::ForceTermsFrom from, const QString& effect);
  ForceTermsPlot& plot(elicitation::ForceTermsFrom from);
  /// Adds `tool` beside the name of a method.
  void addTool(elicitation::ForceTermsFrom from, QWidget* tool);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 signals:
  void chosen(tactus::elicitation::ForceTermsFrom from);
  /// The user clicked a corner of a word of the model's method.
  void vertexAsked(const std::string& term, std::size_t point);

 private:
  struct Column {
    QHBoxLayout* head = nullptr;
    QRadioButton* choice = nullptr;
    QLabel* effect = nullptr;
    QLabel* rule = nullptr;
    ForceTermsPlot* plot = nullptr;
    QLabel* corners = nullptr;
    std::vector<fuzzy::Term> terms;
  };
  QWidget* makeMethodColumn(std::size_t index);
  Column& columnOf(elicitation::ForceTermsFrom from);
  void tellCorners(const Column& column);
  void fitTexts();

  std::array<Column, kForceMethods.size()> columns_;
};

}  // namespace tactus::workbench
