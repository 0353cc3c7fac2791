#include "app/workbench/shell/panel_area.h"

#include <QAction>
#include <QCloseEvent>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QMenu>
#include <QPainter>
#include <QScrollArea>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "core/base/check.h"

namespace tactus::workbench {

void Panel::reveal() {
  show();
  raise();
}

void Panel::closeEvent(QCloseEvent* event) {
  QDockWidget::closeEvent(event);
  emit closed();
}

// Out of the window it is a window of its own.
bool Panel::focusNextPrevChild(bool next) {
  return isWindow() ? focusNextAsRead(*this, next) : QDockWidget::focusNextPrevChild(next);
}

namespace {

constexpr int kHeight = 22;  // px
constexpr int kButton = 18;

// A small button with a sign of lines, in the color of secondary text: no font has to have it.
class TitleButton : public QToolButton {
 public:
  enum class Sign { kFloat, kClose };

  TitleButton(Sign sign, QWidget* parent) : QToolButton(parent), sign_(sign) {
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setFixedSize(kButton, kButton);
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(underMouse() || hasFocus() ? theme::ink() : theme::mutedInk(), 1.2));
    if (sign_ == Sign::kClose) {
      painter.drawLine(QPointF(5.5, 5.5), QPointF(12.5, 12.5));
      painter.drawLine(QPointF(12.5, 5.5), QPointF(5.5, 12.5));
    } else {
      painter.drawRect(QRectF(5, 7, 6, 6));
      painter.drawPolyline(QPolygonF{{7.5, 7}, {7.5, 4.5}, {13.5, 4.5}, {13.5, 10.5}, {11, 10.5}});
    }
  }

 private:
  Sign sign_;
};

}  // namespace

PanelTitle::PanelTitle(QDockWidget& panel)
    : QWidget(&panel),
      panel_(panel),
      name_(new ElidedLabel(this)),
      float_(new TitleButton(TitleButton::Sign::kFloat, this)),
      close_(new TitleButton(TitleButton::Sign::kClose, this)) {
  QFont font = theme::smallFont();
  font.setWeight(QFont::DemiBold);
  name_->setFont(font);
  name_->setForegroundRole(QPalette::PlaceholderText);
  name_->setFullText(panel.windowTitle());
  close_->setToolTip(tr("Close this panel; View ▸ Panels brings it back"));
  close_->setAccessibleName(tr("Close %1").arg(panel.windowTitle()));
  makeRow(this, {{name_, 1}, float_, close_}, 2, {4, 0, 0, 0});
  showFloating(panel.isFloating());
  connect(&panel_, &QDockWidget::topLevelChanged, this, &PanelTitle::showFloating);
  connect(&panel_, &QDockWidget::windowTitleChanged, this, [this](const QString& title) { name_->setFullText(title); });
  connect(float_, &QToolButton::clicked, this, [this] { panel_.setFloating(!panel_.isFloating()); });
  connect(close_, &QToolButton::clicked, &panel_, &QDockWidget::close);
}

void PanelTitle::setTabbed(bool tabbed) {
  if (tabbed == tabbed_) return;
  tabbed_ = tabbed;
  for (QWidget* part : {static_cast<QWidget*>(name_), static_cast<QWidget*>(float_), static_cast<QWidget*>(close_)}) {
    part->setVisible(!tabbed);
  }
  updateGeometry();
}

QSize PanelTitle::sizeHint() const { return {0, tabbed_ ? 0 : kHeight}; }

void PanelTitle::contextMenuEvent(QContextMenuEvent* event) { emit menuRequested(event->globalPos()); }

void PanelTitle::showFloating(bool floating) {
  const QString name = panel_.windowTitle();
  float_->setToolTip(floating ? tr("Put back into the window") : tr("Take out of the window"));
  float_->setAccessibleName(floating ? tr("Put %1 back into the window").arg(name)
                                     : tr("Take %1 out of the window").arg(name));
}

namespace {

// Counts up when stored layouts no longer fit the panels, which then start in their first places.
constexpr int kLayoutVersion = 3;

// Docks overlap where the smallest sizes of their panels do not fit the window; a panel that can scroll has none.
QWidget* scrollable(QWidget* panel) {
  if (qobject_cast<QAbstractScrollArea*>(panel)) return panel;
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(panel);
  return area;
}

// What a dock holds. The panel in it is hidden while a tab stands before it; the holder never is, because a dock with
// hidden content may not have any size.
QWidget* holderOf(QWidget* panel) {
  auto* holder = new QWidget;
  makeColumn(holder, {panel});
  return holder;
}

void setSeen(const QDockWidget& dock, bool seen) { dock.widget()->layout()->itemAt(0)->widget()->setVisible(seen); }

QString tightId(const QString& id) { return id + QLatin1String("-tight"); }
QString layoutKey(const QString& id) { return QStringLiteral("layout/") + id; }
QString panelsKey(const QString& id) { return QStringLiteral("layout_panels/") + id; }

}  // namespace

