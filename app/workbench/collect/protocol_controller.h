// The settings of the study's protocol while they are edited: what is stored, the edited one, what is wrong with it,
// and storing it as a draft or as an amendment. Values go by the names of session/study_protocol.h.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <optional>
#include <string>

#include "app/session/study_protocol.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

/// What keeps a protocol from being stored.
struct ProtocolProblem {
  std::string field;  ///< name of the value that it is about; empty: the whole
  QString sentence;

  bool operator==(const ProtocolProblem&) const = default;
};

/// Thread: gui.
class ProtocolController : public QObject {
  Q_OBJECT

 public:
  /// `study` outlives this.
  explicit ProtocolController(StudyConnection& study, QObject* parent = nullptr);

  /// The study's protocol is read.
  bool isReady() const { return ready_; }
  /// Whether a version can be stored: the study is read, and open for writing.
  bool mayStore() const { return ready_ && study_.takesOrders(); }
  const session::StudyProtocol& draft() const { return draft_; }
  /// Of the stored protocol; 0: none was set.
  int version() const { return version_; }
  /// Participants follow the stored version: a change is an amendment and needs a reason.
  bool isLocked() const { return locked_; }
  bool hasKey() const { return has_key_; }
  bool isStoring() const { return storing_; }

  /// The edited and the stored value of `name`.
  QString value(const std::string& name) const;
  QString storedValue(const std::string& name) const;
  /// Changes a value. What is no value of its kind changes nothing and is the problem of its field until the next
  /// `set`.
  void set(const std::string& name, const QString& value);
  /// Sets the values of a preset (session::protocolPresets); the others stay.
  void usePreset(const std::string& id);
  /// Back to the stored value.
  void reset(const std::string& name);
  /// Back to the stored protocol.
  void discard();
  bool isChanged(const std::string& name) const { return value(name) != storedValue(name); }
  int changes() const;
  /// There is something to store: a change, or no protocol yet.
  bool isDirty() const { return version_ == 0 || changes() > 0; }
  const std::optional<ProtocolProblem>& problem() const { return problem_; }
  /// Nothing is stored and nothing was typed: what is missing is no mistake yet.
  bool isNew() const { return version_ == 0 && !unreadable_ && changes() == 0; }

  /// Stores the draft. `reason`: of an amendment. Ends with `stored` or `refused`.
  void store(const QString& reason, const QString& author);
  /// Sets the research key, or removes it where it is empty. Ends with `keyStored` or `refused`.
  void setKey(const QString& passphrase);

 public slots:
  /// Reads the protocol of the study; the edited one is forgotten.
  void read();

 signals:
  void changed();
  void stored(int version);
  void keyStored(bool is_set);
  /// One sentence: what was not stored or read, and why.
  void refused(const QString& sentence);
  void notRead(const QString& sentence);
  void keyRefused(const QString& sentence);

 private:
  using Values = std::map<std::string, QString>;
  void setStored(const session::StudyProtocol& protocol, int version, bool locked, bool has_key);
  void look();

  StudyConnection& study_;
  session::StudyProtocol stored_;
  session::StudyProtocol draft_;
  Values stored_values_;
  Values values_;
  std::optional<ProtocolProblem> unreadable_;  ///< of the last `set`
  std::optional<ProtocolProblem> problem_;
  int version_ = 0;
  bool locked_ = false;
  bool has_key_ = false;
  bool ready_ = false;
  bool storing_ = false;
};

/// The name of the value that `error` of session::validate is about; empty: none of `known`.
std::string fieldOf(const base::Error& error, const std::map<std::string, QString>& known);

}  // namespace tactus::workbench
