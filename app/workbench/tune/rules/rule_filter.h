// The filter of the rule list, by the words of a rule.
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

/// The user's text: `well esoph`, `if well and stomach then small`. Upper and lower case are equal.
class RuleFilter {
 public:
  RuleFilter() = default;
  explicit RuleFilter(const QString& typed);

  /// Whether the rule passes. Each part between `and` must be found in one condition; the part after `then`, in the
  /// consequent. Without `then` a part may be in the consequent, too. Without any of these words each word is a part.
  /// An empty filter passes every rule.
  bool takes(const RuleWords& rule) const;

 private:
  std::vector<QStringList> parts_;  ///< the words of each part
  QStringList then_;
  bool has_then_ = false;
};

}  // namespace tactus::workbench
