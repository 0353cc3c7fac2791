#include "app/workbench/views/panel_area.h"

#include <QAction>
#include <QDockWidget>
#include <QScrollArea>
#include <QSettings>
#include <algorithm>

#include "core/base/check.h"

namespace tactus::workbench {
namespace {

// Counts up when stored layouts no longer fit the panels, which then start in their first places.
constexpr int kLayoutVersion = 1;

// Docks overlap where the smallest sizes of their panels do not fit the window; a panel that can scroll has none.
QWidget* scrollable(QWidget* panel) {
  if (qobject_cast<QAbstractScrollArea*>(panel)) return panel;
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(panel);
  return area;
}

QString layoutKey(Stage stage) { return QStringLiteral("layout/") + stageId(stage); }

}  // namespace

PanelArea::PanelArea(QSettings& settings, QWidget* parent) : QMainWindow(parent), settings_(settings) {
  // A part of the window; the constructor has made it a window of its own.
  setWindowFlags(Qt::Widget);
  setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::GroupedDragging);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setContextMenuPolicy(Qt::NoContextMenu);
}

QDockWidget* PanelArea::addPanel(const QString& id, const QString& title, QWidget* panel) {
  TACTUS_CHECK(!docks_.contains(id));
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(id);
  dock->setWidget(scrollable(panel));
  addDockWidget(Qt::TopDockWidgetArea, dock);
  dock->hide();
  docks_.insert(id, dock);
  order_ << dock;
  return dock;
}

void PanelArea::addPlaces(Stage stage, const std::vector<PanelPlace>& places) {
  std::vector<PanelPlace>& all = places_[static_cast<int>(stage)];
  all.insert(all.end(), places.begin(), places.end());
}

void PanelArea::enter(Stage stage) {
  if (stage_ == stage) return;
  storeLayout();
  stage_ = stage;
  setUpdatesEnabled(false);
  const QByteArray stored = settings_.value(layoutKey(stage)).toByteArray();
  if (stored.isEmpty() || !restoreState(stored, kLayoutVersion)) resetLayout();
  setUpdatesEnabled(true);
}

void PanelArea::resetLayout() {
  if (!stage_) return;
  layOut(places_[static_cast<int>(*stage_)]);
}

void PanelArea::storeLayout() {
  if (stage_) settings_.setValue(layoutKey(*stage_), saveState(kLayoutVersion));
}

QList<QAction*> PanelArea::toggleActions() const {
  QList<QAction*> actions;
  for (const QDockWidget* dock : order_) actions << dock->toggleViewAction();
  return actions;
}

void PanelArea::layOut(const std::vector<PanelPlace>& places) {
  for (QDockWidget* panel : order_) {
    panel->setFloating(false);
    removeDockWidget(panel);
  }
  for (const PanelPlace& place : places) {
    QDockWidget* panel = dock(place.panel);
    QDockWidget* beside = dock(place.beside);
    TACTUS_CHECK(panel != nullptr && (beside != nullptr || place.how == PanelPlace::How::kFirst));
    switch (place.how) {
      case PanelPlace::How::kFirst:
        addDockWidget(Qt::TopDockWidgetArea, panel, Qt::Horizontal);
        break;
      case PanelPlace::How::kRight:
        splitDockWidget(beside, panel, Qt::Horizontal);
        break;
      case PanelPlace::How::kBelow:
        splitDockWidget(beside, panel, Qt::Vertical);
        break;
      case PanelPlace::How::kTab:
        tabifyDockWidget(beside, panel);
        break;
    }
    panel->show();
  }
  for (const PanelPlace& place : places) {
    if (place.how == PanelPlace::How::kTab) dock(place.beside)->raise();
  }
  shareRoom(places);
}

void PanelArea::shareRoom(const std::vector<PanelPlace>& places) {
  // Parts of parts: each split takes its share of what the panel beside it has at that point.
  QHash<QLatin1String, QSizeF> sizes;
  for (const PanelPlace& place : places) {
    if (place.how == PanelPlace::How::kFirst) sizes.insert(QLatin1String(place.panel), size());
    if (place.how == PanelPlace::How::kFirst || place.how == PanelPlace::How::kTab) continue;
    const QSizeF whole = sizes.value(QLatin1String(place.beside));
    const double share = place.percent / 100.0;
    const bool right = place.how == PanelPlace::How::kRight;
    const QSizeF part =
        right ? QSizeF(whole.width() * share, whole.height()) : QSizeF(whole.width(), whole.height() * share);
    const QSizeF rest = right ? QSizeF(whole.width() - part.width(), whole.height())
                              : QSizeF(whole.width(), whole.height() - part.height());
    sizes.insert(QLatin1String(place.panel), part);
    sizes.insert(QLatin1String(place.beside), rest);
    resizeDocks({dock(place.beside), dock(place.panel)},
                right ? QList<int>{qRound(rest.width()), qRound(part.width())}
                      : QList<int>{qRound(rest.height()), qRound(part.height())},
                right ? Qt::Horizontal : Qt::Vertical);
  }
}

}  // namespace tactus::workbench
