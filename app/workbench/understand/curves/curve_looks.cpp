#include "app/workbench/understand/curves/curve_looks.h"

#include <array>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/term_colors.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/curves/reference_curve.h"

namespace tactus::workbench {

QPen familyPen(std::size_t index, std::size_t count, bool fast) {
  constexpr std::array<Qt::PenStyle, 4> kStyles = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine};
  const double share = count < 2 ? 1 : static_cast<double>(index) / static_cast<double>(count - 1);
  return {mixedColor(theme::mutedInk(), theme::ink(), share), fast ? 1.0 : 1.6 + share,
          kStyles[index % kStyles.size()]};
}

QPen referencePen(std::size_t index) {
  static constexpr std::array<QRgb, kMostReferences> kLight = {0x5B2DA0, 0x6B4E00, 0x00646B,
                                                               0x8A1F11, 0x3F5F00, 0xB0006A};
  static constexpr std::array<QRgb, kMostReferences> kDark = {0xC0A4FF, 0xE2C27A, 0x7FE0E6,
                                                              0xFF9C8C, 0xC3E07A, 0xFF7AC4};
  return {QColor::fromRgb((theme::isDark() ? kDark : kLight)[index % kMostReferences]), 1.6, Qt::DotLine};
}

LegendEntry ghostLook(const QString& name) { return {name, ghostPen(theme::mean())}; }

LegendEntry rangeLook(const QString& name) {
  QColor fill = theme::mean();
  fill.setAlpha(theme::isDark() ? 26 : 22);
  return {name, Qt::NoPen, fill};
}

LegendEntry deviationLook(const QString& name) { return {name, QPen(fadedLine(theme::mean()), 1.2, Qt::DotLine)}; }

LegendEntry stepLook(const QString& name) {
  QPen pen(theme::errorInk(), 4);
  pen.setCapStyle(Qt::RoundCap);
  return {name, pen};
}

}  // namespace tactus::workbench
