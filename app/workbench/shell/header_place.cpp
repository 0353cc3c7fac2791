#include "app/workbench/shell/header_place.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QMenuBar>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/shell/bench_view.h"
#include "app/workbench/shell/model_header.h"

namespace tactus::workbench {

HeaderPlace::HeaderPlace(QMenuBar& menus, BenchView& bench, QObject* parent)
    : QObject(parent), menus_(menus), bench_(bench) {
  menus_.installEventFilter(this);
}

void HeaderPlace::setLow(bool low) {
  low = low && !menus_.isNativeMenuBar();
  if (low == low_) return;
  low_ = low;
  ModelHeader& header = bench_.header();
  if (low) {
    header.setParent(&menus_);
    header.setVisible(shown_);
  } else {
    static_cast<QBoxLayout*>(bench_.layout())->insertWidget(0, &header);
    header.show();
    menus_.setMinimumHeight(0);
  }
  fit();
}

void HeaderPlace::setShown(bool shown) {
  shown_ = shown;
  if (low_) bench_.header().setVisible(shown);
  fit();
}

bool HeaderPlace::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::Resize || type == QEvent::LayoutRequest || type == QEvent::Show) fit();
  return QObject::eventFilter(watched, event);
}

void HeaderPlace::fit() {
  if (!low_) return;
  ModelHeader& header = bench_.header();
  menus_.setMinimumHeight(shown_ ? header.minimumSizeHint().height() : 0);
  int left = 0;
  for (const QAction* action : menus_.actions()) {
    left = std::max(left, menus_.actionGeometry(const_cast<QAction*>(action)).right());
  }
  left += 2 * theme::kGrid;
  header.setGeometry(left, 0, menus_.width() - left - theme::kGrid, menus_.height());
}

}  // namespace tactus::workbench
