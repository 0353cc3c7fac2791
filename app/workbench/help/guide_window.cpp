#include "app/workbench/help/guide_window.h"

#include <QDesktopServices>
#include <QKeyEvent>
#include <QListWidget>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/help/guide_pages.h"
#include "app/workbench/kit/layout.h"

namespace tactus::workbench {
namespace {

constexpr int kPictureWidth = 640;  // px, the most; the column is a little wider

}  // namespace

GuideBrowser::GuideBrowser(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  document()->setDocumentMargin(3 * theme::kGrid);
  connect(this, &QTextBrowser::anchorClicked, this, &GuideBrowser::follow);
}

void GuideBrowser::showPage(const QUrl& url) {
  setSource(url, QTextDocument::MarkdownResource);
  emit pageShown(url);
}

void GuideBrowser::follow(const QUrl& link) {
  const QUrl whole = source().resolved(link);
  if (const QUrl page = whole.adjusted(QUrl::RemoveFragment); isCarried(page)) {
    if (page != source()) showPage(page);
  } else if (whole.scheme().startsWith(QLatin1String("http"))) {
    QDesktopServices::openUrl(whole);
  }
}

QVariant GuideBrowser::loadResource(int type, const QUrl& url) {
  if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, url);
  const QPixmap picture(QLatin1Char(':') + source().resolved(url).path());
  if (picture.isNull()) return {};
  const qreal dots = devicePixelRatioF();
  const int width = std::min(qRound(kPictureWidth * dots), picture.width());
  QPixmap shown = picture.scaledToWidth(width, Qt::SmoothTransformation);
  shown.setDevicePixelRatio(dots);
  return shown;
}

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
  makeRow(this, {pages_, {browser_, 1}}, theme::kGrid, inset(theme::kGrid));
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
