// The stroke that tells two versions apart: its window, and what is done with the stroke.
#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <algorithm>
#include <memory>
#include <utility>

#include "app/replay/recorded_strokes.h"
#include "app/replay/stroke_file.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/history/history_panel.h"
#include "core/base/files/file.h"
#include "core/store/batch.h"
#include "core/store/feel_records.h"

namespace tactus::workbench {
namespace {

struct TellFeature {
  Q_DECLARE_TR_FUNCTIONS(TellFeature)

 public:
  static void play(Bench& bench, QDialog& window);
  static void keep(Bench& bench);
  static void keepAsFile(Bench& bench);
};

constexpr std::size_t kPieceSamples = 2000;  // as a recorded hand: two seconds

/// The recording in a session of its own, whole or not at all.
base::Result<void> storeStroke(store::StudyFile& file, study::RecordIds& ids, const study::Recording& recording,
                               const study::FeltSetting& setting) {
  FeelSessions sessions;
  FeelSessions::Visit visit;
  visit.started = study::momentNow();
  visit.device = setting.device;
  visit.device_id = "calculated";
  visit.simulated = true;
  TACTUS_TRY(const auto session, sessions.sessionOf(visit, file, ids));
  const auto entry = [&] {
    study::Entry out;
    out.id = ids.next();
    out.session = session;
    out.when = study::momentNow();
    out.entered_by = study::EnteredBy::kResearcher;
    return out;
  };
  TACTUS_TRY(auto batch, store::Batch::begin(file));
  if (auto ok = store::append(file, study::FeelStart{entry(), setting, 1}); !ok) return tl::unexpected(ok.error());
  int pieces = 0;
  for (std::size_t begin = 0; begin < recording.size(); begin += kPieceSamples) {
    const std::size_t end = std::min(recording.size(), begin + kPieceSamples);
    study::FeelPiece piece{entry(), 1, ++pieces, {recording.sample_rate_hz, {}}, false};
    for (const study::Channel& channel : recording.channels) {
      piece.samples.channels.push_back({channel.name,
                                        channel.unit,
                                        {channel.values.begin() + static_cast<std::ptrdiff_t>(begin),
                                         channel.values.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
    if (auto ok = store::append(file, piece); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = store::append(file, study::FeelEnd{entry(), 1, pieces}); !ok) return tl::unexpected(ok.error());
  return batch.commit();
}

void TellFeature::play(Bench& bench, QDialog& window) {
  const TellController& tell = bench.tell;
  auto recording = replay::calculatedRecording(tell.told()->found.stroke, *tell.question()->a->shared);
  if (!recording) return bench.window.say(tr("The stroke was not played. %1").arg(text(recording.error().message())));
  if (!tell.isOld()) bench.compare.show(CompareSide::kB);
  bench.panels.feel->reveal();
  // It lies over what is to be seen; it comes back at the end.
  window.hide();
  auto* const until_end = new QObject(&window);
  const auto back = [&window, until_end] {
    window.show();
    until_end->deleteLater();
  };
  QObject::connect(&bench.feel_store, &FeelStore::notReplayable, until_end, back);
  QObject::connect(&bench.feel, &FeelController::failed, until_end, back);
  QObject::connect(&bench.feel, &FeelController::stateChanged, until_end, [&bench, back, ran = false]() mutable {
    if (std::exchange(ran, bench.feel.isReplay()) && !ran) back();
  });
  bench.feel_store.play(std::nullopt, *recording);
}

void TellFeature::keep(Bench& bench) {
  if (!bench.study.takesOrders() || !bench.study_models.keepsModel()) return keepAsFile(bench);
  bench.edits.commit();
  const editing::EditHistory& history = bench.edits.history();
  const editing::SharedModel model = history.ready();
  const contracts::Stroke& stroke = bench.tell.told()->found.stroke;
  auto made = replay::calculatedRecording(stroke, *model);
  if (!made) return bench.window.say(tr("The stroke was not kept. %1").arg(text(made.error().message())));
  study::FeltSetting setting;
  setting.device = replay::kNoHand;
  setting.simulated = true;
  setting.model = model->model.name;
  setting.model_version = history.versionOf(history.current());
  for (std::size_t i = 0; i < stroke.inputs.size(); ++i) {
    const fuzzy::Variable& input = model->model.inputs[i];
    if (fuzzy::roleOf(input) == fuzzy::Role::kCondition) setting.conditions[input.id] = stroke.inputs[i];
  }
  bench.study.order(
      [recording = std::make_shared<const study::Recording>(*std::move(made)), setting](
          store::StudyFile& file, study::RecordIds& ids) { return storeStroke(file, ids, *recording, setting); },
      [&bench] {
        bench.window.say(
            tr("The stroke is kept in %1, marked as calculated: the panel Strokes runs it after each edit.")
                .arg(bench.study.fileName()));
        bench.study.refresh();
      },
      [&bench](const QString& sentence) {
        bench.window.banner().showRemedy(tr("The stroke was not kept. %1").arg(sentence),
                                         {tr("Save it as a file…"), [&bench] { keepAsFile(bench); }});
      });
}

void TellFeature::keepAsFile(Bench& bench) {
  const TellController& tell = bench.tell;
  if (tell.told() == nullptr) return;
  const QString path = file_dialog::getSaveFileName(&bench.window, tr("Save the stroke as a file"),
                                                    QStringLiteral("told.strokes.json"), tr("Strokes (*.json)"));
  if (path.isEmpty()) return;
  const std::string name = tr("tells %1 from %2").arg(tell.question()->a_name, tell.question()->b_name).toStdString();
  const auto written = base::writeFileAtomically(
      path.toStdString(), replay::formatStrokes(tell.question()->a->model, {{name, tell.told()->found.stroke}}));
  if (written) return bench.window.say(tr("The stroke is saved in %1.").arg(shownFileName(path)));
  bench.window.banner().showRemedy(tr("The stroke was not saved. %1").arg(text(written.error().message())),
                                   {tr("Save elsewhere…"), [&bench] { keepAsFile(bench); }});
}

}  // namespace

void addTell(Bench& bench) {
  QObject* const context = &bench.features;
  QDialog* const window = makeTellWindow(bench.tell, &bench.window);
  QAction* const action =
      bench.window.menus().addAction(MenuSlot::kEditCompare, TellFeature::tr("Find the stroke that &tells A from B…"));
  const auto ask = [&bench, window] {
    // What was found of the same pair is shown again.
    const bool found = bench.tell.told() != nullptr && !bench.tell.isOld();
    if (!found && !bench.tell.begin()) return;
    window->show();
    window->raise();
    window->activateWindow();
  };
  QObject::connect(action, &QAction::triggered, context, ask);
  QObject::connect(bench.views.history, &HistoryPanel::tellRequested, context, ask);
  QObject::connect(&bench.tell, &TellController::refused, context,
                   [&bench](const QString& sentence) { bench.window.say(sentence); });
  QObject::connect(&bench.tell, &TellController::playAsked, context,
                   [&bench, window] { TellFeature::play(bench, *window); });
  QObject::connect(&bench.tell, &TellController::keepAsked, context, [&bench] { TellFeature::keep(bench); });
  const auto show_action = [action, &edits = bench.edits] { action->setEnabled(edits.isOpen()); };
  QObject::connect(&bench.edits, &EditController::modelReset, context, show_action);
  show_action();
}

}  // namespace tactus::workbench
