#include "app/workbench/plot/plot_menu.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QCursor>
#include <QDockWidget>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QPageSize>
#include <QPainterPath>
#include <QPdfWriter>
#include <QPointer>
#include <QScreen>
#include <QString>
#include <QStringList>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QSvgGenerator>
#include <QTextLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/plot/plot_style.h"
#include "core/base/error.h"
#include "core/base/files/file.h"

namespace tactus::workbench {

// Plots as pictures for a paper, a report or the clipboard: the plot, its legend, and a caption with the settings.

class PlotSource;

/// Pixels of the picture per pixel of its layout: sharp on paper at 16 cm width, and on any screen.
inline constexpr double kPictureScale = 2;

/// `plot` with its legend and, below it, the lines of `caption`. The first line is the title.
QImage pictureOf(PlotSource& plot, const QStringList& caption);

/// Writes that picture to `path`, completely or not at all, as PNG, SVG or PDF by the extension of `path`. Refused:
/// another extension, a file that cannot be written.
base::Result<void> savePicture(PlotSource& plot, const QStringList& caption, const QString& path);

namespace {

constexpr int kMargin = 3 * theme::kGrid;  // px around legend and caption
constexpr int kEdge = 2 * theme::kGrid;    // px above the plot and right of it
constexpr int kSwatch = 3 * theme::kGrid;  // px, width of a line in the legend
constexpr double kPointsPerInch = 72;
constexpr double kMmPerInch = 25.4;

// The resolution of the screen, by which the plots measure their texts.
int dotsPerInch() { return qRound(QGuiApplication::primaryScreen()->logicalDotsPerInch()); }

// Where the parts of a picture stand: the plot, below it the legend in rows, below that the caption.
class Picture {
 public:
  Picture(PlotSource& plot, const QStringList& caption) : plot_(plot), size_(plot.pictureSize()) {
    int y = kEdge + size_.height();
    placeLegend(y);
    placeCaption(caption, y);
    whole_ = QSize(size_.width(), y + kMargin / 2);
  }

  QSize size() const { return whole_; }

  void paint(QPaintDevice& device, double scale) {
    QCPPainter painter;
    painter.begin(&device);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    painter.scale(scale, scale);
    painter.fillRect(QRect(QPoint(0, 0), whole_), theme::card());
    painter.save();
    // QCustomPlot fills its ground from the origin of the painter.
    painter.translate(0, kEdge);
    plot_.paintPicture(painter, size_ - QSize(kEdge, 0));
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Entry& entry : entries_) paintEntry(painter, entry);
    for (const Line& line : lines_) {
      painter.setFont(line.font);
      painter.setPen(line.color);
      painter.drawText(line.place, line.text);
    }
    painter.end();
  }

 private:
  struct Entry {
    LegendEntry what;
    QPointF place;  ///< of the text, on its base line
  };
  struct Line {
    QString text;
    QFont font;
    QColor color;
    QPointF place;
  };

  void placeLegend(int& y) {
    const QFontMetricsF metrics(theme::smallFont());
    double x = kMargin;
    bool any = false;
    for (LegendEntry& entry : plot_.legend()) {
      const double width = kSwatch + theme::kGrid + metrics.horizontalAdvance(entry.name);
      if (x + width > size_.width() - kMargin && x > kMargin) {
        x = kMargin;
        y += qCeil(metrics.lineSpacing()) + 2;
      }
      const double text_x = x + kSwatch + theme::kGrid;
      entries_.push_back({std::move(entry), QPointF(text_x, y + metrics.ascent())});
      x += width + kMargin;
      any = true;
    }
    if (any) y += qCeil(metrics.lineSpacing()) + theme::kGrid;
  }

