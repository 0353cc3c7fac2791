#include <QAction>
#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/undo_keys.h"
#include "app/workbench/tune/history/carry_dialog.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/terms/membership_editor.h"

namespace tactus::workbench {

namespace {

struct HistoryFeature {
  Q_DECLARE_TR_FUNCTIONS(HistoryFeature)
};

// While versions are compared, the curves show the hidden side as their ghost.
void showHiddenSide(Bench& bench) {
  CompareController& compare = bench.compare;
  const auto shown = compare.shown();
  if (!shown) {
    bench.ghost.clearReference();
    return;
  }
  const CompareSide hidden = *shown == CompareSide::kA ? CompareSide::kB : CompareSide::kA;
  const auto model = compare.modelOf(hidden);
  const auto set = model ? bench.ghost.setReference(*model, compare.nameOf(compare.choice(hidden)))
                         : base::Result<void>(tl::unexpected(model.error()));
  if (!set) bench.window.say(text(set.error().message()));
}

}  // namespace

namespace {

// The edits of an earlier version, beside the window; the one under the mouse is the ghost of the curves.
void addCarry(Bench& bench) {
  auto* const dialog = new CarryDialog(bench.carry, &bench.window);
  bench.views.carry = dialog;
  QObject::connect(bench.views.history, &HistoryPanel::carryAsked, dialog, &CarryDialog::bringUp);
  QObject::connect(&bench.carry, &CarryController::previewed, &bench.ghost,
                   [&bench](const std::shared_ptr<const OpenModel>& model, const QString& name) {
                     const bool shown = model && bench.ghost.setReference(model, name);
                     if (!shown) showHiddenSide(bench);
                   });
  QAction* const action =
      bench.window.menus().addAction(MenuSlot::kEditStates, HistoryFeature::tr("Carry earlier edits &over…"));
  QObject::connect(action, &QAction::triggered, dialog, [&bench, dialog] {
    if (const auto earlier = bench.carry.earlier()) return dialog->bringUp(earlier->state);
    bench.window.say(HistoryFeature::tr(
        "No version before the build of this model was edited. Edits of any version: its menu in the panel History."));
  });
  const auto show = [&bench, action] { action->setEnabled(bench.edits.isOpen()); };
  QObject::connect(&bench.edits, &EditController::modelReset, &bench.features, show);
  show();
}

}  // namespace

void addHistory(Bench& bench) {
  EditController& edits = bench.edits;
  CompareController& compare = bench.compare;
  QObject* const context = &bench.features;
  auto* view = new HistoryPanel(edits, compare, bench.scene, bench.author);
  bench.views.history = view;
  bench.panels.history = &bench.window.addPanel(QStringLiteral("history"), HistoryFeature::tr("History"), view);
  auto* strip = new CompareStrip(compare);
  bench.window.addStrip(strip);
  QObject::connect(&bench.feel, &FeelController::stateChanged, strip,
                   [strip, &feel = bench.feel] { strip->setFelt(feel.isRunning()); });
  new FeltState(bench.feel, bench.scene, edits, context);

  WindowMenus& menus = bench.window.menus();
  const auto ask = [&menus, &bench, context](MenuSlot slot, const QString& text, const QKeySequence& keys,
                                             void (HistoryPanel::*question)()) {
    QAction* const action = menus.addAction(slot, text, keys);
    QObject::connect(action, &QAction::triggered, context, [&bench, question] {
      bench.panels.history->reveal();
      (bench.views.history->*question)();
    });
    return action;
  };
  QAction* const snapshot = ask(MenuSlot::kEditStates, HistoryFeature::tr("&Name this state…"),
                                Qt::CTRL | Qt::SHIFT | Qt::Key_N, &HistoryPanel::askSnapshot);
  QAction* const sign_off = ask(MenuSlot::kEditStates, HistoryFeature::tr("&Sign off by an expert…"),
                                Qt::CTRL | Qt::SHIFT | Qt::Key_G, &HistoryPanel::askSignOff);
  addCarry(bench);
  QAction* const sides = menus.addAction(MenuSlot::kEditCompare, HistoryFeature::tr("&Compare: switch between A and B"),
                                         Qt::CTRL | Qt::Key_B);
  QAction* const end = menus.addAction(MenuSlot::kEditCompare, HistoryFeature::tr("&End the comparison"),
                                       Qt::CTRL | Qt::SHIFT | Qt::Key_B);
  QAction* const author =
      ask(MenuSlot::kEditAuthor, HistoryFeature::tr("Enter &your name…"), {}, &HistoryPanel::askAuthor);
  QObject::connect(sides, &QAction::triggered, &compare, &CompareController::toggle);
  QObject::connect(end, &QAction::triggered, &compare, &CompareController::end);
  const auto show_actions = [&edits, &compare, snapshot, sign_off, sides, author, end] {
    for (QAction* action : {snapshot, sign_off, sides, author}) action->setEnabled(edits.isOpen());
    end->setEnabled(compare.shown().has_value());
  };
  QObject::connect(&edits, &EditController::modelReset, context, show_actions);
  QObject::connect(&compare, &CompareController::shownChanged, context, show_actions);
  QObject::connect(&compare, &CompareController::shownChanged, &bench.ghost, [&bench] { showHiddenSide(bench); });
  QObject::connect(&compare, &CompareController::said, &edits, &EditController::reported);
  QObject::connect(&compare, &CompareController::refused, &edits, &EditController::refused);
  show_actions();
}

namespace {

struct EditingFeature {
  Q_DECLARE_TR_FUNCTIONS(EditingFeature)
};

constexpr int kLongestAction = 60;  // characters of a label in the menu

// `Undo: Insertion depth / Nasopharynx: right foot 125 to 132 mm`, cut where a menu would get too wide.
QString actionText(const QString& action, const QString& label) {
  if (label.isEmpty()) return action;
  QString shown = label.size() > kLongestAction ? label.left(kLongestAction - 1) + QStringLiteral("…") : label;
  return action + QStringLiteral(": ") + shown.replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace

void addEditing(Bench& bench) {
  EditController& edits = bench.edits;
  MainWindow& window = bench.window;
  QObject* const context = &bench.features;
  auto* const clock = new FrameClock(window.panels(), context);
  bench.views.edit_clock = clock;
  auto* const editor = new MembershipEditor(edits, bench.terms, bench.scene, bench.ghost);
  bench.views.membership_editor = editor;
  bench.panels.membership_editor =
      &window.addPanel(QStringLiteral("membership_editor"), EditingFeature::tr("Terms"), editor);
  QAction* const undo =
      window.menus().addAction(MenuSlot::kEditUndo, EditingFeature::tr("&Undo"), Qt::CTRL | Qt::Key_Z);
  QAction* const redo =
      window.menus().addAction(MenuSlot::kEditUndo, EditingFeature::tr("&Redo"), Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
  redo->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
  QObject::connect(undo, &QAction::triggered, &edits, &EditController::undo);
  QObject::connect(redo, &QAction::triggered, &edits, &EditController::redo);
  const auto show_undo = [&edits, undo, redo] {
    undo->setEnabled(edits.canUndo());
    undo->setText(actionText(EditingFeature::tr("&Undo"), edits.undoText()));
    redo->setEnabled(edits.canRedo());
    redo->setText(actionText(EditingFeature::tr("&Redo"), edits.redoText()));
  };
  QObject::connect(&edits, &EditController::historyChanged, context, show_undo);
  const auto say = [&window](const QString& sentence) { window.say(sentence); };
  QObject::connect(&edits, &EditController::reported, context, say);
  QObject::connect(&edits, &EditController::refused, context, say);
  QObject::connect(&edits, &EditController::sending, clock, &FrameClock::begin);
  QObject::connect(&edits, &EditController::changed, clock, &FrameClock::sent);
  auto* const shown_time = new FrameStatus(*clock);
  window.strip().setFrameTime(shown_time);
  QObject::connect(&window, &MainWindow::entered, shown_time, [shown_time](Stage stage) {
    if (stage == Stage::kBuild) shown_time->hide();  // the labs have a clock of their own
  });
  new UndoKeys(context);
  show_undo();
}

}  // namespace tactus::workbench
