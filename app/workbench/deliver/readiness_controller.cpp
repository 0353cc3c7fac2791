#include "app/workbench/deliver/readiness_controller.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <utility>

#include "app/editing/step_fixes.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/deliver/bundle_maker.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "elicitation/model/published_settings.h"

namespace tactus::workbench {
namespace {

/// The last sign-off of `state`; null if there is none.
const editing::Event* signOffOf(const editing::EditHistory& history, editing::StateId state) {
  const auto& events = history.events();
  const auto event = std::find_if(events.rbegin(), events.rend(), [state](const editing::Event& one) {
    return one.kind == editing::EventKind::kSignOff && one.state == state;
  });
  return event == events.rend() ? nullptr : &*event;
}

/// Edits on the way to the current state since a state that was signed off, or since the first.
std::size_t unsignedEdits(const editing::EditHistory& history) {
  std::vector<bool> signed_off(history.states().size());
  for (const editing::Event& event : history.events()) {
    if (event.kind == editing::EventKind::kSignOff) signed_off[event.state] = true;
  }
  std::size_t edits = 0;
  editing::StateId state = history.current();
  for (; !signed_off[state] && history.states()[state].parent; state = *history.states()[state].parent) ++edits;
  return edits;
}

/// The texts of a JSON list of texts; empty for other JSON.
QStringList textsIn(const std::string& json) {
  QStringList out;
  for (const QJsonValue value : QJsonDocument::fromJson(QByteArray::fromStdString(json)).array())
    out << harmless(value.toString());
  return out;
}

void addOrigin(const fuzzy::Provenance& origin, const std::string& unit, ReadinessFacts& facts) {
  for (const auto& name : elicitation::settingsUnlikePublished(origin)) facts.unlike_published << text(name);
  if (const auto newtons = elicitation::newtonsUnlikePublished(origin))
    facts.newtons_unlike_published = forceText(*newtons, unit);
  for (const fuzzy::NamedJson& source : origin.sources) {
    if (source.key == "virtual") facts.without_force = textsIn(source.json);
  }
}

}  // namespace

ReadinessController::ReadinessController(const ModelController& models, EditController& edits, const BundleMaker& maker,
                                         QObject* parent)
    : QObject(parent), models_(models), edits_(edits), maker_(maker) {
  connect(&edits_, &EditController::modelReset, this, &ReadinessController::update);
  connect(&edits_, &EditController::historyChanged, this, &ReadinessController::update);
  connect(&models_, &ModelController::edited, this, &ReadinessController::update);
  connect(&maker_, &BundleMaker::changed, this, &ReadinessController::update);
}

void ReadinessController::setFindings(DeliverFindings findings) {
  if (findings == findings_) return;
  findings_ = std::move(findings);
  update();
}

void ReadinessController::setNotes(BuildNotes notes) {
  if (notes == notes_) return;
  notes_ = std::move(notes);
  update();
}

bool ReadinessController::blocks() const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [](const ReadinessLine& line) { return line.state == Readiness::kBlocks; });
}

void ReadinessController::acceptHole(const std::string& name) {
  if (edits_.isOpen()) edits_.apply(editing::acceptHole(edits_.model(), name));
}

ReadinessFacts ReadinessController::facts() const {
  const fuzzy::ForceModel& model = edits_.model();
  const editing::EditHistory& history = edits_.history();
  ReadinessFacts facts;
  facts.findings = findings_;
  facts.experts = model.experts.size();
  facts.default_force = forceText(model.default_force_n, model.output.unit);
  facts.edits = unsignedEdits(history);
  const editing::Event* const sign_off = edits_.inGesture() ? nullptr : signOffOf(history, history.current());
  if (sign_off != nullptr) {
    facts.signed_by = text(sign_off->stamp.author);
    facts.signed_felt = editing::saysFelt(sign_off->label);
  }
  facts.simulated = models_.current() && models_.current()->simulated;
  facts.data_notes = notes_.data.size();
  facts.build_notes = notes_.build.size();
  if (!notes_.data.empty()) facts.first_note = notes_.data.front().sentence;
  facts.origin_known = model.provenance.has_value();
  if (model.provenance) addOrigin(*model.provenance, model.output.unit, facts);
  if (const auto& delivered = maker_.delivered())
    facts.bundle = {shownFileName(delivered->folder), delivered->ok, maker_.isOld()};
  return facts;
}

void ReadinessController::update() {
  lines_ = edits_.isOpen() ? readinessLines(facts()) : std::vector<ReadinessLine>();
  emit changed();
}

}  // namespace tactus::workbench