PanelArea::PanelArea(QSettings& settings, QWidget* parent) : QMainWindow(parent), settings_(settings) {
  // A part of the window; the constructor has made it a window of its own.
  setWindowFlags(Qt::Widget);
  setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::GroupedDragging);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setContextMenuPolicy(Qt::NoContextMenu);
  titles_.setSingleShot(true);
  titles_.setInterval(0);
  connect(&titles_, &QTimer::timeout, this, &PanelArea::showTitles);
}

// The panels end after this, and are hidden then.
PanelArea::~PanelArea() {
  for (Panel* panel : panels_) disconnect(panel, nullptr, this, nullptr);
}

Panel& PanelArea::addPanel(const QString& id, const QString& title, QWidget* content) {
  TACTUS_CHECK(!panelNames().contains(id));
  auto* dock = new Panel(title, this);
  dock->setObjectName(id);
  dock->setWidget(holderOf(scrollable(content)));
  for (QScrollArea* area : dock->findChildren<QScrollArea*>()) {
    if (area->accessibleName().isEmpty()) area->setAccessibleName(title);
  }
  auto* head = new PanelTitle(*dock);
  dock->setTitleBarWidget(head);
  addDockWidget(Qt::TopDockWidgetArea, dock);
  dock->hide();
  panels_ << dock;
  const auto titles_change = [this] { titles_.start(); };
  connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
    // QMainWindow keeps a panel behind a tab visible to itself; it would continue computing out of sight.
    setSeen(*dock, visible);
    titles_.start();
  });
  connect(dock, &QDockWidget::topLevelChanged, this, titles_change);
  connect(dock, &QDockWidget::dockLocationChanged, this, titles_change);
  connect(head, &PanelTitle::menuRequested, this, [this, dock](const QPoint& place) { showMenu(*dock, place); });
  return *dock;
}

void PanelArea::setLayout(const QString& id, std::vector<PanelPlace> places, std::vector<PanelPlace> tight) {
  places_.insert(id, std::move(places));
  if (!tight.empty()) places_.insert(tightId(id), std::move(tight));
}

QString PanelArea::shownId() const {
  const QString tight = tightId(layout_);
  return tight_ && places_.contains(tight) ? tight : layout_;
}

void PanelArea::setTight(bool tight) {
  if (tight == tight_) return;
  storeLayout();
  tight_ = tight;
  if (places_.contains(tightId(layout_))) showLayout();
}

void PanelArea::enter(Stage stage) {
  stage_ = stage;
  enterLayout(stageId(stage));
}

void PanelArea::enterLayout(const QString& id) {
  if (layout_ == id) return;
  storeLayout();
  layout_ = id;
  showLayout();
}

void PanelArea::showLayout() {
  setUpdatesEnabled(false);
  if (!restore(layoutKey(shownId()), panelsKey(shownId()))) resetLayout();
  setUpdatesEnabled(true);
}

// A layout from before a panel existed has no place for it.
bool PanelArea::restore(const QString& key, const QString& panels_key) {
  const QByteArray stored = settings_.value(key).toByteArray();
  const bool known = settings_.value(panels_key).toStringList() == panelNames();
  return !stored.isEmpty() && known && restoreState(stored, kLayoutVersion);
}

void PanelArea::store(const QString& key, const QString& panels_key) {
  settings_.setValue(key, saveState(kLayoutVersion));
  settings_.setValue(panels_key, panelNames());
}

void PanelArea::resetLayout() {
  if (!layout_.isEmpty()) layOut(places_.value(shownId()));
}

void PanelArea::storeLayout() {
  if (!layout_.isEmpty()) store(layoutKey(shownId()), panelsKey(shownId()));
}

QStringList PanelArea::panelNames() const {
  QStringList names;
  for (const Panel* panel : panels_) names << panel->objectName();
  names.sort();
  return names;
}

QList<QAction*> PanelArea::toggleActions() const {
  QList<QAction*> actions;
  for (const Panel* panel : panels_) actions << panel->toggleViewAction();
  return actions;
}

void PanelArea::layOut(const std::vector<PanelPlace>& places) {
  for (Panel* panel : panels_) {
    panel->setFloating(false);
    removeDockWidget(panel);
  }
  // Tabs last: beside a panel with tabs nothing can be put.
  std::vector<PanelPlace> ordered = places;
  std::stable_partition(ordered.begin(), ordered.end(),
                        [](const PanelPlace& place) { return place.how != PanelPlace::How::kTab; });
  for (const PanelPlace& place : ordered) put(place);
  for (const PanelPlace& place : places) {
    if (place.how == PanelPlace::How::kTab) place.beside->raise();
  }
  shareRoom(places);
  // A panel that the layout does not know would be shown by restoring it.
  for (Panel* panel : panels_) {
    if (dockWidgetArea(panel) != Qt::NoDockWidgetArea) continue;
    addDockWidget(Qt::TopDockWidgetArea, panel);
    panel->hide();
  }
}

