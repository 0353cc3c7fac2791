// Paints one row of the findings: sign and kind, the experts concerned, the newtons at stake, and the sentence in up to
// two lines.
#pragma once

#include <QStyledItemDelegate>
#include <string>
#include <utility>

#include "app/workbench/tune/findings/shown_finding.h"

namespace tactus::workbench {

class FindingsModel;

/// Color of a group of findings.
QColor findingColor(FindingGroup group);

class FindingDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  FindingDelegate(const FindingsModel& model, QObject* parent);

  /// Whether the findings belong to an older model; they are then muted.
  void setOld(bool old) { old_ = old; }
  /// Unit of the output, as in the model.
  void setForceUnit(std::string unit) { force_unit_ = std::move(unit); }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, int row) const;

  const FindingsModel& model_;
  std::string force_unit_;
  bool old_ = false;
};

}  // namespace tactus::workbench
