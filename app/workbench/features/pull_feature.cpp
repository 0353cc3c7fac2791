// Pulling a force curve: from the mouse or a key to the card beside the curve, and what is drawn meanwhile.
#include <QAction>
#include <QCoreApplication>
#include <QPointer>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/pull/pull_card.h"

namespace tactus::workbench {
namespace {

using State = PullController::State;

struct PullFeature {
  Q_DECLARE_TR_FUNCTIONS(PullFeature)
};

std::vector<PullWish> referenceWishes(const Bench& bench) {
  std::vector<PullWish> out;
  for (const ReferenceCurve& one : bench.references.shown())
    out.push_back({PullWish::Kind::kReference, 0, 0, 0, 0, 0, one.name, one.x, one.force_n});
  return out;
}

/// Those on the curves that are shown.
std::vector<PullMarks::Pin> pinsOf(const PullController& pull) {
  std::vector<PullMarks::Pin> out;
  const SceneController& scene = pull.scene();
  for (const std::vector<double>& pin : pull.pins()) {
    std::vector<double> there = scene.values();
    there[scene.xInput()] = pin[scene.xInput()];
    if (there == pin) out.push_back({pin[scene.xInput()], scene.model()->compiled.evaluate(pin).force_n});
  }
  return out;
}

PullMarks marksOf(const PullController& pull) {
  PullMarks out;
  out.pins = pinsOf(pull);
  if (pull.state() == State::kIdle) return out;
  const PullWish& wish = pull.wish();
  const PullAnswer* const answer = pull.answer();
  out.expert = pull.expert();
  if (wish.kind == PullWish::Kind::kPoint) {
    const std::string& unit = pull.scene().model()->model.output.unit;
    out.handle = PullMarks::Handle{wish.from, {}, wish.force_n, {}, forceText(wish.force_n, unit)};
    if (answer != nullptr) out.handle->now_n = answer->now_n;
    if (answer != nullptr && answer->reach)
      out.handle->reach_n = figures::Interval{answer->reach->min_n, answer->reach->max_n};
  } else if (wish.kind == PullWish::Kind::kBand) {
    out.band = PullMarks::Band{{wish.from, wish.to}, {wish.low_n, wish.high_n}};
  }
  if (const auto offer = pull.previewed()) {
    out.x = answer->offers[*offer].x;
    out.curve = answer->offers[*offer].curve;
  }
  return out;
}

/// The card stands beside what is pulled.
QPoint cardPlace(const Bench& bench) {
  const PullWish& wish = bench.pull.wish();
  const bool point = wish.kind == PullWish::Kind::kPoint;
  const bool band = wish.kind == PullWish::Kind::kBand;
  const double x = point ? wish.from : band ? wish.to : bench.scene.value(bench.scene.xInput());
  const CurvesPanel& curves = *bench.views.curves;
  return curves.mapTo(&bench.window, curves.pixelOf(x, point ? wish.force_n : wish.low_n));
}

std::vector<double> pointAt(const Bench& bench, double x) {
  std::vector<double> out = bench.scene.values();
  out[bench.scene.xInput()] = x;
  return out;
}

/// The mean in a model of several experts, else the only one; the wanted force is `by_n` more than it is now.
void beginAt(Bench& bench, double x, double by_n, State state) {
  const fuzzy::Evaluation now = bench.scene.model()->compiled.evaluate(pointAt(bench, x));
  const fuzzy::Variable& output = bench.scene.model()->model.output;
  bench.pull.begin(pointWish(x, placeOf(output, (now.fired ? now.force_n : 0) + by_n)), std::nullopt, state);
}

void stepPull(Bench& bench, double by_n) {
  PullWish wish = bench.pull.wish();
  if (bench.pull.state() == State::kIdle || wish.kind != PullWish::Kind::kPoint) {
    beginAt(bench, bench.scene.value(bench.scene.xInput()), by_n, State::kPulling);
    return;
  }
  wish.force_n = placeOf(bench.scene.model()->model.output, wish.force_n + by_n);
  bench.pull.setWish(wish);
}

}  // namespace

void addPull(Bench& bench) {
  QObject* const context = &bench.features;
  PullController& pull = bench.pull;
  CurvesPanel* const curves = bench.views.curves;
  QAction* const ask = bench.window.menus().addAction(MenuSlot::kEditStates, PullFeature::tr("&Pull the force here…"),
                                                      Qt::CTRL | Qt::Key_P);
  ask->setEnabled(false);
  QObject::connect(&bench.models, &ModelController::opened, ask, [ask] { ask->setEnabled(true); });
  const auto ask_here = [&bench] {
    bench.panels.curves->reveal();
    beginAt(bench, bench.scene.readingX(), 0, State::kChoosing);
  };
  QObject::connect(ask, &QAction::triggered, context, ask_here);
  QObject::connect(curves, &CurvesPanel::pullAsked, context, ask_here);
  QAction* const pin = bench.window.menus().addAction(MenuSlot::kEditStates, PullFeature::tr("P&in the force here"),
                                                      Qt::CTRL | Qt::SHIFT | Qt::Key_P);
  pin->setToolTip(PullFeature::tr("Keep the force at this place, whatever is pulled; once more takes the pin away"));
  pin->setEnabled(false);
  QObject::connect(&bench.models, &ModelController::opened, pin, [pin] { pin->setEnabled(true); });
  const auto pin_at = [&bench](double x) { bench.pull.togglePin(pointAt(bench, x)); };
  QObject::connect(pin, &QAction::triggered, context, [&bench, pin_at] {
    bench.panels.curves->reveal();
    pin_at(bench.scene.readingX());
  });
  QObject::connect(curves, &CurvesPanel::pinAsked, context, pin_at);
  QObject::connect(curves, &CurvesPanel::pullStepped, context, [&bench](double by_n) { stepPull(bench, by_n); });
  QObject::connect(curves, &CurvesPanel::pullDropped, &pull, &PullController::cancel);

  QObject::connect(curves, &CurvesPanel::grabbed, context, [&pull](auto expert, double x, double force_n) {
    pull.begin(pointWish(x, force_n), expert, State::kPulling);
  });
  QObject::connect(curves, &CurvesPanel::pulledTo, context, [&pull](double force_n) {
    if (pull.state() == State::kIdle) return;
    PullWish wish = pull.wish();
    wish.force_n = force_n;
    pull.setWish(wish);
  });
  QObject::connect(curves, &CurvesPanel::bandDrawn, context, [&pull](figures::Interval x, figures::Interval force_n) {
    const PullWish wish = bandWish(x.low, x.high, force_n.low, force_n.high);
    if (pull.state() == State::kPulling) {
      pull.setWish(wish);
    } else {
      pull.begin(wish, pull.expert(), State::kPulling);
    }
  });
  QObject::connect(curves, &CurvesPanel::pullReleased, &pull, &PullController::choose);
  QObject::connect(curves, &CurvesPanel::pullToReferenceAsked, context, [&bench](const QString& name) {
    for (const PullWish& one : referenceWishes(bench)) {
      if (one.name == name) bench.pull.begin(one, bench.references.expert(), State::kChoosing);
    }
  });

  const auto show = [&bench, card = QPointer<PullCard>()]() mutable {
    const State state = bench.pull.state();
    if (state == State::kIdle && bench.pull.pins().empty()) {
      bench.views.curves->setPull(nullptr);
    } else {
      const PullMarks marks = marksOf(bench.pull);
      bench.views.curves->setPull(&marks);
    }
    if (state == State::kChoosing && card == nullptr) {
      card = new PullCard(bench.pull, referenceWishes(bench), bench.window);
      card->moveBeside(cardPlace(bench));
    } else if (state != State::kChoosing && card != nullptr) {
      // The keys go back to the curves.
      if (card->isAncestorOf(bench.window.focusWidget())) bench.views.curves->setFocus();
      card->hide();
      card->deleteLater();
      card = nullptr;
    }
  };
  QObject::connect(&pull, &PullController::changed, context, show);
  QObject::connect(&bench.scene, &SceneController::curvesChanged, context, [&bench] {
    if (bench.pull.pins().empty()) return;
    const PullMarks marks = marksOf(bench.pull);
    bench.views.curves->setPull(&marks);
  });
  // A stage without the curves has no place for the card.
  QObject::connect(&bench.window, &MainWindow::entered, &pull, [&pull] { pull.cancel(); });
}

}  // namespace tactus::workbench
