#include "app/workbench/collect/withdrawal_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "core/study/record_id.h"

namespace tactus::workbench {
namespace {

constexpr int kWidth = 64 * theme::kGrid;  // px at 100 %
constexpr int kPairs = 2;                  // counts beside each other

QLabel* plain(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace

WithdrawalDialog::WithdrawalDialog(CollectController& collect, const study::RecordId& person, QWidget* parent)
    : QDialog(parent),
      collect_(collect),
      person_(person),
      code_(collect.row(person) != nullptr ? collect.row(person)->code : QString()),
      title_(plain(this)),
      text_(plain(this)),
      counts_(new QGridLayout),
      stays_(plain(this)),
      ask_(plain(this)),
      typed_(new QLineEdit(this)),
      trouble_(plain(this)),
      keep_(new QPushButton(tr("&Keep the data"), this)),
      withdraw_(new QPushButton(tr("Withdraw and &delete"), this)) {
  setWindowTitle(tr("Withdraw a participant"));
  build();
  connect(&collect_, &CollectController::changed, this, &WithdrawalDialog::showState);
  connect(&collect_, &CollectController::previewed, this,
          [this](const study::RecordId& of, const store::WithdrawalPreview& preview) {
            if (of == person_) showPreview(preview);
          });
  connect(&collect_, &CollectController::withdrawalRefused, this,
          [this](const study::RecordId& of, const QString& sentence) {
            if (of != person_) return;
            trouble_->setText(harmless(sentence));
            trouble_->show();
            showState();
            fit();
          });
  connect(&collect_, &CollectController::withdrawn, this, [this](const QString& code) {
    if (code == code_) accept();
  });
  connect(typed_, &QLineEdit::textChanged, this, &WithdrawalDialog::showState);
  connect(keep_, &QPushButton::clicked, this, &QDialog::reject);
  connect(withdraw_, &QPushButton::clicked, this, [this] {
    trouble_->hide();
    if (isConfirmed()) collect_.withdraw(person_);
  });
  collect_.previewWithdrawal(person_);
  showState();
  fit();
}

void WithdrawalDialog::build() {
  title_->setFont(theme::titleFont());
  title_->setText(tr("Withdraw %1 from the study?").arg(harmless(code_)));
  text_->setText(tr("Everything of this participant is deleted for good. This cannot be undone."));
  counts_->setHorizontalSpacing(2 * theme::kGrid);
  counts_->setVerticalSpacing(theme::kGrid / 2);
  for (int pair = 0; pair < kPairs; ++pair) counts_->setColumnStretch(2 * pair + 1, 1);
  setInk(*stays_, theme::mutedInk());
  ask_->setText(tr("Type the code %1 to confirm:").arg(harmless(code_)));
  typed_->setAccessibleName(tr("Code of the participant"));
  typed_->setMinimumHeight(4 * theme::kGrid);
  ask_->setBuddy(typed_);
  setInk(*trouble_, theme::errorInk());
  trouble_->hide();
  keep_->setDefault(true);
  withdraw_->setAutoDefault(false);
  for (QPushButton* button : {keep_, withdraw_}) {
    button->setMinimumSize(button->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
  }

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(theme::kGrid);
  buttons->addStretch(1);
  buttons->addWidget(withdraw_);
  buttons->addWidget(keep_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * theme::kGrid, 3 * theme::kGrid, 3 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(2 * theme::kGrid);
  layout->addWidget(title_);
  layout->addWidget(text_);
  layout->addLayout(counts_);
  layout->addWidget(stays_);
  layout->addWidget(ask_);
  layout->addWidget(typed_);
  layout->addWidget(trouble_);
  layout->addLayout(buttons);
}

void WithdrawalDialog::showPreview(const store::WithdrawalPreview& preview) {
  const auto number = [](long long count) { return static_cast<int>(count); };
  const std::pair<QString, long long> counts[] = {
      {tr("session(s)", nullptr, number(preview.sessions)), preview.sessions},
      {tr("insertion(s)", nullptr, number(preview.strokes)), preview.strokes},
      {tr("judgement(s) of forces", nullptr, number(preview.judgements)), preview.judgements},
      {tr("answer(s) to questions", nullptr, number(preview.answers)), preview.answers},
      {tr("statement(s) about the person", nullptr, number(preview.profiles)), preview.profiles},
      {tr("rating(s)", nullptr, number(preview.ratings)), preview.ratings},
      {tr("rule(s) given directly", nullptr, number(preview.rules)), preview.rules},
      {tr("recording(s) of feeling", nullptr, number(preview.feel_recordings)), preview.feel_recordings},
  };
  int place = 0;
  for (const auto& [what, count] : counts) {
    if (count == 0) continue;
    auto* amount = plain(this);
    amount->setText(QString::number(count));
    amount->setFont(theme::headingFont());
    auto* name = plain(this);
    name->setText(what);
    amount->setWordWrap(false);
    name->setWordWrap(false);
    amount->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    counts_->addWidget(amount, place / kPairs, 2 * (place % kPairs));
    counts_->addWidget(name, place / kPairs, 2 * (place % kPairs) + 1);
    // Shown at once, so that they count for the height.
    amount->show();
    name->show();
    ++place;
  }
  if (place == 0) text_->setText(tr("Nothing but the code is stored of this participant. It is deleted for good."));
  QString stays;
  if (preview.models_cleaned > 0) {
    stays += tr("%n version(s) of models stay without the rules of this participant.", nullptr,
                static_cast<int>(preview.models_cleaned)) +
             QLatin1Char(' ');
  }
  if (preview.models_kept > 0) {
    stays += tr("%n version(s) of models stay as they are; the participant may have taken part in their terms.",
                nullptr, static_cast<int>(preview.models_kept)) +
             QLatin1Char(' ');
  }
  stays_->setText(stays + tr("Backups and exports made before can still hold the data."));
  counted_ = true;
  showState();
  fit();
}

// As high as its sentences need.
void WithdrawalDialog::fit() {
  layout()->activate();
  const int width = appearance::scaled(kWidth);
  setFixedSize(width, layout()->totalHeightForWidth(width));
}

// However it is written: `Velvet Otter` is `velvet-otter`.
bool WithdrawalDialog::isConfirmed() const {
  return !typed_->text().isEmpty() &&
         study::codeKey(typed_->text().toStdString()) == study::codeKey(code_.toStdString());
}

void WithdrawalDialog::showState() {
  const bool busy = collect_.isWithdrawing();
  withdraw_->setEnabled(counted_ && !busy && isConfirmed());
  withdraw_->setText(busy ? tr("Deleting…") : tr("Withdraw and &delete"));
  typed_->setEnabled(!busy);
  keep_->setEnabled(!busy);
}

}  // namespace tactus::workbench
