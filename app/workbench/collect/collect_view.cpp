#include "app/workbench/collect/collect_view.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/file_dialog.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/collect/withdrawal_dialog.h"

namespace tactus::workbench {

CollectView::CollectView(CollectController& collect, ProtocolController& protocol, std::function<QString()> author,
                         QWidget* parent)
    : QStackedWidget(parent),
      collect_(collect),
      home_(new StudyHome(collect, this)),
      protocol_(new ProtocolView(protocol, std::move(author), this)) {
  addWidget(home_);
  addWidget(protocol_);
  connect(home_, &StudyHome::protocolAsked, this, &CollectView::showProtocol);
  connect(home_, &StudyHome::keyAsked, this, &CollectView::showKey);
  connect(protocol_, &ProtocolView::left, this, &CollectView::showHome);
  connect(home_, &StudyHome::fillAsked, this, &CollectView::askFill);
  connect(home_, &StudyHome::withdrawAsked, this, &CollectView::askWithdrawal);
  connect(home_, &StudyHome::recordAsked, this, &CollectView::showRecord);
  connect(&collect_.study(), &StudyConnection::closed, this, &CollectView::showHome);
}

void CollectView::showHome() { setCurrentWidget(home_); }

void CollectView::showProtocol() {
  setCurrentWidget(protocol_);
  protocol_->showSection(0);
}

void CollectView::showKey() {
  showProtocol();
  protocol_->showKey();
}

void CollectView::askFill() {
  QDialog dialog(this);
  dialog.setWindowTitle(tr("Fill with simulated nurses"));
  auto* const text = new QLabel(
      tr("For a rehearsal: each does a whole session under the protocol of this study. They are marked as simulated in "
         "the file, in this list and in every export, and count in a model until they are withdrawn."),
      &dialog);
  text->setWordWrap(true);
  auto* const count = new QSpinBox(&dialog);
  count->setRange(1, session::SimulatedGroup::kMost);
  count->setValue(4);
  auto* const alike = new QComboBox(&dialog);
  alike->addItem(tr("as alike as the published nurses"), 1.0);
  alike->addItem(tr("more different"), 0.5);
  alike->addItem(tr("very different"), 0.0);
  auto* const form = new QFormLayout;
  form->addRow(tr("&How many"), count);
  form->addRow(tr("How &alike"), alike);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Add them"));
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* const column = new QVBoxLayout(&dialog);
  column->addWidget(text);
  column->addLayout(form);
  column->addWidget(buttons);
  constexpr int kWidth = 440;
  dialog.setMinimumWidth(kWidth);
  if (dialog.exec() != QDialog::Accepted) return;
  session::SimulatedGroup group;
  group.count = count->value();
  group.alike = alike->currentData().toDouble();
  group.seed = 1 + QRandomGenerator::global()->generate();
  collect_.fillWithSimulated(group);
}

void CollectView::askWithdrawal(const study::RecordId& person) {
  auto* dialog = new WithdrawalDialog(collect_, person, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void CollectView::showRecord(const study::RecordId& person) {
  auto* dialog = new RecordDialog(collect_, person, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void CollectView::askAnswers() {
  collect_.importAnswers(file_dialog::getOpenFileNames(this, tr("Answer files of the web form"), {},
                                                       tr("Answer files (*.tactus-answers.json);;All files (*)")));
}

}  // namespace tactus::workbench
