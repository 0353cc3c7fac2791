#include "app/workbench/plot/expert_pen.h"

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/mixed_color.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kTold = 24;  // six colors with four kinds of dashes
constexpr double kExpertPx = 1.6;

// The colors repeat after six experts; the dashes then tell them apart.
Qt::PenStyle dashesOf(std::size_t number) {
  constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return kStyles[number / 6 % 4];
}

}  // namespace

QPen expertPen(std::size_t number, std::size_t count) {
  if (count <= kTold) return {theme::expert(number), kExpertPx, dashesOf(number)};
  return {mixedColor(theme::card(), theme::expert(number), 0.5), 1};
}

}  // namespace tactus::workbench
