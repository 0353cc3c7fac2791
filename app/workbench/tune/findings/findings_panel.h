// The panel of the lint's findings: largest force first, with filters and one-click fixes.
#pragma once

#include <QFrame>
#include <QStyledItemDelegate>
#include <memory>
#include <string>
#include <utility>

#include "app/workbench/kit/cards.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/findings/shown_finding.h"

class QComboBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QListView;
class QStackedWidget;
class QToolButton;

namespace tactus::workbench {

class ElidedLabel;
class FindingDelegate;
class FindingsController;
class RowStop;
class FindingsModel;

// Paints one row of the findings: sign and kind, the experts concerned, the newtons at stake, and the sentence in up to
// two lines.

/// The color of a finding: by the just-noticeable differences at stake, and by its group where they are not known.
QColor findingColor(const ShownFinding& shown);

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

// The chosen finding in full, its place, and one button for each fix.

class FixCard : public QFrame {
  Q_OBJECT

 public:
  explicit FixCard(FindingsController& findings, QWidget* parent = nullptr);
  ~FixCard() override;

 private:
  void showFinding();
  void showFixes();
  void showRules();

  FindingsController& findings_;
  QLabel* sentence_;
  QToolButton* here_;
  QToolButton* other_end_;
  QHBoxLayout* rules_;  ///< a button for each rule
  QLabel* note_;
  QWidget* fixes_;
  QGridLayout* grid_;
  std::unique_ptr<RowStop> places_stop_;  ///< the buttons that lead to a place or a rule
  std::unique_ptr<RowStop> fixes_stop_;
};

class FindingsPanel : public Card {
  Q_OBJECT

 public:
  explicit FindingsPanel(FindingsController& findings, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void adopt();
  void fillFilters();
  void showChosen();
  void showState();
  void fold(int row);
  QString stateText() const;
  QString emptyText() const;
  QString rangeText() const;

  FindingsController& findings_;
  FindingsModel model_;
  FindingDelegate* delegate_;
  QComboBox* kind_;
  QComboBox* who_;
  QComboBox* order_;
  ElidedLabel* state_;
  QListView* list_;
  QLabel* empty_;
  QStackedWidget* body_;
  ElidedLabel* range_;
};

}  // namespace tactus::workbench