  void placeCaption(const QStringList& caption, int& y) {
    for (const QString& paragraph : caption) {
      const bool title = lines_.empty();
      const QFont font = title ? theme::headingFont() : theme::smallFont();
      const QFontMetricsF metrics(font);
      QTextLayout layout(paragraph, font);
      layout.beginLayout();
      for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(size_.width() - 2 * kMargin);
        lines_.push_back({paragraph.mid(line.textStart(), line.textLength()), font,
                          title ? theme::ink() : theme::mutedInk(), QPointF(kMargin, y + metrics.ascent())});
        y += qCeil(metrics.lineSpacing()) + 2;
      }
      layout.endLayout();
    }
  }

  static void paintEntry(QPainter& painter, const Entry& entry) {
    const QFontMetricsF metrics(theme::smallFont());
    const QPointF right = entry.place - QPointF(theme::kGrid, metrics.xHeight() / 2);
    const QPointF left = right - QPointF(kSwatch, 0);
    if (entry.what.fill.style() != Qt::NoBrush) {
      painter.fillRect(QRectF(left - QPointF(0, 5), right + QPointF(0, 5)), entry.what.fill);
    }
    painter.setPen(entry.what.pen);
    painter.drawLine(left, right);
    if (entry.what.dots) {
      painter.setBrush(entry.what.pen.color());
      painter.drawEllipse((left + right) / 2, 2, 2);
      painter.setBrush(Qt::NoBrush);
    }
    painter.setFont(theme::smallFont());
    painter.setPen(theme::ink());
    painter.drawText(entry.place, entry.what.name);
  }

  PlotSource& plot_;
  QSize size_;
  QSize whole_;
  std::vector<Entry> entries_;
  std::vector<Line> lines_;
};

void paintSvg(Picture& picture, const QString& title, QIODevice& out) {
  QSvgGenerator svg;
  svg.setOutputDevice(&out);
  svg.setResolution(dotsPerInch());
  svg.setSize(picture.size());
  svg.setViewBox(QRect(QPoint(0, 0), picture.size()));
  svg.setTitle(title);
  picture.paint(svg, 1);
}

void paintPdf(Picture& picture, const QString& title, QIODevice& out) {
  QPdfWriter pdf(&out);
  pdf.setTitle(title);
  pdf.setResolution(dotsPerInch());
  const double point = kPointsPerInch / dotsPerInch();
  pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
  pdf.setPageSize(QPageSize(QSizeF(picture.size().width() * point, picture.size().height() * point), QPageSize::Point,
                            {}, QPageSize::ExactMatch));
  picture.paint(pdf, 1);
}

}  // namespace

QImage pictureOf(PlotSource& plot, const QStringList& caption) {
  Picture picture(plot, caption);
  QImage image(picture.size() * kPictureScale, QImage::Format_RGB32);
  const int dots_per_meter = qRound(dotsPerInch() * 1000 / kMmPerInch);
  // The texts have their size on the screen, and the scale of the painter enlarges them like everything else.
  image.setDotsPerMeterX(dots_per_meter);
  image.setDotsPerMeterY(dots_per_meter);
  picture.paint(image, kPictureScale);
  image.setDotsPerMeterX(qRound(dots_per_meter * kPictureScale));
  image.setDotsPerMeterY(qRound(dots_per_meter * kPictureScale));
  return image;
}

base::Result<void> savePicture(PlotSource& plot, const QStringList& caption, const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  Picture picture(plot, caption);
  if (ending == QLatin1String("png")) {
    pictureOf(plot, caption).save(&buffer, "PNG");
  } else if (ending == QLatin1String("svg")) {
    paintSvg(picture, caption.value(0), buffer);
  } else if (ending == QLatin1String("pdf")) {
    paintPdf(picture, caption.value(0), buffer);
  } else {
    return base::inFile({base::ErrorCode::kValue, {}, {}, base::quoted(ending.toStdString()), "png, svg or pdf"},
                        path.toStdString());
  }
  buffer.close();
  return base::writeFileAtomically(path.toStdString(), bytes.toStdString());
}

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