void PanelArea::put(const PanelPlace& place) {
  switch (place.how) {
    case PanelPlace::How::kFirst: addDockWidget(Qt::TopDockWidgetArea, place.panel, Qt::Horizontal); break;
    case PanelPlace::How::kRight: splitDockWidget(place.beside, place.panel, Qt::Horizontal); break;
    case PanelPlace::How::kBelow: splitDockWidget(place.beside, place.panel, Qt::Vertical); break;
    case PanelPlace::How::kTab: tabifyDockWidget(place.beside, place.panel); break;
  }
  place.panel->show();
}

void PanelArea::shareRoom(const std::vector<PanelPlace>& places) {
  // Parts of parts: each split takes its share of what the panel beside it has at that point.
  QHash<const Panel*, QSizeF> sizes;
  for (const PanelPlace& place : places) {
    if (place.how == PanelPlace::How::kFirst) sizes.insert(place.panel, size());
    if (place.how == PanelPlace::How::kFirst || place.how == PanelPlace::How::kTab) continue;
    const QSizeF whole = sizes.value(place.beside);
    const double share = place.percent / 100.0;
    const bool right = place.how == PanelPlace::How::kRight;
    const QSizeF part =
        right ? QSizeF(whole.width() * share, whole.height()) : QSizeF(whole.width(), whole.height() * share);
    const QSizeF rest = right ? QSizeF(whole.width() - part.width(), whole.height())
                              : QSizeF(whole.width(), whole.height() - part.height());
    sizes.insert(place.panel, part);
    sizes.insert(place.beside, rest);
    resizeDocks({place.beside, place.panel},
                right ? QList<int>{qRound(rest.width()), qRound(part.width())}
                      : QList<int>{qRound(rest.height()), qRound(part.height())},
                right ? Qt::Horizontal : Qt::Vertical);
  }
}

void PanelArea::showTitles() {
  for (Panel* panel : panels_) {
    const QList<QDockWidget*> others = tabifiedDockWidgets(panel);
    const bool tabbed = !panel->isFloating() && std::any_of(others.begin(), others.end(), [](const QDockWidget* other) {
      return !other->isHidden() && !other->isFloating();
    });
    static_cast<PanelTitle*>(panel->titleBarWidget())->setTabbed(tabbed);
    setSeen(*panel, !tabbed || !isBehind(*panel));
  }
  // The window makes its tab bars itself, when panels come to share a place.
  for (QTabBar* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (tabs->contextMenuPolicy() == Qt::CustomContextMenu) continue;
    tabs->setContextMenuPolicy(Qt::CustomContextMenu);
    tabs->setFont(theme::smallFont());
    new TabLook(*tabs);
    tabs->setAccessibleName(tr("Panels that share a place"));
    connect(tabs, &QWidget::customContextMenuRequested, this, [this, tabs](const QPoint& place) {
      if (Panel* panel = panelOfTab(*tabs, tabs->tabAt(place))) showMenu(*panel, tabs->mapToGlobal(place));
    });
    connect(tabs, &QTabBar::tabBarDoubleClicked, this, [this, tabs](int index) {
      if (Panel* panel = panelOfTab(*tabs, index)) panel->setFloating(true);
    });
  }
}

bool PanelArea::isBehind(const Panel& panel) const {
  for (const QTabBar* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i) {
      if (panelOfTab(*tabs, i) == &panel) return i != tabs->currentIndex();
    }
  }
  return false;
}

// QMainWindow keeps the address of the dock widget with the tab.
Panel* PanelArea::panelOfTab(const QTabBar& tabs, int index) const {
  const auto address = tabs.tabData(index).value<quintptr>();
  const auto found = std::find_if(panels_.begin(), panels_.end(),
                                  [&](const Panel* panel) { return reinterpret_cast<quintptr>(panel) == address; });
  return found == panels_.end() ? nullptr : *found;
}

void PanelArea::showMenu(Panel& panel, const QPoint& place) {
  QMenu menu;
  const bool floating = panel.isFloating();
  menu.addAction(floating ? tr("Put back into the window") : tr("Take out of the window"), &panel,
                 [&panel, floating] { panel.setFloating(!floating); });
  menu.addAction(tr("Close %1").arg(panel.windowTitle()), &panel, &QDockWidget::close);
  menu.addSeparator();
  menu.addAction(tr("Reset layout"), this, &PanelArea::resetLayout);
  menu.exec(place);
}

}  // namespace tactus::workbench
