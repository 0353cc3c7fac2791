#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/frame/lab_card.h"

namespace tactus::workbench {
namespace {

std::vector<Column<WordsRow>> wordsColumns() {
  return {{WordsAndRulesView::tr("Shared rules"),
           &WordsRow::shared_rules,
           Qt::AlignRight,
           WordsAndRulesView::tr("Everyone has the averaged rules."),
           {{Qt::ToolTipRole, &WordsRow::shared_tip}}},
          {WordsAndRulesView::tr("Own rules"),
           &WordsRow::own_rules,
           Qt::AlignRight,
           WordsAndRulesView::tr("Everyone has the rules of their own answers."),
           {{Qt::ToolTipRole, &WordsRow::own_tip}}}};
}

QString deviation(const elicitation::Disagreement& one) { return quantityText(one.sd_n, "N", 3); }

QString largest(const elicitation::Disagreement& one) {
  return WordsAndRulesView::tr("Standard deviation between the experts. At most they lie %1 apart.")
      .arg(quantityText(one.largest_n, "N", 3));
}

std::vector<WordsRow> wordsRows(const elicitation::WordsAndRules& found) {
  if (found.points == 0) return {};
  const QString same = WordsAndRulesView::tr("Shared words and shared rules are one model: all have the same force.");
  return {{WordsAndRulesView::tr("Shared words"), deviation({}), deviation(found.rules), same, largest(found.rules)},
          {WordsAndRulesView::tr("Own words"), deviation(found.words), deviation(found.both), largest(found.words),
           largest(found.both)}};
}

}  // namespace

WordsAndRulesView::WordsAndRulesView(ExpertsLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      table_(new Columns<WordsRow>(wordsColumns(), this)),
      view_(makeLabTable(*table_, -1, tr("Disagreement through words and rules"), nullptr)),
      sentence_(new WrappedLabel),
      notes_(new WrappedLabel) {
  setObjectName(QStringLiteral("words_and_rules"));
  table_->setRowHeads(&WordsRow::words);
  view_->verticalHeader()->show();
  view_->verticalHeader()->setFont(theme::smallFont());
  view_->horizontalHeader()->setStretchLastSection(false);
  for (QLabel* const label : {sentence_, notes_}) {
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setTextFormat(Qt::PlainText);
  }
  setMuted(*notes_);
  makeColumn(this, {sentence_, {view_, 1}, {notes_, 1}}, theme::kGrid / 2, inset(theme::kGrid, theme::kGrid / 2));
  connect(&lab_.wordsAndRules(), &Computation::valueChanged, this, &WordsAndRulesView::refreshState);
  connect(&lab_.wordsAndRules(), &Computation::changed, this, &WordsAndRulesView::refreshState);
  refreshState();
}

QString WordsAndRulesView::sentence() const { return sentence_->text(); }

void WordsAndRulesView::refreshState() {
  const auto& found = lab_.wordsAndRules().value();
  table_->setRows(found == nullptr ? std::vector<WordsRow>() : wordsRows(*found));
  view_->setVisible(table_->rowCount() > 0);
  sentence_->setText(found != nullptr                ? wordsAndRulesText(*found)
                     : lab_.wordsAndRules().isBusy() ? tr("Comparing words and rules …")
                                                     : lab_.wordsAndRules().failure());
  QStringList notes;
  if (found != nullptr && found->points > 0) {
    notes << tr("Standard deviations in the mean over %1 points of all inputs. The two parts do not add up.")
                 .arg(found->points);
  }
  for (std::size_t i = 0; found != nullptr && i < found->notes.size(); ++i) notes << text(found->notes[i]);
  notes_->setText(notes.join(QLatin1Char(' ')));
  notes_->setToolTip(notes.join(QLatin1Char('\n')));
}

void WordsAndRulesView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  lab_.wordsAndRules().hold(*this);
}

void WordsAndRulesView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  lab_.wordsAndRules().hold(*this, false);
}

}  // namespace tactus::workbench
