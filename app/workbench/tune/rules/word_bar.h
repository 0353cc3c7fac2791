// The words of the answers as buttons with their colors and keys: a legend of the grids, and a way to answer with the
// mouse.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

class QGridLayout;

namespace tactus::workbench {

class WordButton;

class WordBar : public QWidget {
  Q_OBJECT

 public:
  explicit WordBar(QWidget* parent = nullptr);

  /// The words of the output; buttons are made anew only where the words differ.
  void setWords(const std::vector<fuzzy::Term>& words);
  /// The word of the present answer, or nothing where there is none to change.
  void setAnswer(std::optional<std::size_t> word);

 signals:
  void chosen(std::size_t word);
  void cleared();

 private:
  QGridLayout* grid_;
  QStringList words_;
  std::vector<WordButton*> buttons_;
  WordButton* none_ = nullptr;
};

}  // namespace tactus::workbench
