#include "app/workbench/labs/frame/lab_table.h"

#include <QHeaderView>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kMeasuredRows = 20;  // of long tables, for the widths of the columns

}  // namespace

QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent) {
  auto* view = new QTableView(parent);
  view->setModel(&model);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setTabKeyNavigation(false);
  view->setShowGrid(false);
  view->setFrameShape(QFrame::NoFrame);
  view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view->setAccessibleName(accessible_name);
  view->verticalHeader()->hide();
  QHeaderView* const head = view->horizontalHeader();
  head->setFont(theme::smallFont());
  head->setHighlightSections(false);
  head->setSectionsClickable(false);
  head->setResizeContentsPrecision(kMeasuredRows);
  head->setSectionResizeMode(QHeaderView::ResizeToContents);
  if (stretched >= 0) {
    head->setSectionResizeMode(stretched, QHeaderView::Stretch);
  } else {
    head->setStretchLastSection(true);
  }
  return view;
}

}  // namespace tactus::workbench
