// The force words as buttons with their colors and keys: a legend of the grids, and a way to answer with the mouse.
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

  /// Sets the words of the output. Makes new buttons only if the words differ.
  void setWords(const std::vector<fuzzy::Term>& words);
  /// Marks the word of the current answer; nothing if there is no answer to change.
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
