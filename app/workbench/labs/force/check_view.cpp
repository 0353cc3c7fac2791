#include "app/workbench/labs/force/check_view.h"

#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/labs/frame/lab_table.h"

namespace tactus::workbench {
namespace {

/// What deserves attention stands on the color of a warning.
class NotableDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.data(CheckTable::kNotableRole).toBool()) return;
    option->backgroundBrush = theme::warningFill();
    option->palette.setColor(QPalette::Text, theme::warningInk());
  }
};

}  // namespace

CheckView::CheckView(QWidget* parent) : QWidget(parent), table_(new CheckTable(this)) {
  QTableView* const view = makeLabTable(*table_, -1, tr("Checks of the judgements"), this);
  view->setItemDelegate(new NotableDelegate(view));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->addWidget(view);
}

}  // namespace tactus::workbench
