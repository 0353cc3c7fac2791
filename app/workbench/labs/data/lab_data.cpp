#include "app/workbench/labs/data/lab_data.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/clock.h"
#include "core/procedure/procedure.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

namespace tactus::workbench {

double usualValue(const procedure::Procedure& procedure, const fuzzy::Variable& input) {
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    if (procedure.inputs[i].id == input.id) return std::clamp(procedure.input_notes[i].usual, input.min, input.max);
  }
  return (input.min + input.max) / 2;
}

std::size_t depthInput(const fuzzy::ForceModel& model) { return fuzzy::wayOf(model.inputs).value_or(0); }

namespace {

/// Moves what was read into `place`.
template <class T>
base::Result<void> readInto(base::Result<T> read, T& place) {
  if (!read) return tl::unexpected(read.error());
  place = std::move(*read);
  return {};
}

}  // namespace

std::string LabStudy::codeOf(const study::RecordId& session) const {
  const auto visit = std::find_if(sessions.begin(), sessions.end(), [&](const auto& one) { return one.id == session; });
  if (visit == sessions.end()) return {};
  const auto person =
      std::find_if(persons.begin(), persons.end(), [&](const auto& one) { return one.id == visit->person; });
  return person == persons.end() ? std::string() : person->code;
}

base::Result<LabStudy> readLabStudy(const store::StudyFile& file) {
  auto view = session::studyForElicitation(file);
  if (!view) return tl::unexpected(view.error());
  LabStudy out;
  if (auto ok = readInto(session::judgedForces(file, *view), out.judged); !ok) return tl::unexpected(ok.error());
  out.answer_ids = std::move(view->answer_ids);
  out.rule_ids = std::move(view->rule_ids);
  out.study = std::move(view->study);
  out.notes = std::move(view->notes);
  out.forms = session::knownForms(procedure::of(out.study));
  // What is wrong with a measurement is told by the lab that measures; the others do without.
  if (auto aside = session::asideOf(file)) out.measured_depths = std::move(aside->measured_depths);
  if (auto ok = readInto(store::persons(file), out.persons); !ok) return tl::unexpected(ok.error());
  if (auto ok = readInto(store::sessions(file), out.sessions); !ok) return tl::unexpected(ok.error());
  if (auto ok = readInto(store::strokes(file, {}, store::Recordings::kLeaveOut), out.strokes); !ok) {
    return tl::unexpected(ok.error());
  }
  if (auto ok = readInto(store::judgements(file), out.judgements); !ok) return tl::unexpected(ok.error());
  if (auto ok = readInto(store::answers(file), out.answers); !ok) return tl::unexpected(ok.error());
  if (auto ok = readInto(store::rules(file), out.rules); !ok) return tl::unexpected(ok.error());
  return out;
}

LabData::LabData(StudyConnection& connection, QObject* parent) : Held(parent), connection_(connection) {
  connect(&connection_, &StudyConnection::opened, this, [this] {
    forget();
    refresh();
  });
  connect(&connection_, &StudyConnection::contentsChanged, this, &LabData::refresh);
  connect(&connection_, &StudyConnection::closed, this, &LabData::forget);
  stale_ = connection_.isOpen();
}

void LabData::setSettings(elicitation::BuildSettings settings) {
  const elicitation::BuildSettings before = std::exchange(settings_, std::move(settings));
  emit settingsEdited(before, settings_);
  emit settingsChanged();
}

namespace {

struct SettingsText {
  Q_DECLARE_TR_FUNCTIONS(SettingsText)
};

QString weightsText(const elicitation::WeightSettings& weights) {
  QString out = text(std::string(name(weights.policy)));
  for (const auto& [who, weight] : weights.table) out += QStringLiteral(" %1 %2").arg(text(who), numberText(weight));
  return out;
}

}  // namespace

QString settingsChange(const elicitation::BuildSettings& before, const elicitation::BuildSettings& after) {
  QStringList parts;
  const auto add = [&parts](const QString& what, const QString& from, const QString& to) {
    if (from != to) parts << QStringLiteral("%1 %2 → %3").arg(what, from, to);
  };
  add(QStringLiteral("α"), numberText(before.speed.alpha), numberText(after.speed.alpha));
  add(QStringLiteral("m"), numberText(before.speed.fcm.m), numberText(after.speed.fcm.m));
  add(SettingsText::tr("trimming"), numberText(before.speed.trim), numberText(after.speed.trim));
  add(SettingsText::tr("centers"), spelled(name(before.speed.centres)), spelled(name(after.speed.centres)));
  add(SettingsText::tr("averaging"), spelled(name(before.averaging)), spelled(name(after.averaging)));
  add(SettingsText::tr("speed terms"), spelled(name(before.terms)), spelled(name(after.terms)));
  add(SettingsText::tr("force words"), spelled(name(before.force_terms)), spelled(name(after.force_terms)));
  add(SettingsText::tr("series"), spelled(before.series), spelled(after.series));
  add(SettingsText::tr("depths"), spelled(name(before.depths)), spelled(name(after.depths)));
  const auto measured = elicitation::DepthsFrom::kMeasured;
  if (before.depths == measured && after.depths == measured && before.measured_depths != after.measured_depths)
    parts << SettingsText::tr("measured depths");
  add(SettingsText::tr("weights"), weightsText(before.weights), weightsText(after.weights));
  return parts.join(QStringLiteral(", "));
}

