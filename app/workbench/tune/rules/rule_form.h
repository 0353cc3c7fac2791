// The form for any rule: a term or nothing for each input, the consequent, the weight.
#pragma once

#include <QFrame>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class NumberBox;
class RuleController;

class RuleForm : public QFrame {
  Q_OBJECT

 public:
  explicit RuleForm(RuleController& rules, QWidget* parent = nullptr);

  /// Opens the form for a new rule.
  void openNew();
  /// Opens the form for rule `rule`, to replace it.
  void openFor(std::size_t rule);
  /// Updates the form to the current rules and terms.
  void follow();

 signals:
  /// Rule `rule` now has the contents of the form.
  void done(std::size_t rule);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Line {
    std::string input;
    QComboBox* terms = nullptr;
  };

  void buildLines();
  void fill();
  void show(const fuzzy::Rule& rule);
  void showTarget();
  void say(const QString& sentence, bool refused);
  fuzzy::Rule typed() const;
  void accept();

  RuleController& rules_;
  std::optional<std::size_t> target_;  ///< the rule to replace; nothing for a new one
  fuzzy::Rule before_;                 ///< that rule when the form was opened
  QLabel* title_;
  QWidget* lines_place_;
  QGridLayout* lines_grid_;
  std::vector<Line> lines_;
  QLabel* then_label_;
  QComboBox* then_;
  NumberBox* weight_;
  QPushButton* accept_;
  QLabel* message_;
};

}  // namespace tactus::workbench
