#include "app/workbench/base/typed_number.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

struct TypedNumber {
  Q_DECLARE_TR_FUNCTIONS(TypedNumber)
};

/// Without the unit behind it, which a box may have added once more.
QString withoutUnit(QString typed, const QString& unit) {
  typed = typed.trimmed();
  while (!unit.isEmpty() && typed.endsWith(unit, Qt::CaseInsensitive)) {
    typed.chop(unit.size());
    typed = typed.trimmed();
  }
  return typed;
}

QString numberWithUnit(double value, const QString& unit) {
  const QString number = text(base::formatNumber(value));
  return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

}  // namespace

tl::expected<double, QString> typedNumber(const QString& typed, const QString& unit) {
  QString number = withoutUnit(typed, unit);
  number.replace(QChar(0x2212), QLatin1Char('-'));  // the minus sign of typography
  if (number.isEmpty()) return tl::unexpected(TypedNumber::tr("A number is missing: type one such as 13.5 or 13,5."));
  if (number.count(QLatin1Char(',')) + number.count(QLatin1Char('.')) > 1) {
    return tl::unexpected(
        TypedNumber::tr("“%1” has more than one decimal mark: type a number such as 1234.5 or 1234,5.").arg(number));
  }
  QString plain = number;
  plain.replace(QLatin1Char(','), QLatin1Char('.'));
  if (plain.startsWith(QLatin1Char('+')) && !plain.startsWith(QLatin1String("+-"))) plain.remove(0, 1);
  const auto value = base::parseNumber(plain.toStdString());
  if (!value || !std::isfinite(*value)) {
    return tl::unexpected(TypedNumber::tr("“%1” is no number: type one such as 13.5 or 13,5.").arg(number));
  }
  return *value;
}

tl::expected<double, QString> typedNumber(const QString& typed, const NumberBounds& bounds) {
  const auto value = typedNumber(typed, bounds.unit);
  if (!value) return value;
  if (*value < bounds.min || *value > bounds.max) {
    return tl::unexpected(TypedNumber::tr("%1 is outside %2 to %3.")
                              .arg(numberWithUnit(*value, bounds.unit), text(base::formatNumber(bounds.min)),
                                   numberWithUnit(bounds.max, bounds.unit)));
  }
  if (bounds.whole && *value != std::floor(*value)) {
    return tl::unexpected(TypedNumber::tr("%1 is no whole number.").arg(numberWithUnit(*value, bounds.unit)));
  }
  return value;
}

tl::expected<std::vector<double>, QString> typedNumbers(const QString& typed, const QString& unit) {
  static const QRegularExpression between_digits(QStringLiteral("\\d,\\d"));
  const bool semicolons = typed.contains(QLatin1Char(';'));
  // A comma between digits is a decimal mark to some and a separator to others.
  if (!semicolons && between_digits.match(typed).hasMatch() && !typed.contains(QLatin1Char('.'))) {
    return tl::unexpected(TypedNumber::tr("“%1” can be one number or two: type %2 or %3.")
                              .arg(typed.trimmed(),
                                   QString(typed.trimmed()).replace(QLatin1Char(','), QLatin1Char('.')),
                                   QString(typed.trimmed()).replace(QLatin1Char(','), QLatin1String("; "))));
  }
  std::vector<double> out;
  for (const QString& part : typed.split(semicolons ? QLatin1Char(';') : QLatin1Char(','))) {
    const auto number = typedNumber(part, unit);
    if (!number) return tl::unexpected(number.error());
    out.push_back(*number);
  }
  return out;
}

}  // namespace tactus::workbench