void LabData::setMeasuredDepths(const elicitation::DepthMeasurement& measured) {
  if (settings_.measured_depths == measured) return;
  const elicitation::BuildSettings before = settings_;
  settings_.measured_depths = measured;
  if (settings_.depths != elicitation::DepthsFrom::kMeasured) return;
  if (before.measured_depths) emit depthsEdited(before);
  emit settingsChanged();
}

std::optional<LabInputs> LabData::inputs() const {
  return study_ == nullptr ? std::nullopt : std::optional(LabInputs{study_, settings_});
}

void LabData::setStudy(std::shared_ptr<const LabStudy> study) {
  if (std::exchange(study_, std::move(study)) != study_) emit studyReplaced();
}

void LabData::setSessionRunning(bool runs) {
  if (std::exchange(runs_, runs) && !runs) refresh();
}

void LabData::refresh() {
  if (!connection_.isOpen()) return;
  stale_ = true;
  read();
}

// Several requests while one is on its way become one more.
void LabData::read() {
  if (!stale_ || reading_ || runs_ || !isHeld() || !connection_.isOpen()) return;
  stale_ = false;
  reading_ = true;
  connection_.read(*this, [this, path = connection_.path()](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto result = readLabStudy(file);
    const QString sentence = result ? QString() : text(result.error().message());
    const auto study = result ? std::make_shared<const LabStudy>(std::move(*result)) : nullptr;
    return [this, path, study, sentence] {
      reading_ = false;
      if (path == connection_.path()) {
        failure_ = sentence;
        setStudy(study);
        // Later ones come from the lab that measures.
        if (study_ != nullptr && study_->measured_depths && !settings_.measured_depths) {
          setMeasuredDepths(*study_->measured_depths);
        }
      }
      read();
      emit studyChanged();
    };
  });
  emit studyChanged();
}

void LabData::forget() {
  setStudy(nullptr);
  failure_.clear();
  stale_ = false;
  reading_ = false;
  settings_ = {};
  emit studyChanged();
  emit settingsChanged();
}

namespace {

/// The last model, whose clusters serve the next one. It keeps no study alive.
struct Kept {
  std::weak_ptr<const LabStudy> study;
  elicitation::SpeedTermSettings with;
  std::shared_ptr<const elicitation::BuiltModel> built;
};

LabModel::Answer build(const LabInputs& from, const RunOf<BuiltStudy>& run, Kept& kept) {
  elicitation::BuildSettings settings = stoppable(from.settings, run.stop);
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const bool clustered =
      kept.built != nullptr && kept.study.lock() == from.study && elicitation::clusterAlike(kept.with, settings.speed);
  const auto go_on = [&run](double share) {
    run.progress(share);
    return !run.stop.stop_requested();
  };
  auto made = elicitation::buildModel(from.study->study, from.study->forms, settings,
                                      clustered ? &kept.built->speeds : nullptr, go_on);
  if (!made) return tl::unexpected(text(made.error().message()));
  settings.speed.fcm.keep_going = {};
  const auto built = std::make_shared<const elicitation::BuiltModel>(std::move(*made));
  kept = {from.study, settings.speed, built};
  return std::make_shared<const BuiltStudy>(BuiltStudy{built, from.study, settings});
}

}  // namespace

elicitation::BuildSettings stoppable(elicitation::BuildSettings settings, const std::stop_token& stop) {
  settings.speed.fcm.keep_going = [stop](const elicitation::FcmProgress&) { return !stop.stop_requested(); };
  return settings;
}

void followLabData(Computation& cell, LabData& data) {
  cell.needs(data);
  QObject::connect(&data, &LabData::studyReplaced, &cell, &Computation::renew);
  QObject::connect(&data, &LabData::settingsChanged, &cell, &Computation::refresh);
}

LabModel::LabModel(LabData& data, QObject* parent)
    : Computed([&data] { return data.inputs(); },
               [kept = std::make_shared<Kept>()](const LabInputs& from, const RunOf<BuiltStudy>& run) {
                 return build(from, run, *kept);
               },
               parent) {
  followLabData(*this, data);
}

}  // namespace tactus::workbench
