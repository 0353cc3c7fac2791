#include "app/workbench/help/guide_browser.h"

#include <QDesktopServices>
#include <QPixmap>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/help/guide_pages.h"

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

}  // namespace tactus::workbench
