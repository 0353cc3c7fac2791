#include "app/workbench/tune/rules/rule_filter.h"

#include <algorithm>

namespace tactus::workbench {
namespace {

bool holds(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

RuleFilter::RuleFilter(const QString& typed) {
  const QStringList words = typed.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const bool sentence = words.contains(QStringLiteral("if")) || words.contains(QStringLiteral("and")) ||
                        words.contains(QStringLiteral("then"));
  QStringList part;
  const auto end_part = [&] {
    if (!part.isEmpty()) parts_.push_back(part);
    part.clear();
  };
  for (const QString& word : words) {
    if (word == QLatin1String("if") || word == QLatin1String("is")) continue;
    if (word == QLatin1String("then")) {
      end_part();
      has_then_ = true;
    } else if (has_then_) {
      then_ << word;
    } else if (word == QLatin1String("and")) {
      end_part();
    } else {
      part << word;
      if (!sentence) end_part();
    }
  }
  end_part();
}

bool RuleFilter::takes(const RuleWords& rule) const {
  if (has_then_ && !holds(rule.consequent, then_)) return false;
  return std::all_of(parts_.begin(), parts_.end(), [&](const QStringList& part) {
    if (!has_then_ && holds(rule.consequent, part)) return true;
    return std::any_of(rule.conditions.begin(), rule.conditions.end(),
                       [&](const QString& condition) { return holds(condition, part); });
  });
}

}  // namespace tactus::workbench
