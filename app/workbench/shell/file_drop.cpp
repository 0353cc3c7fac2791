#include "app/workbench/shell/file_drop.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QUrl>

#include "app/workbench/base/documents.h"
#include "app/workbench/model/open_model.h"

namespace tactus::workbench {
namespace {

// The one file that is dragged, a model, a study or a model of another program, or an empty path.
QString draggedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
  const QString path = urls.first().toLocalFile();
  const bool known =
      path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) || isStudyPath(path) || isImportPath(path);
  return known ? path : QString();
}

}  // namespace

FileDrop::FileDrop(QWidget& window) : QObject(&window), window_(window) {
  window_.setAcceptDrops(true);
  qApp->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
  const bool enters = event->type() == QEvent::DragEnter;
  if (!enters && event->type() != QEvent::Drop) return QObject::eventFilter(watched, event);
  auto& drag = static_cast<QDropEvent&>(*event);
  if (watched == &window_) return takes(drag);
  if (!enters || qobject_cast<QLineEdit*>(watched) == nullptr || draggedFile(*drag.mimeData()).isEmpty()) {
    return QObject::eventFilter(watched, event);
  }
  // The window is asked next.
  event->ignore();
  return true;
}

bool FileDrop::takes(QDropEvent& event) {
  const QString path = draggedFile(*event.mimeData());
  if (path.isEmpty()) return false;
  event.acceptProposedAction();
  if (event.type() == QEvent::Drop) {
    QMetaObject::invokeMethod(
        this, [this, path] { emit dropped(path); }, Qt::QueuedConnection);
  }
  return true;
}

}  // namespace tactus::workbench
