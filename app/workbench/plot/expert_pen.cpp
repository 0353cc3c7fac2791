#include "app/workbench/plot/expert_pen.h"

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/mixed_color.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kTold = 24;  // six colors with four kinds of dashes
constexpr double kExpertPx = 1.6;
constexpr double kLeastContrast = 3;  // WCAG 2.1, 1.4.11

// The colors repeat after six experts; the dashes then tell them apart.
Qt::PenStyle dashesOf(std::size_t number) {
  constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return kStyles[number / 6 % 4];
}

}  // namespace

QPen expertPen(std::size_t number, std::size_t count) {
  if (count <= kTold) return {theme::expert(number), kExpertPx, dashesOf(number)};
  // As pale as it can still be seen.
  double share = 0.5;
  QColor line = mixedColor(theme::card(), theme::expert(number), share);
  while (share < 1 && contrastOf(line, theme::card()) < kLeastContrast) {
    line = mixedColor(theme::card(), theme::expert(number), share += 0.05);
  }
  return {line, 1};
}

}  // namespace tactus::workbench
