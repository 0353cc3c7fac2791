#include "app/workbench/base/display_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

struct StatisticWords {
  Q_DECLARE_TR_FUNCTIONS(StatisticWords)
};

}  // namespace

QString explained(Statistic statistic) {
  switch (statistic) {
    case Statistic::kNoticeable:
      return StatisticWords::tr(
          "JND: just-noticeable difference, √(0.04² + (0.12 F)²) N around a force F. A change below 1 JND is too small "
          "to feel.");
    case Statistic::kRms:
      return StatisticWords::tr(
          "RMS: the root of the mean squared difference. Large differences count more than in a mean.");
    case Statistic::kInterval:
      return StatisticWords::tr(
          "95 % interval: the data are drawn again many times, and 95 % of the draws give a value in this range. A "
          "wide "
          "one says that there are few data, or that they contradict each other.");
    case Statistic::kAlpha:
      return StatisticWords::tr(
          "Krippendorff's alpha: agreement beyond chance. 1 is full agreement, 0 what chance gives, less than 0 worse "
          "than chance. Ordinal: the order of the words counts; interval: their distances count too; nominal: two "
          "words "
          "are the same or not.");
    case Statistic::kKappa:
      return StatisticWords::tr(
          "Fleiss' kappa: agreement beyond chance, from 1 for full agreement to 0 for what chance gives. It takes no "
          "account of the order of the words: neighbors count as different as the ends.");
    case Statistic::kWeightedKappa:
      return StatisticWords::tr(
          "κ, kappa with quadratic weights: how well one person's answers to equal forces agree beyond chance. 1 is "
          "full "
          "agreement, 0 what chance gives; a word two steps away counts four times as much as a neighbor.");
    case Statistic::kKendallW:
      return StatisticWords::tr(
          "Kendall's W: how similarly the participants order the forces or items. 1 is one order of all, 0 no common "
          "order.");
    case Statistic::kConsensus:
      return StatisticWords::tr(
          "Consensus: 1 if all say the same word, 0 if half say the lowest and half the highest; the mean of the "
          "forces "
          "or items.");
  }
  return {};
}

namespace {

struct ProgramLanguage {
  Q_DECLARE_TR_FUNCTIONS(ProgramLanguage)
};

}  // namespace

QString programLanguage() {
  //: The code of the language of this translation, such as en, fr or zh-Hant
  return ProgramLanguage::tr("en");
}

QString languageName(const QString& id) {
  if (id == QLatin1String("en")) return QStringLiteral("English");
  if (id == QLatin1String("zh-Hant")) return QStringLiteral("繁體中文");
  if (id == QLatin1String("zh-Hans")) return QStringLiteral("简体中文");
  const QLocale locale(id);
  QString name = locale.language() == QLocale::C ? QString() : locale.nativeLanguageName();
  if (name.isEmpty()) return id;
  name[0] = name[0].toUpper();
  return name;
}

QString initialsOf(const QString& words) {
  QString out;
  const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (const QString& part : parts) out += part.front().toUpper();
  return out;
}

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
    TACTUS_TRY(const auto number, typedNumber(part, unit));
    out.push_back(number);
  }
  return out;
}

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

QString brokenAtCommas(const QString& listed) {
  constexpr QChar kNoBreakSpace(0x00A0), kWordJoiner(0x2060);
  QString out;
  for (qsizetype i = 0; i < listed.size(); ++i) {
    const bool behind_comma = i > 0 && listed[i - 1] == QLatin1Char(',');
    out += listed[i] == QLatin1Char(' ') && !behind_comma ? kNoBreakSpace : listed[i];
    if (listed[i] == QLatin1Char('/')) out += kWordJoiner;
  }
  return out;
}

QString numberText(double value, int decimals) {
  QString out = text(base::formatFixed(value, decimals));
  if (out.contains(QLatin1Char('.'))) {
    while (out.endsWith(QLatin1Char('0'))) out.chop(1);
    if (out.endsWith(QLatin1Char('.'))) out.chop(1);
  }
  return out == QLatin1String("-0") ? QStringLiteral("0") : out;
}

QString percentText(double share) {
  return share > 0 && share < 0.0005 ? DisplayText::tr("less than 0.1 %")
                                     : DisplayText::tr("%1 %").arg(numberText(100 * share, 1));
}

QString spelled(std::string_view id) { return text(std::string(id)).replace(QLatin1Char('_'), QLatin1Char(' ')); }

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
  QString words = spelled(variable.id);
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
