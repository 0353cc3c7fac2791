#include "app/workbench/base/display_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

struct DisplayText {
  Q_DECLARE_TR_FUNCTIONS(DisplayText)
};

QString labelOrId(const std::string& label, const std::string& id) { return text(label.empty() ? id : label); }

int placeDigits(const fuzzy::Variable& variable) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10((variable.max - variable.min) / 1000))), 0, 9);
}

}  // namespace

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

QString harmless(const QString& outside) { return text(base::oneLine(outside.toStdString())); }

QString shownFileName(const QString& path) { return harmless(QFileInfo(path).fileName()); }

QString numberText(double value, int decimals) {
  QString out = text(base::formatFixed(value, decimals));
  if (out.contains(QLatin1Char('.'))) {
    while (out.endsWith(QLatin1Char('0'))) out.chop(1);
    if (out.endsWith(QLatin1Char('.'))) out.chop(1);
  }
  return out == QLatin1String("-0") ? QStringLiteral("0") : out;
}

QString unitText(const std::string& unit) { return unit == "1" ? QString() : text(unit); }

QString quantityText(double value, const std::string& unit, int decimals) {
  const QString number = numberText(value, decimals);
  return unitText(unit).isEmpty() ? number : number + QLatin1Char(' ') + unitText(unit);
}

QString exactText(double value, const std::string& unit) {
  const QString number = text(base::formatNumber(value));
  return unitText(unit).isEmpty() ? number : number + QLatin1Char(' ') + unitText(unit);
}

double placeOf(const fuzzy::Variable& variable, double value) {
  return std::clamp(roundedPlace(variable, value), variable.min, variable.max);
}

double roundedPlace(const fuzzy::Variable& variable, double value) {
  const double scale = std::pow(10.0, placeDigits(variable));
  return std::round(value * scale) / scale;
}

QString placeText(const fuzzy::Variable& variable, double value) {
  return quantityText(value, variable.unit, placeDigits(variable));
}

QString rangeText(const fuzzy::Variable& variable, double from, double to) {
  return DisplayText::tr("%1 to %2").arg(numberText(from, placeDigits(variable)), placeText(variable, to));
}

QString forceText(double force, const std::string& unit) {
  // Never -0.000.
  const QString number = text(base::formatFixed(std::abs(force) < 0.0005 ? 0 : force, 3));
  return unitText(unit).isEmpty() ? number : number + QLatin1Char(' ') + unitText(unit);
}

QString labelOf(const fuzzy::Variable& variable) { return labelOrId(variable.label, variable.id); }
QString labelOf(const fuzzy::Term& term) { return labelOrId(term.label, term.id); }
QString labelOf(const fuzzy::Expert& expert) { return labelOrId(expert.label, expert.id); }

QString shortLabelOf(const fuzzy::Variable& variable) {
  QString words = text(variable.id).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString axisText(const fuzzy::Variable& variable) {
  const QString unit = unitText(variable.unit);
  return unit.isEmpty() ? labelOf(variable) : QStringLiteral("%1 (%2)").arg(labelOf(variable), unit);
}

QString membershipText(const std::vector<fuzzy::Term>& terms, double value) {
  QStringList parts;
  for (const fuzzy::Term& term : terms) {
    const double membership = fuzzy::MembershipFunction::of(term)(value);
    // A membership that rounds to 0.00 would read as a contradiction.
    if (membership < 0.005) continue;
    parts << labelOf(term) + QLatin1Char(' ') + text(base::formatFixed(membership, 2));
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace tactus::workbench
