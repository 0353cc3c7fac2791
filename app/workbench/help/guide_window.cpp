#include "app/workbench/help/guide_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QSignalBlocker>

#include "app/workbench/base/theme.h"
#include "app/workbench/help/guide_browser.h"
#include "app/workbench/help/guide_pages.h"

namespace tactus::workbench {

GuideWindow::GuideWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), pages_(new QListWidget(this)), browser_(new GuideBrowser(this)) {
  setWindowTitle(tr("Guide"));
  pages_->setAccessibleName(tr("Pages of the guide"));
  pages_->setFrameShape(QFrame::NoFrame);
  pages_->setWordWrap(true);
  pages_->setFixedWidth(28 * theme::kGrid);
  pages_->setSpacing(theme::kGrid / 4);
  for (const GuidePage& page : guidePages()) {
    auto* item = new QListWidgetItem(page.title, pages_);
    item->setData(Qt::UserRole, page.url);
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(pages_);
  layout->addWidget(browser_, 1);
  resize(980, 640);
  connect(pages_, &QListWidget::currentRowChanged, this,
          [this](int row) { browser_->showPage(pages_->item(row)->data(Qt::UserRole).toUrl()); });
  connect(browser_, &GuideBrowser::pageShown, this, [this](const QUrl& url) {
    const QSignalBlocker no_signal(pages_);
    for (int row = 0; row < pages_->count(); ++row) {
      if (pages_->item(row)->data(Qt::UserRole).toUrl() == url) pages_->setCurrentRow(row);
    }
  });
  pages_->setCurrentRow(0);
}

void GuideWindow::open() {
  show();
  raise();
  activateWindow();
}

void GuideWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape || event->matches(QKeySequence::Close)) {
    close();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench
