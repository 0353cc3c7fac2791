// The placement in numbers: strokes and depth during it, and the summary of the last one.
#pragma once

#include <QWidget>
#include <optional>

#include "app/workbench/feel/placement.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class ElidedLabel;

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

}  // namespace tactus::workbench
