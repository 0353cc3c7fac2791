#include "app/workbench/collect/protocol_controller.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/session/study_procedure.h"
#include "app/session/study_protocol.h"
#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/store/research_key.h"
#include "core/store/study_records.h"

namespace tactus::workbench {
namespace {

using base::Result;
using session::StudyProtocol;

struct ReadProtocol {
  StudyProtocol protocol;
  int version = 0;
  bool locked = false;
  bool has_key = false;
};

Result<ReadProtocol> readProtocol(const store::StudyFile& file) {
  TACTUS_TRY(const auto state, store::protocolState(file));
  ReadProtocol out;
  if (state.current) {
    TACTUS_TRY(auto protocol, session::protocolOf(file, *state.current));
    out.protocol = std::move(protocol);
    out.version = state.current->version;
    out.locked = state.locked;
  } else {
    out.protocol.consent_version = "1";
  }
  TACTUS_TRY(const auto has_key, store::hasResearchKey(file));
  out.has_key = has_key;
  return out;
}

std::map<std::string, QString> valuesOf(const StudyProtocol& protocol) {
  std::map<std::string, QString> out;
  for (const session::ProtocolValue& value : session::protocolValues(protocol)) out[value.name] = text(value.value);
  return out;
}

// Beside its field, the error need not say where it is.
QString sentence(const base::Error& error) {
  return ProtocolController::tr("Found %1, wanted %2.").arg(text(error.found), text(error.wanted));
}

QString found(const std::map<std::string, QString>& values, const std::string& name) {
  const auto at = values.find(name);
  return at == values.end() ? QString() : at->second;
}

}  // namespace

std::string fieldOf(const base::Error& error, const std::map<std::string, QString>& known) {
  std::string place = error.place;
  std::replace(place.begin(), place.end(), '/', '.');
  constexpr std::string_view kLanguage = "language '";
  if (place.starts_with(kLanguage) && place.ends_with('\'')) {
    return "consent." + place.substr(kLanguage.size(), place.size() - kLanguage.size() - 1);
  }
  if (place == "device") return "device.force_cap_n";
  if (place == "session") return "blocks";
  for (const char* const group : {"", "force.", "speed.", "speed.stroke."}) {
    if (known.contains(group + place)) return group + place;
  }
  return {};
}

ProtocolController::ProtocolController(StudyConnection& study, QObject* parent) : QObject(parent), study_(study) {
  connect(&study_, &StudyConnection::opened, this, &ProtocolController::read);
  connect(&study_, &StudyConnection::closed, this, [this] {
    ready_ = false;
    setStored({}, 0, false, false);
  });
}

void ProtocolController::read() {
  study_.read(*this, [this, path = study_.path()](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto read = std::make_shared<Result<ReadProtocol>>(readProtocol(file));
    return [this, path, read] {
      if (path != study_.path()) return;
      if (!*read) {
        emit notRead(tr("The protocol of %1 was not read. %2").arg(study_.fileName(), text(read->error().message())));
        return;
      }
      ready_ = true;
      setStored((*read)->protocol, (*read)->version, (*read)->locked, (*read)->has_key);
    };
  });
}

void ProtocolController::setStored(const StudyProtocol& protocol, int version, bool locked, bool has_key) {
  stored_ = draft_ = protocol;
  stored_values_ = valuesOf(stored_);
  version_ = version;
  locked_ = locked;
  has_key_ = has_key;
  unreadable_.reset();
  look();
}

QString ProtocolController::value(const std::string& name) const { return found(values_, name); }

QString ProtocolController::storedValue(const std::string& name) const { return found(stored_values_, name); }

void ProtocolController::usePreset(const std::string& id) {
  if (!ready_) return;
  unreadable_.reset();
  if (auto next = session::withPreset(draft_, id)) draft_ = std::move(*next);
  look();
}

void ProtocolController::set(const std::string& name, const QString& value) {
  if (!ready_) return;
  unreadable_.reset();
  auto next = session::withProtocolValue(draft_, name, value.toStdString());
  if (next) {
    draft_ = std::move(*next);
  } else {
    unreadable_ = ProtocolProblem{name, sentence(next.error())};
  }
  look();
}

void ProtocolController::reset(const std::string& name) { set(name, storedValue(name)); }

void ProtocolController::discard() {
  draft_ = stored_;
  unreadable_.reset();
  look();
}

int ProtocolController::changes() const {
  int count = 0;
  for (const auto& [name, value] : values_) count += value != storedValue(name) ? 1 : 0;
  return count;
}

void ProtocolController::look() {
  values_ = valuesOf(draft_);
  problem_ = unreadable_;
  if (!problem_ && ready_) {
    if (const auto valid = session::validate(draft_); !valid) {
      const std::string field = fieldOf(valid.error(), values_);
      problem_ = ProtocolProblem{field, field.empty() ? text(valid.error().message()) : sentence(valid.error())};
    }
  }
  emit changed();
}

void ProtocolController::store(const QString& reason, const QString& author) {
  if (!ready_ || storing_ || !study_.takesOrders()) return;
  storing_ = true;
  emit changed();
  const auto record = std::make_shared<study::ProtocolRecord>();
  study_.order(
      [record, protocol = draft_, reason = reason.trimmed().toStdString(), author = author.toStdString()](
          store::StudyFile& file, study::RecordIds& ids) -> Result<void> {
        session::SessionTools tools = session::systemTools();
        tools.ids = ids;
        auto set = session::setProtocol(file, protocol, author, reason, tools);
        ids = tools.ids;
        if (!set) return tl::unexpected(set.error());
        *record = std::move(*set);
        return {};
      },
      [this, record] {
        storing_ = false;
        emit stored(record->version);
        read();
        study_.refresh();
      },
      [this](const QString& sentence) {
        storing_ = false;
        emit refused(tr("The protocol stays as it was. %1").arg(sentence));
        look();
      });
}

void ProtocolController::setKey(const QString& passphrase) {
  if (!ready_ || !study_.takesOrders()) return;
  study_.order(
      [key = passphrase.toStdString()](store::StudyFile& file, study::RecordIds&) {
        return store::setResearchKey(file, key, utcNowMs());
      },
      [this, is_set = !passphrase.isEmpty()] {
        has_key_ = is_set;
        emit keyStored(is_set);
        look();
        study_.refresh();
      },
      [this](const QString& sentence) { emit keyRefused(tr("The research key stays as it was. %1").arg(sentence)); });
}

}  // namespace tactus::workbench
