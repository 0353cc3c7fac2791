#include "app/workbench/views/history_panel.h"

#include <QListWidget>
#include <QVBoxLayout>

#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {

HistoryPanel::HistoryPanel(EditController& edits, QWidget* parent)
    : Card(parent), edits_(edits), entries_(new QListWidget(this)) {
  entries_->setFrameShape(QFrame::NoFrame);
  entries_->setWordWrap(true);
  entries_->setUniformItemSizes(false);
  entries_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  entries_->setAccessibleName(tr("Undo list"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, theme::kGrid, 4, theme::kGrid);
  layout->addWidget(entries_);

  connect(&edits_, &EditController::historyChanged, this, &HistoryPanel::list);
  connect(entries_, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { edits_.returnTo(item->data(Qt::UserRole).value<qulonglong>()); });
}

void HistoryPanel::showEvent(QShowEvent* event) {
  list();
  Card::showEvent(event);
}

void HistoryPanel::list() {
  if (!isVisible()) return;
  entries_->clear();
  bool undone = false;
  for (const EditController::Entry& entry : edits_.entries()) {
    auto* item =
        new QListWidgetItem(entry.effect.isEmpty() ? entry.label : entry.label + QLatin1Char('\n') + entry.effect);
    item->setData(Qt::UserRole, QVariant::fromValue<qulonglong>(entry.state));
    item->setToolTip(undone ? tr("Undone: a click brings it back") : tr("A click goes back to this state"));
    // What is undone stands muted below the present state.
    if (undone) item->setForeground(theme::mutedInk());
    entries_->addItem(item);
    if (entry.current) {
      entries_->setCurrentItem(item);
      undone = true;
    }
  }
  if (entries_->currentItem() != nullptr) entries_->scrollToItem(entries_->currentItem());
}

}  // namespace tactus::workbench
