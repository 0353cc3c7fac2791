#include "app/workbench/collect/collect_view.h"

#include <QComboBox>
#include <QRandomGenerator>
#include <QSpinBox>
#include <utility>

#include "app/workbench/base/file_dialog.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/kit/form_dialog.h"

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
  connect(home_, &StudyHome::recordAsked, this, [this](const study::RecordId& person) { showRecord(person); });
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
  auto* const count = new QSpinBox(this);
  count->setRange(1, session::SimulatedGroup::kMost);
  count->setValue(4);
  auto* const alike = new QComboBox(this);
  alike->addItem(tr("as alike as the published nurses"), 1.0);
  alike->addItem(tr("more different"), 0.5);
  alike->addItem(tr("very different"), 0.0);
  FormDialog dialog(
      tr("Fill with simulated nurses"),
      tr("For a rehearsal: each does a whole session under the protocol of this study. They are marked as simulated in "
         "the file, in this list and in every export, and count in a model until they are withdrawn."),
      {{tr("&How many"), count}, {tr("How &alike"), alike}}, tr("Add them"), this);
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

void CollectView::showRecord(const study::RecordId& person, std::optional<study::RecordId> at) {
  auto* dialog = new RecordDialog(collect_, person, std::move(at), window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void CollectView::askAnswers() {
  collect_.importAnswers(file_dialog::getOpenFileNames(this, tr("Answer files of the web form"), {},
                                                       tr("Answer files (*.tactus-answers.json);;All files (*)")));
}

}  // namespace tactus::workbench
