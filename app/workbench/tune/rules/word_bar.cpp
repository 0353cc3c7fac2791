#include "app/workbench/tune/rules/word_bar.h"

#include <QGridLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/tune/rules/word_button.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostOnALine = 6;  // words and the empty answer; more get a second line
constexpr std::size_t kMostKeys = 9;

}  // namespace

WordBar::WordBar(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(2);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void WordBar::setWords(const std::vector<fuzzy::Term>& words) {
  QStringList labels;
  for (const fuzzy::Term& word : words) labels << labelOf(word);
  if (none_ != nullptr && labels == words_) return;
  words_ = labels;
  for (WordButton* button : buttons_) delete button;
  buttons_.clear();
  delete none_;
  const auto place = [&](WordButton* button, std::size_t index) {
    const std::size_t columns = std::min(kMostOnALine, words.size() + 1);
    grid_->addWidget(button, static_cast<int>(index / columns), static_cast<int>(index % columns));
    grid_->setColumnStretch(static_cast<int>(index % columns), 1);
  };
  for (std::size_t w = 0; w < words.size(); ++w) {
    const QString key = w < kMostKeys ? QString::number(w + 1) : QString();
    buttons_.push_back(new WordButton(labels[static_cast<qsizetype>(w)], key, theme::force(w, words.size()), this));
    connect(buttons_.back(), &QAbstractButton::clicked, this, [this, w] { emit chosen(w); });
    place(buttons_.back(), w);
  }
  none_ = new WordButton(tr("No answer"), QString(), std::nullopt, this);
  none_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  none_->setToolTip(tr("Remove the answer (Delete)"));
  connect(none_, &QAbstractButton::clicked, this, &WordBar::cleared);
  place(none_, words.size());
}

void WordBar::setAnswer(std::optional<std::size_t> word) {
  for (std::size_t w = 0; w < buttons_.size(); ++w) buttons_[w]->setMarked(w == word);
  if (none_ != nullptr) none_->setMarked(!word);
}

}  // namespace tactus::workbench
