// The screen of stage Collect: the study's home, the pages behind it, and the record of a participant.
#pragma once

#include <QDialog>
#include <QStackedWidget>
#include <functional>
#include <optional>

#include "app/workbench/base/columns.h"
#include "app/workbench/collect/collect_controller.h"

class QCheckBox;
class QLabel;
class QTableView;

namespace tactus::workbench {

class ProtocolController;
class ProtocolView;
class StudyHome;

/// The record of one participant as a table: what was asked, what was said, and what is remarkable about it.
class RecordDialog : public QDialog {
  Q_OBJECT

 public:
  /// `collect` outlives this. Reads the record at once, and again when the study changes. `at`: the line that is chosen
  /// first.
  RecordDialog(CollectController& collect, const study::RecordId& person, std::optional<study::RecordId> at,
               QWidget* parent = nullptr);

  const std::vector<RecordLine>& lines() const { return table_.rows(); }
  /// The chosen line, or -1.
  int chosen() const;

 private:
  void read();
  void setLines(std::vector<RecordLine> lines);
  void filter();

  CollectController& collect_;
  const study::RecordId person_;
  std::vector<RecordLine> all_;
  Columns<RecordLine> table_;
  std::optional<study::RecordId> at_;
  QTableView* view_;
  QLabel* summary_;
  QCheckBox* log_;
};

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
  /// The record of `person`; `at`: the line that is chosen in it.
  void showRecord(const tactus::study::RecordId& person, std::optional<tactus::study::RecordId> at = std::nullopt);
  /// Asks for the files that the web form saved.
  void askAnswers();

 private:
  CollectController& collect_;
  StudyHome* home_;
  ProtocolView* protocol_;
};

}  // namespace tactus::workbench
