#include "app/workbench/deliver/readiness.h"

#include <QCoreApplication>
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

void ReadinessController::setContracts(DeliverContracts contracts) {
  if (contracts == contracts_) return;
  contracts_ = std::move(contracts);
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
  facts.contracts = contracts_;
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

namespace {

struct ReadinessText {
  Q_DECLARE_TR_FUNCTIONS(ReadinessText)
};

using Topic = ReadinessTopic;

ReadinessLine holes(const ReadinessFacts& facts) {
  const DeliverFindings& found = facts.findings;
  ReadinessLine line{
      Topic::kHoles, Readiness::kReady, ReadinessText::tr("Holes"), {}, ReadinessText::tr("Show findings")};
  const auto open =
      std::count_if(found.holes.begin(), found.holes.end(), [](const auto& hole) { return !hole.accepted; });
  if (!found.current) {
    line.state = Readiness::kUnknown;
    line.sentence = ReadinessText::tr("Looking for places without a force…");
  } else if (open > 0) {
    line.state = Readiness::kBlocks;
    line.sentence = ReadinessText::tr("No rule fires at %n place(s): add a rule there, or accept each by its name.",
                                      nullptr, static_cast<int>(open));
  } else if (!found.complete) {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("The model is too finely divided to find every place without a force; there may be more.");
  } else if (!found.holes.empty()) {
    line.sentence = ReadinessText::tr("At %n accepted place(s) no rule fires; the force there is %1.", nullptr,
                                      static_cast<int>(found.holes.size()))
                        .arg(facts.default_force);
  } else {
    line.sentence = ReadinessText::tr("Every place has a force.");
  }
  return line;
}

ReadinessLine forceSteps(const ReadinessFacts& facts) {
  ReadinessLine line{Topic::kForceSteps,
                     Readiness::kReady,
                     ReadinessText::tr("Steps of the force"),
                     {},
                     ReadinessText::tr("Show findings")};
  if (!facts.findings.current) {
    line.state = Readiness::kUnknown;
    line.sentence = ReadinessText::tr("Looking for steps of the force…");
  } else if (facts.findings.steps > 0) {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("At %n place(s) the force steps within 1 mm or faster than it can be rendered, by up to %1.",
                          nullptr, static_cast<int>(facts.findings.steps))
            .arg(facts.findings.largest_step);
  } else {
    line.sentence = ReadinessText::tr("The force steps nowhere by more than can be felt.");
  }
  return line;
}

ReadinessLine conflicts(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kConflicts, Readiness::kReady, ReadinessText::tr("Conflicts"), {}, ReadinessText::tr("Show findings")};
  if (!facts.findings.current) {
    line.state = Readiness::kUnknown;
    line.sentence = ReadinessText::tr("Looking for rules that contradict each other…");
  } else if (facts.findings.conflicts > 0) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr("%n pair(s) of rules have the same conditions and different forces.", nullptr,
                                      static_cast<int>(facts.findings.conflicts));
  } else {
    line.sentence = ReadinessText::tr("No two rules of an expert contradict each other.");
  }
  return line;
}

ReadinessLine apart(const ReadinessFacts& facts) {
  ReadinessLine line{Topic::kExpertsApart,
                     Readiness::kReady,
                     ReadinessText::tr("Experts apart"),
                     {},
                     ReadinessText::tr("Show findings")};
  if (facts.experts < 2) {
    line.sentence = ReadinessText::tr("The model is of one expert.");
  } else if (!facts.findings.current) {
    line.state = Readiness::kUnknown;
    line.sentence = ReadinessText::tr("Comparing the experts…");
  } else if (facts.findings.apart > 0) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr(
                        "At %n place(s) two experts are more than two just-noticeable differences apart, by up to %1.",
                        nullptr, static_cast<int>(facts.findings.apart))
                        .arg(facts.findings.most_apart);
  } else {
    line.sentence = ReadinessText::tr("No two experts are more than two just-noticeable differences apart.");
  }
  return line;
}

ReadinessLine contractsOf(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kContracts, Readiness::kReady, ReadinessText::tr("Contracts"), {}, ReadinessText::tr("Show contracts")};
  const DeliverContracts& found = facts.contracts;
  const auto all = static_cast<int>(found.proved + found.broken + found.open);
  if (!found.current) {
    line.state = Readiness::kUnknown;
    line.sentence = ReadinessText::tr("Checking the contracts…");
  } else if (found.broken > 0) {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("The model breaks %1 of %n contract(s), so a bundle of it fails its own check, first: %2.",
                          nullptr, all)
            .arg(QString::number(found.broken), found.first_broken);
  } else if (found.open > 0) {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("Of %n contract(s), %1 could be neither proved nor refuted.", nullptr, all).arg(found.open);
  } else if (all > 0) {
    line.sentence = ReadinessText::tr("The model keeps %n contract(s) everywhere, proved.", nullptr, all);
  } else {
    line.sentence = ReadinessText::tr("The model has no contract to keep.");
  }
  return line;
}

