// How the rules of one expert lead to the force: one line per firing rule, strongest first. A line goes from the
// memberships of the conditions over the firing strength to the set of the output term.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/model/open_model.h"
#include "core/analysis/explain.h"

namespace tactus::workbench {

class RuleFlow : public QWidget {
  Q_OBJECT

 public:
  explicit RuleFlow(QWidget* parent = nullptr);

  /// Shows expert `expert` of an explanation of `open`.
  void set(std::shared_ptr<const OpenModel> open, const analysis::Explanation& explanation, std::size_t expert);
  /// Marks these rules of the expert.
  void setSelected(const std::vector<std::size_t>& rules);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// A click on the line of a rule, or a key that moves there.
  void chosen(std::size_t rule);
  /// A double click on it, or Enter.
  void editAsked(std::size_t rule);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Columns {
    std::vector<QRectF> inputs;  ///< one per entry of inputs_
    QRectF strength;
    QRectF output;
  };

  Columns columns(double top, double height) const;
  double lineTop(std::size_t line) const;
  std::optional<std::size_t> lineAt(double y) const;
  std::optional<std::size_t> selectedLine() const;
  QString sentenceOf(std::size_t line) const;
  void paintHead(QPainter& painter) const;
  void paintLine(QPainter& painter, std::size_t line) const;
  void paintCondition(QPainter& painter, const QRectF& cell, std::size_t input,
                      const analysis::ExplainedRule& rule) const;
  void paintStrength(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const;
  void paintOutput(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const;

  std::shared_ptr<const OpenModel> open_;
  std::size_t expert_ = 0;
  analysis::ExplainedExpert explained_;
  std::vector<double> values_;                   ///< values of the inputs, inside their universes
  std::vector<std::size_t> inputs_;              ///< the inputs that the expert's rules use
  std::vector<analysis::ExplainedRule> acting_;  ///< strongest first
  std::vector<std::size_t> selected_;            ///< rules of the expert
};

}  // namespace tactus::workbench
