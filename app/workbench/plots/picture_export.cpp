#include "app/workbench/plots/picture_export.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "app/workbench/plots/plot_style.h"
#include "app/workbench/theme.h"
#include "core/base/file.h"

namespace tactus::workbench {
namespace {

constexpr int kWidth = 1000;     // px of the layout
constexpr int kHeight = 600;     // px of the layout
constexpr double kPngScale = 2;  // sharp on paper at 16 cm width
constexpr double kPointsPerInch = 72;

// Adds title, note and legend around the plot for as long as it lives.
class Caption {
 public:
  Caption(QCustomPlot& plot, const QString& title, const QString& note) : plot_(plot) {
    QCPLayoutGrid& grid = *plot_.plotLayout();
    grid.insertRow(0);
    grid.insertRow(0);
    title_ = new QCPTextElement(&plot_, title, theme::titleFont());
    note_ = new QCPTextElement(&plot_, note, theme::smallFont());
    title_->setTextColor(theme::ink());
    note_->setTextColor(theme::mutedInk());
    grid.addElement(0, 0, title_);
    grid.addElement(1, 0, note_);

    QCPLegend* legend = plot_.legend;
    legend->clearItems();
    for (int i = 0; i < plot_.graphCount(); ++i) {
      if (plot_.graph(i)->visible()) plot_.graph(i)->addToLegend(legend);
    }
    legend->setFont(theme::smallFont());
    legend->setTextColor(theme::ink());
    legend->setBorderPen(Qt::NoPen);
    legend->setIconTextPadding(10);
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend->setWrap(8);
    plot_.axisRect()->insetLayout()->take(legend);
    grid.addElement(3, 0, legend);
    grid.setRowStretchFactor(3, 0.001);
    legend->setVisible(true);
  }

  ~Caption() {
    QCPLayoutGrid& grid = *plot_.plotLayout();
    plot_.legend->setVisible(false);
    grid.take(plot_.legend);
    plot_.axisRect()->insetLayout()->addElement(plot_.legend, Qt::AlignTop | Qt::AlignRight);
    grid.remove(title_);
    grid.remove(note_);
    grid.simplify();
  }

  Caption(const Caption&) = delete;
  Caption& operator=(const Caption&) = delete;

 private:
  QCustomPlot& plot_;
  QCPTextElement* title_;
  QCPTextElement* note_;
};

void paint(QCustomPlot& plot, QPaintDevice& device) {
  QCPPainter painter;
  painter.begin(&device);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  plot.toPainter(&painter, kWidth, kHeight);
  painter.end();
}

void paintSvg(QCustomPlot& plot, const QString& title, QIODevice& out) {
  QSvgGenerator svg;
  svg.setOutputDevice(&out);
  // The resolution of the screen, by which the plot measures its texts.
  svg.setResolution(plot.logicalDpiX());
  svg.setSize({kWidth, kHeight});
  svg.setViewBox(QRect(0, 0, kWidth, kHeight));
  svg.setTitle(title);
  paint(plot, svg);
}

void paintPdf(QCustomPlot& plot, const QString& title, QIODevice& out) {
  QPdfWriter pdf(&out);
  pdf.setTitle(title);
  pdf.setResolution(plot.logicalDpiX());
  const double point = kPointsPerInch / plot.logicalDpiX();
  pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
  pdf.setPageSize(QPageSize(QSizeF(kWidth * point, kHeight * point), QPageSize::Point, {}, QPageSize::ExactMatch));
  paint(plot, pdf);
}

}  // namespace

base::Result<void> savePicture(QCustomPlot& plot, const QString& path, const QString& title, const QString& note) {
  const QString ending = QFileInfo(path).suffix().toLower();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const Caption caption(plot, title, note);
  if (ending == QLatin1String("png")) {
    plot.toPixmap(kWidth, kHeight, kPngScale).save(&buffer, "PNG");
  } else if (ending == QLatin1String("svg")) {
    paintSvg(plot, title, buffer);
  } else if (ending == QLatin1String("pdf")) {
    paintPdf(plot, title, buffer);
  } else {
    return base::inFile({base::ErrorCode::kValue, {}, {}, base::quoted(ending.toStdString()), "png, svg or pdf"},
                        path.toStdString());
  }
  buffer.close();
  return base::writeFileAtomically(path.toStdString(), bytes.toStdString());
}

}  // namespace tactus::workbench
