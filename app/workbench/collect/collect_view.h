// The screen of stage Collect: the study's home, and the pages behind it.
#pragma once

#include <QStackedWidget>
#include <functional>

#include "app/workbench/collect/collect_controller.h"

namespace tactus::workbench {

class ProtocolController;
class ProtocolView;
class StudyHome;

class CollectView : public QStackedWidget {
  Q_OBJECT

 public:
  /// `author`: the name that a stored protocol bears; may be empty.
  CollectView(CollectController& collect, ProtocolController& protocol, std::function<QString()> author,
              QWidget* parent = nullptr);

  StudyHome& home() { return *home_; }
  ProtocolView& protocolPage() { return *protocol_; }

 public slots:
  void showHome();
  void showProtocol();
  /// The part of the protocol's page with the research key.
  void showKey();
  /// Asks how many simulated nurses are added to the study, and how alike they are.
  void askFill();
  /// Asks in a dialog whether `person` is withdrawn.
  void askWithdrawal(const tactus::study::RecordId& person);
  void showRecord(const tactus::study::RecordId& person);
  /// Asks for the files that the web form saved.
  void askAnswers();

 private:
  CollectController& collect_;
  StudyHome* home_;
  ProtocolView* protocol_;
};

}  // namespace tactus::workbench
