#include "app/workbench/kit/say.h"

#include <QWidget>
#include <utility>

namespace tactus::workbench {
namespace {

// A panel that was taken out of the window is a window of its own, below the main one all the same.
MessagePlace* placeAround(QWidget& view) {
  for (QWidget* widget = &view; widget; widget = widget->parentWidget()) {
    if (auto* place = dynamic_cast<MessagePlace*>(widget)) return place;
  }
  return nullptr;
}

}  // namespace

void sayError(QWidget& from, const QString& sentence, MessageAct act) {
  if (MessagePlace* place = placeAround(from)) place->showError(sentence, std::move(act), from);
}

void takeBackError(QWidget& from) {
  if (MessagePlace* place = placeAround(from)) place->takeBackError(from);
}

void sayDone(QWidget& from, const QString& sentence) {
  takeBackError(from);
  if (MessagePlace* place = placeAround(from)) place->say(sentence);
}

}  // namespace tactus::workbench
