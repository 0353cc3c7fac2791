#include "app/workbench/participant/print_curve.h"

#include <QPainter>
#include <QPrinter>
#include <QPrinterInfo>

#include "app/workbench/participant/screens/force_curve.h"

namespace tactus::workbench {
namespace {

constexpr double kHeightShare = 0.6;  // of the width of the page
constexpr double kTextShare = 0.018;

}  // namespace

bool canPrint() { return !QPrinterInfo::defaultPrinterName().isEmpty(); }

void printCurve(const nurse::ForceCurve& curve) {
  if (!canPrint()) return;
  QPrinter printer(QPrinterInfo::defaultPrinter(), QPrinter::HighResolution);
  printer.setPageOrientation(QPageLayout::Landscape);
  QPainter painter;
  if (!painter.begin(&printer)) return;
  const QRectF page(QPointF(), printer.pageRect(QPrinter::DevicePixel).size());
  QFont font = curve.font();
  font.setPixelSize(static_cast<int>(page.width() * kTextShare));
  painter.setFont(font);
  curve.draw(painter, QRectF(0, 0, page.width(), page.width() * kHeightShare));
}

}  // namespace tactus::workbench
