#include "app/workbench/labs/frame/lab_table.h"

#include <QHeaderView>
#include <QProxyStyle>

#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

constexpr int kCellPad = 5;        // px on each side: a number at the right keeps off the words of the next column
constexpr int kMeasuredRows = 20;  // of long tables, for the widths of the columns

class RoomyCells : public QProxyStyle {
 public:
  RoomyCells() : QProxyStyle(QStringLiteral("Fusion")) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    const bool pad = metric == PM_FocusFrameHMargin || metric == PM_HeaderMargin;
    return pad ? kCellPad : QProxyStyle::pixelMetric(metric, option, widget);
  }
};

}  // namespace

QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent) {
  QTableView* const view = makeQuietTable(model, accessible_name, parent);
  QHeaderView* const head = view->horizontalHeader();
  auto* const roomy = new RoomyCells;
  roomy->setParent(view);
  for (QWidget* widget : {static_cast<QWidget*>(view), static_cast<QWidget*>(head)}) widget->setStyle(roomy);
  head->setResizeContentsPrecision(kMeasuredRows);
  head->setTextElideMode(Qt::ElideRight);
  head->setSectionResizeMode(QHeaderView::ResizeToContents);
  if (stretched >= 0) {
    head->setSectionResizeMode(stretched, QHeaderView::Stretch);
  } else {
    head->setStretchLastSection(true);
  }
  return view;
}

void sortByHeads(QTableView& view) {
  QHeaderView* const head = view.horizontalHeader();
  head->setSectionsClickable(true);
  head->setSortIndicatorClearable(true);
  head->setSortIndicator(-1, Qt::AscendingOrder);  // newer Qt reverses what is not sorted, too
  view.setSortingEnabled(true);
}

}  // namespace tactus::workbench
