#include <QAction>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/duel/duel_window.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/tune/history/history_panel.h"

namespace tactus::workbench {
namespace {

struct DuelFeature {
  Q_DECLARE_TR_FUNCTIONS(DuelFeature)
};

constexpr double kHalfWayMm = 30;  // of the proposed stroke, around the operating point
constexpr double kUsualSpeedMmS = 60;
constexpr double kSlowestMmS = 20;
constexpr double kFastestMmS = 150;

/// Whether `choice` is the open model in its current state, with all its experts.
bool isOpen(const Bench& bench, const CompareChoice& choice) {
  return choice.kind == CompareChoice::Kind::kOpen ||
         (choice.kind == CompareChoice::Kind::kState && choice.state == bench.edits.history().current());
}

study::DuelModel keptName(Bench& bench, CompareSide side, const OpenModel& model) {
  const CompareChoice& choice = bench.compare.choice(side);
  study::DuelModel out;
  out.name = bench.compare.nameOf(choice).toStdString();
  if (isOpen(bench, choice)) {
    out.version = bench.study_models.modelVersion();
  } else if (model.in_study) {
    out.version = model.version;
  }
  out.expert = model.only_expert;
  return out;
}

/// The two sides of the comparison, on a stroke around the operating point.
base::Result<DuelSetup> setupOf(Bench& bench) {
  DuelSetup out;
  TACTUS_TRY(out.a, bench.compare.modelOf(CompareSide::kA));
  TACTUS_TRY(out.b, bench.compare.modelOf(CompareSide::kB));
  out.a_name = keptName(bench, CompareSide::kA, *out.a);
  out.b_name = keptName(bench, CompareSide::kB, *out.b);
  if (isOpen(bench, bench.compare.choice(CompareSide::kB))) {
    out.open_is_b = true;
  } else if (isOpen(bench, bench.compare.choice(CompareSide::kA))) {
    out.open_is_b = false;
  }
  const auto& inputs = out.a->model.inputs;
  const auto depth = fuzzy::wayOf(inputs);
  const auto speed = fuzzy::rateOf(inputs);
  if (!depth) {
    return base::fail(base::ErrorCode::kReference, DuelFeature::tr("the model").toStdString(),
                      DuelFeature::tr("no way of the tip").toStdString(),
                      DuelFeature::tr("a model along the tool").toStdString());
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isMovedByHand(inputs[i])) out.conditions[inputs[i].id] = bench.scene.value(i);
  }
  const fuzzy::Variable& along = inputs[*depth];
  const double middle_mm =
      std::max(along.min + kHalfWayMm, std::min(bench.scene.value(*depth), along.max - kHalfWayMm));
  out.from_mm = middle_mm - kHalfWayMm;
  out.to_mm = middle_mm + kHalfWayMm;
  const double speed_mm_s = speed ? bench.scene.value(*speed) : 0;
  out.speed_mm_s = speed_mm_s >= kSlowestMmS && speed_mm_s <= kFastestMmS ? speed_mm_s : kUsualSpeedMmS;
  return out;
}

/// The stroke that tells the two apart, at its speed where they differ most: the hand keeps one speed.
void takeStroke(const Told& told, DuelSetup& setup) {
  const contracts::Stroke& stroke = told.found.stroke;
  const auto& inputs = setup.a->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isMovedByHand(inputs[i])) setup.conditions[inputs[i].id] = stroke.inputs[i];
  }
  setup.from_mm = stroke.from_mm;
  setup.to_mm = stroke.to_mm;
  const auto most = std::min_element(told.moments.begin(), told.moments.end(), [&](const auto& one, const auto& other) {
    const double at_mm = told.found.feel.at_mm;
    return std::abs(one.at.depth_mm - at_mm) < std::abs(other.at.depth_mm - at_mm);
  });
  setup.speed_mm_s = most->at.speed_mm_s;
}

}  // namespace

