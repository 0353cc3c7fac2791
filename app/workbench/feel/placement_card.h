// The placement in numbers: strokes and depth while it lasts, and what the last one came to.
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
  /// Whether another placement can be begun.
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
  bool has_summary_ = false;  ///< of a placement that has ended
};

}  // namespace tactus::workbench
