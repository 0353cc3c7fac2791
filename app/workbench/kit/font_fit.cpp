#include "app/workbench/kit/font_fit.h"

#include <QEvent>
#include <QWidget>
#include <utility>

namespace tactus::workbench {
namespace {

class FontFit : public QObject {
 public:
  FontFit(QWidget& widget, std::function<void()> fit) : QObject(&widget), fit_(std::move(fit)) {
    widget.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FontChange) fit_();
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> fit_;
};

}  // namespace

void keepFitted(QWidget& widget, std::function<void()> fit) {
  fit();
  new FontFit(widget, std::move(fit));
}

}  // namespace tactus::workbench
