#include "app/workbench/kit/label_break.h"

#include <algorithm>
#include <utility>

namespace tactus::workbench {
namespace {

constexpr qsizetype kShortestPart = 3;  // letters on either line

// Two lines of about the same length, or one where nothing can be broken.
std::pair<QString, QString> halves(const QString& label) {
  const QString vowels = QStringLiteral("aeiouäöü");
  const bool has_space = label.contains(QLatin1Char(' '));
  qsizetype best = -1;
  for (qsizetype i = 1; i < label.size(); ++i) {
    const bool space = label[i] == QLatin1Char(' ');
    const bool behind_vowel = vowels.contains(label[i - 1].toLower()) && !vowels.contains(label[i].toLower()) &&
                              i >= kShortestPart && label.size() - i >= kShortestPart;
    if (has_space ? !space : !behind_vowel) continue;
    if (best < 0 || qAbs(2 * i - label.size()) < qAbs(2 * best - label.size())) best = i;
  }
  if (best < 0) return {label, {}};
  if (has_space) return {label.left(best), label.mid(best + 1)};
  return {label.left(best) + QLatin1Char('-'), label.mid(best)};
}

}  // namespace

QString brokenLabel(const QString& label, double width, const QFontMetricsF& metrics) {
  if (metrics.horizontalAdvance(label) <= width) return label;
  const auto [first, second] = halves(label);
  QString out = metrics.elidedText(first, Qt::ElideRight, width);
  if (!second.isEmpty()) out += QLatin1Char('\n') + metrics.elidedText(second, Qt::ElideRight, width);
  return out;
}

double brokenWidth(const QString& label, const QFontMetricsF& metrics) {
  const auto [first, second] = halves(label);
  return std::max(metrics.horizontalAdvance(first), metrics.horizontalAdvance(second));
}

}  // namespace tactus::workbench
