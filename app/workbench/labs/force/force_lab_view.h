// The force lab on the screen: Table 2, the words by each method, and below them the judgements, their checks and the
// delivered forces.
#pragma once

#include <QWidget>
#include <string>

class QComboBox;
class QSplitter;
class QTabWidget;

namespace tactus::workbench {

class CheckView;
class DeliveredPlot;
class ForceLab;
class ForceTermsView;
class JudgementView;
class VotesView;

class ForceLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit ForceLabView(ForceLab& lab, QWidget* parent = nullptr);

  VotesView& votes() { return *votes_; }
  ForceTermsView& terms() { return *terms_; }
  JudgementView& judgements() { return *judgements_; }
  QTabWidget& details() { return *details_; }
  /// Chooses a judgement.
  void showJudgement(const std::string& participant, const std::string& series, double force_n);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void divide();
  void follow();
  void followSeries();

  ForceLab& lab_;
  VotesView* votes_;
  ForceTermsView* terms_;
  JudgementView* judgements_;
  CheckView* checks_;
  DeliveredPlot* delivered_;
  QTabWidget* details_;
  QComboBox* series_;
  QSplitter* top_;
  bool narrow_ = false;
};

}  // namespace tactus::workbench
