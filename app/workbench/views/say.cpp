#include "app/workbench/views/say.h"

#include "app/workbench/views/main_window.h"
#include "app/workbench/views/message_banner.h"

namespace tactus::workbench {
namespace {

// A panel that was taken out of the window is a window of its own, below the main one all the same.
MainWindow* windowAround(QWidget& view) {
  for (QWidget* place = &view; place; place = place->parentWidget()) {
    if (auto* window = qobject_cast<MainWindow*>(place)) return window;
  }
  return nullptr;
}

}  // namespace

void sayError(QWidget& from, const QString& sentence) {
  if (MainWindow* window = windowAround(from)) window->banner().showError(sentence);
}

void sayDone(QWidget& from, const QString& sentence) {
  if (MainWindow* window = windowAround(from)) window->say(sentence);
}

}  // namespace tactus::workbench
