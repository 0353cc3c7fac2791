#include "app/workbench/plot/picture_export.h"

#include <QBuffer>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QScreen>
#include <QSvgGenerator>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_source.h"
#include "app/workbench/plot/plot_style.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
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

}  // namespace tactus::workbench
