// The first tab of stage Build: a card for each part of the model, the one with the most newtons first; or what is
// missing.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/overview/build_overview.h"

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace tactus::workbench {

class OverviewView : public QWidget {
  Q_OBJECT

 public:
  explicit OverviewView(BuildOverview& overview, QWidget* parent = nullptr);

 signals:
  /// The lab of this part.
  void labAsked(tactus::workbench::BuildPart::Kind kind);
  // What brings the answers that are missing.
  void sessionAsked();
  void tablesAsked();
  void fillAsked();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showState();
  QWidget* makeCard(const BuildPart& part, double largest_n);

  BuildOverview& overview_;
  QLabel* lead_;
  QScrollArea* scroll_;
  QVBoxLayout* cards_;
  QWidget* empty_;
  QLabel* why_;
};

}  // namespace tactus::workbench