ReadinessLine signOff(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kSignOff, Readiness::kReady, ReadinessText::tr("Sign-off"), {}, ReadinessText::tr("Sign off…")};
  if (facts.signed_by && !facts.signed_felt) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr("%1 approved this state without feeling it.").arg(*facts.signed_by);
  } else if (facts.signed_by) {
    line.sentence = ReadinessText::tr("%1 signed off this state.").arg(*facts.signed_by);
  } else if (facts.edits > 0) {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("No expert has signed off the last %n edit(s).", nullptr, static_cast<int>(facts.edits));
  } else {
    line.state = Readiness::kLook;
    line.sentence =
        ReadinessText::tr("0 of %n expert(s) have approved this version.", nullptr, static_cast<int>(facts.experts));
  }
  return line;
}

ReadinessLine dataNotes(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kData, Readiness::kReady, ReadinessText::tr("Notes on the data"), {}, ReadinessText::tr("Show notes")};
  const auto on_data = static_cast<int>(facts.data_notes);
  const auto of_build = static_cast<int>(facts.build_notes);
  if (on_data > 0) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr("%n note(s) on the data and %1 of the build, first: %2", nullptr, on_data)
                        .arg(of_build)
                        .arg(facts.first_note);
  } else if (of_build > 0) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr("%n note(s) of the build.", nullptr, of_build);
  } else {
    line.sentence = ReadinessText::tr("The open study has no note on this model.");
  }
  return line;
}

ReadinessLine method(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kMethod, Readiness::kReady, ReadinessText::tr("Method"), {}, ReadinessText::tr("Show origin")};
  if (!facts.origin_known) {
    line.state = Readiness::kLook;
    line.sentence = ReadinessText::tr("The file does not say with which settings the model was built.");
  } else if (facts.unlike_published.isEmpty()) {
    line.sentence = ReadinessText::tr("It was built with the published settings.");
  } else {
    line.state = Readiness::kLook;
    const auto count = static_cast<int>(facts.unlike_published.size());
    const QString names = facts.unlike_published.join(QStringLiteral(", "));
    line.sentence = facts.newtons_unlike_published
                        ? ReadinessText::tr(
                              "%n setting(s) of the build differ from the published ones (%1); as built, "
                              "they move the force by up to %2.",
                              nullptr, count)
                              .arg(names, *facts.newtons_unlike_published)
                        : ReadinessText::tr(
                              "%n setting(s) of the build differ from the published ones (%1); by how much "
                              "they move the force is not known.",
                              nullptr, count)
                              .arg(names);
  }
  return line;
}

ReadinessLine origin(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kOrigin, Readiness::kReady, ReadinessText::tr("Origin of the data"), {}, ReadinessText::tr("Show origin")};
  QStringList sentences;
  if (facts.simulated)
    sentences << ReadinessText::tr("Some data are simulated: the model and the report of the bundle say so.");
  if (!facts.without_force.isEmpty())
    sentences << ReadinessText::tr("VIRTUAL, a device that gives no force: %1.")
                     .arg(facts.without_force.join(QStringLiteral(", ")));
  if (!facts.origin_known) sentences << ReadinessText::tr("The file does not say what data the model is from.");
  if (sentences.isEmpty()) {
    line.sentence = ReadinessText::tr("No data are marked as simulated or as given on a device without force.");
  } else {
    line.state = Readiness::kLook;
    line.sentence = sentences.join(QLatin1Char(' '));
  }
  return line;
}

ReadinessLine checks(const ReadinessFacts& facts) {
  ReadinessLine line{
      Topic::kChecks, Readiness::kLook, ReadinessText::tr("Checks"), {}, ReadinessText::tr("Verify a bundle…")};
  if (!facts.bundle) {
    line.sentence = ReadinessText::tr("No bundle of this model has been made and read back yet.");
  } else if (!facts.bundle->holds) {
    line.sentence = ReadinessText::tr("The bundle %1 does not hold what it promises.").arg(facts.bundle->folder);
  } else if (facts.bundle->old) {
    line.sentence = ReadinessText::tr("The model is not the one in the bundle %1.").arg(facts.bundle->folder);
  } else {
    line.state = Readiness::kReady;
    line.sentence =
        ReadinessText::tr("The bundle %1 was read back: each file is within its tolerance.").arg(facts.bundle->folder);
  }
  return line;
}

}  // namespace

std::vector<ReadinessLine> readinessLines(const ReadinessFacts& facts) {
  return {holes(facts),   forceSteps(facts), conflicts(facts), apart(facts),  contractsOf(facts),
          signOff(facts), dataNotes(facts),  method(facts),    origin(facts), checks(facts)};
}

QString readinessSummary(const std::vector<ReadinessLine>& lines) {
  const auto count = [&](Readiness state) {
    return static_cast<int>(
        std::count_if(lines.begin(), lines.end(), [state](const auto& line) { return line.state == state; }));
  };
  if (const int blocks = count(Readiness::kBlocks); blocks > 0)
    return ReadinessText::tr("%n thing(s) to settle first", nullptr, blocks);
  if (count(Readiness::kUnknown) > 0) return ReadinessText::tr("Looking…");
  if (const int look = count(Readiness::kLook); look > 0)
    return ReadinessText::tr("%n thing(s) open; a bundle can be made", nullptr, look);
  return ReadinessText::tr("Nothing open");
}

QString readinessName(Readiness state) {
  switch (state) {
    case Readiness::kReady: return ReadinessText::tr("Ready");
    case Readiness::kLook: return ReadinessText::tr("To know");
    case Readiness::kBlocks: return ReadinessText::tr("To settle first");
    case Readiness::kUnknown: return ReadinessText::tr("Looking…");
  }
  return {};
}

}  // namespace tactus::workbench
