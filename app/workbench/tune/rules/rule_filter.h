// Which rules of a list a person wants to see: words of the rule, and what is the matter with it.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace tactus::workbench {

/// A rule in the words of the screen.
struct RuleWords {
  QStringList conditions;  ///< `Tube lubrication is Well`, one each
  QString consequent;      ///< `Very large`

  bool operator==(const RuleWords&) const = default;
};

/// What somebody typed: `well esoph`, `if well and stomach then small`. Letters match whatever their case.
class RuleFilter {
 public:
  RuleFilter() = default;
  explicit RuleFilter(const QString& typed);

  /// Whether every part between `and` is found in one condition, or in the consequent, and what stands behind `then` in
  /// the consequent. Without these words every word stands for itself. An empty filter takes every rule.
  bool takes(const RuleWords& rule) const;

 private:
  std::vector<QStringList> parts_;  ///< the words of each part
  QStringList then_;
  bool has_then_ = false;
};

}  // namespace tactus::workbench
