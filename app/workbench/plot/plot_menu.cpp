#include "app/workbench/plot/plot_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QCursor>
#include <QDockWidget>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QPainterPath>
#include <QPointer>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/say.h"
#include "app/workbench/plot/picture_export.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

constexpr int kGlyph = 16;  // px

// An arrow into a tray.
QPainterPath glyph() {
  QPainterPath path;
  path.moveTo(2.5, 9.5);
  path.lineTo(2.5, 13.5);
  path.lineTo(13.5, 13.5);
  path.lineTo(13.5, 9.5);
  path.moveTo(8, 2);
  path.lineTo(8, 10);
  path.moveTo(4.8, 6.8);
  path.lineTo(8, 10);
  path.lineTo(11.2, 6.8);
  return path;
}

}  // namespace

PlotMenu::PlotMenu(PlotSource& plot, std::function<PlotTable()> table, QWidget* parent)
    : QToolButton(parent), plot_(plot), table_(std::move(table)) {
  setToolTip(tr("Copy or save this plot, as a picture or as a table"));
  setAccessibleName(tr("Copy or save this plot"));
  setAutoRaise(true);
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(this);
  menu->addAction(tr("&Copy picture"), this, &PlotMenu::copyPicture);
  menu->addAction(tr("Copy &table"), this, &PlotMenu::copyTable);
  menu->addSeparator();
  menu->addAction(tr("Save &picture…"), this, &PlotMenu::choosePicture);
  menu->addAction(tr("&Save table…"), this, &PlotMenu::chooseTable);
  setMenu(menu);
}

base::Result<void> PlotMenu::savePicture(const QString& path) {
  return workbench::savePicture(plot_, table_().caption, path);
}

base::Result<void> PlotMenu::saveTable(const QString& path) {
  return base::writeFileAtomically(path.toStdString(), csvText(table_()));
}

void PlotMenu::copyPicture() {
  const PlotTable table = table_();
  QApplication::clipboard()->setImage(pictureOf(plot_, table.caption));
  sayDone(*this, tr("Picture copied: %1").arg(table.caption.value(0)));
}

void PlotMenu::copyTable() {
  const PlotTable table = table_();
  auto* mime = new QMimeData;
  mime->setText(workbench::text(tabText(table)));
  mime->setData(QStringLiteral("text/csv"), QByteArray::fromStdString(csvText(table)));
  QApplication::clipboard()->setMimeData(mime);
  sayDone(*this, tr("Table copied: %1").arg(table.caption.value(0)));
}

void PlotMenu::choosePicture() {
  QString filter;
  QString path = file_dialog::getSaveFileName(
      this, tr("Save the picture"), table_().file,
      tr("Picture for the screen (*.png);;Drawing for a web page (*.svg);;Drawing for print (*.pdf)"), &filter);
  if (path.isEmpty()) return;
  // The filter names one ending: `… (*.svg)`.
  if (QFileInfo(path).suffix().isEmpty()) path += filter.section(QLatin1Char('*'), 1).remove(QLatin1Char(')'));
  tell(savePicture(path), path, &PlotMenu::choosePicture);
}

void PlotMenu::chooseTable() {
  QString path = file_dialog::getSaveFileName(this, tr("Save the table"), table_().file + QStringLiteral(".csv"),
                                              tr("Tables (*.csv)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".csv");
  tell(saveTable(path), path, &PlotMenu::chooseTable);
}

void PlotMenu::tell(const base::Result<void>& saved, const QString& path, void (PlotMenu::*again)()) {
  if (saved) {
    sayDone(*this, tr("Saved: %1").arg(path));
  } else {
    sayError(*this, tr("%1 was not saved. %2").arg(shownFileName(path), workbench::text(saved.error().message())),
             {tr("Save elsewhere…"), [menu = QPointer(this), again] {
                if (menu) (menu->*again)();
              }});
  }
}

QSize PlotMenu::sizeHint() const {
  const int side = kGlyph + theme::kGrid;
  return {side, side};
}

void PlotMenu::paintEvent(QPaintEvent* /*event*/) {
  QStylePainter painter(this);
  QStyleOptionToolButton option;
  initStyleOption(&option);
  // The glyph says what the button does; the arrow of a menu would leave it no room.
  option.features = QStyleOptionToolButton::None;
  option.text.clear();
  option.icon = {};
  painter.drawComplexControl(QStyle::CC_ToolButton, option);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate((width() - kGlyph) / 2, (height() - kGlyph) / 2);
  painter.setPen(QPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText), 1.4,
                      Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(glyph());
}

PlotMenu* currentPlot(QWidget& window) {
  const auto visible_in = [](QWidget* place) -> PlotMenu* {
    if (!place) return nullptr;
    const QList<PlotMenu*> all = place->findChildren<PlotMenu*>();
    const auto found = std::find_if(all.begin(), all.end(), [](const PlotMenu* menu) { return menu->isVisible(); });
    return found == all.end() ? nullptr : *found;
  };
  const auto around = [&](QWidget* place) -> PlotMenu* {
    for (; place; place = place->parentWidget()) {
      if (PlotMenu* menu = visible_in(place)) return menu;
      if (qobject_cast<QDockWidget*>(place)) break;
    }
    return nullptr;
  };
  if (PlotMenu* menu = around(QApplication::focusWidget())) return menu;
  if (PlotMenu* menu = around(QApplication::widgetAt(QCursor::pos()))) return menu;
  return visible_in(&window);
}

}  // namespace tactus::workbench
