#include "app/workbench/collect/collect_view.h"

#include <utility>

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
  connect(home_, &StudyHome::withdrawAsked, this, &CollectView::askWithdrawal);
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

void CollectView::askWithdrawal(const study::RecordId& person) {
  auto* dialog = new WithdrawalDialog(collect_, person, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace tactus::workbench