void addDuel(Bench& bench) {
  QObject* const context = &bench.features;
  auto* window = new DuelWindow(bench.duel, bench.device, bench.study, &bench.window);
  QAction* const action =
      bench.window.menus().addAction(MenuSlot::kEditCompare, DuelFeature::tr("&Feel blind: A against B…"));
  const auto state = std::make_shared<editing::StateId>(0);  // of the open model when the duel was planned
  const auto propose = [&bench, window, state](const Told* told) {
    if (!bench.edits.isOpen()) return;
    bench.edits.commit();
    bench.feel.stop();
    auto setup = setupOf(bench);
    if (!setup) {
      bench.window.say(text(setup.error().message()));
      return;
    }
    if (told != nullptr) takeStroke(*told, *setup);
    *state = bench.edits.history().current();
    window->propose(*std::move(setup), bench.author.name());
    window->show();
    window->raise();
    window->activateWindow();
  };
  const auto propose_here = [propose] { propose(nullptr); };
  QObject::connect(action, &QAction::triggered, context, propose_here);
  QObject::connect(bench.views.history, &HistoryPanel::feelBlindRequested, context, propose_here);
  QObject::connect(&bench.tell, &TellController::duelAsked, context, [&bench, propose] { propose(bench.tell.told()); });
  QObject::connect(
      window, &DuelWindow::approved, context, [&bench, state](const QString& who, const editing::Felt& felt) {
        if (!bench.edits.isOpen() || bench.edits.history().current() != *state) {
          bench.window.say(
              DuelFeature::tr("Not signed off: the open model is not the one that was felt any more. Return to "
                              "that state in History first."));
          return;
        }
        bench.edits.signOff(who, felt);
      });
  // Without the window the user cannot stop the force.
  QObject::connect(&bench.window, &MainWindow::closing, &bench.duel, &DuelController::stop);
  const auto show_action = [action, &edits = bench.edits] { action->setEnabled(edits.isOpen()); };
  QObject::connect(&bench.edits, &EditController::modelReset, context, show_action);
  show_action();
}

namespace {

struct MarksFeature {
  Q_DECLARE_TR_FUNCTIONS(MarksFeature)
};

/// The state of the history that the study keeps as `version`.
std::optional<editing::StateId> stateOf(const Bench& bench, const std::optional<study::RecordId>& version) {
  if (!version || !bench.edits.isOpen()) return std::nullopt;
  const auto& events = bench.edits.history().events();
  const auto event = std::find_if(events.begin(), events.end(), [&](const auto& one) { return one.id == *version; });
  return event == events.end() ? std::nullopt : std::optional(event->state);
}

}  // namespace

void addMarks(Bench& bench) {
  QObject* const context = &bench.features;
  bench.views.feel->addCard(MarksFeature::tr("Marks"), new MarksCard(bench.marks, bench.feel));
  QAction* const mark =
      bench.window.menus().addAction(MenuSlot::kFeelPatient, MarksFeature::tr("&Mark this moment"), Qt::Key_F7);
  QObject::connect(mark, &QAction::triggered, &bench.marks, &FeelMarks::mark);
  QObject::connect(&bench.marks, &FeelMarks::said, context,
                   [&window = bench.window](const QString& sentence) { window.say(sentence); });
  QObject::connect(&bench.marks, &FeelMarks::differs, context,
                   [&bench](const QString& sentence, const std::optional<study::RecordId>& version) {
                     const auto state = stateOf(bench, version);
                     if (!state) return bench.window.say(sentence);
                     CompareChoice felt;
                     felt.kind = CompareChoice::Kind::kState;
                     felt.state = *state;
                     bench.window.banner().showRemedy(
                         sentence, {MarksFeature::tr("Show the version that was felt"), [&bench, felt] {
                                      bench.compare.choose(CompareSide::kB, felt);
                                      bench.compare.show(CompareSide::kB);
                                    }});
                   });
  const auto show_action = [mark, &feel = bench.feel] { mark->setEnabled(feel.isRunning()); };
  QObject::connect(&bench.feel, &FeelController::stateChanged, context, show_action);
  show_action();
}

}  // namespace tactus::workbench
