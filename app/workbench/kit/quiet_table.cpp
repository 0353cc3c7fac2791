#include "app/workbench/kit/quiet_table.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyle>
#include <QStyledItemDelegate>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kLeastWrapped = 9;  // letters: a narrower cell ends in an ellipsis, or its row would be a tower

class RoomyRows : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index) + QSize(0, theme::kGrid);
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (option->rect.width() < kLeastWrapped * option->fontMetrics.averageCharWidth())
      option->features.setFlag(QStyleOptionViewItem::WrapText, false);
  }
};

}  // namespace

QTableView* makeQuietTable(QAbstractItemModel& model, const QString& accessible_name, QWidget* parent) {
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
  // Beyond the last head the table has the color of its cells.
  for (QHeaderView* header : {head, view->verticalHeader()}) {
    QPalette colors = header->palette();
    colors.setColor(QPalette::Window, theme::card());
    header->setPalette(colors);
  }
  head->setFont(theme::smallFont());
  head->setHighlightSections(false);
  head->setSectionsClickable(false);
  return view;
}

void readWhole(QTableView& view) {
  view.setWordWrap(true);
  view.setItemDelegate(new RoomyRows(&view));
  view.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
  option.widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, &painter, option.widget);
}

}  // namespace tactus::workbench
