#include <QAction>
#include <QCoreApplication>
#include <QDateTime>
#include <QDialog>
#include <QLineEdit>
#include <memory>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/kit/form_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/method/method_lab_view.h"
#include "app/workbench/labs/plan/plan_lab.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/session/setup_check.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/operating_strip.h"

namespace tactus::workbench {
namespace {

struct CollectFeature {
  Q_DECLARE_TR_FUNCTIONS(CollectFeature)

 public:
  static void connectRun(Bench& bench);
  static void connectProtocol(Bench& bench);
  static void connectPersons(Bench& bench);
};

void showProtocol(Bench& bench) {
  bench.window.enter(Stage::kCollect);
  bench.views.collect->showProtocol();
}

// The device is free for it: whatever was felt ends.
void checkSetup(Bench& bench) {
  if (!bench.study.takesOrders() || bench.collect.isSessionRunning()) return;
  auto* const dialog = new SetupDialog(bench.study, bench.device, &bench.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &SetupDialog::certified, &bench.features, [&bench](const session::SetupCertificate& setup) {
    bench.run.setSetup(setup);
    bench.collect.setSetup(setup);
  });
  QObject::connect(&bench.study, &StudyConnection::closed, dialog, &QDialog::reject);
  dialog->open();
}

void CollectFeature::connectRun(Bench& bench) {
  SessionRun& run = bench.run;
  QObject* const context = &bench.features;
  QObject::connect(&bench.views.collect->home(), &StudyHome::startAsked, &run, &SessionRun::start);
  QObject::connect(&bench.views.collect->home(), &StudyHome::usabilityAsked, &run, &SessionRun::startUsability);
  QObject::connect(&bench.views.collect->home(), &StudyHome::answersAsked, context,
                   [&bench] { bench.window.enter(Stage::kBuild); });
  QObject::connect(&run, &SessionRun::changed, context,
                   [&bench] { bench.collect.setSessionRunning(bench.run.isRunning()); });
  QObject::connect(&run, &SessionRun::failed, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                     {tr("Try again"), [&bench] { bench.run.startAgain(); }});
  });
  QObject::connect(&run, &SessionRun::refused, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                     {tr("Edit the protocol"), [&bench] { showProtocol(bench); }});
  });
}

void CollectFeature::connectProtocol(Bench& bench) {
  ProtocolController& protocol = bench.protocol;
  MainWindow& window = bench.window;
  QObject* const context = &bench.features;
  QObject::connect(&protocol, &ProtocolController::refused, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(sentence, {tr("Edit the protocol"), [&bench] { showProtocol(bench); }});
  });
  QObject::connect(&protocol, &ProtocolController::notRead, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(sentence, {tr("Read it again"), [&bench] { bench.protocol.read(); }});
  });
  QObject::connect(&protocol, &ProtocolController::keyRefused, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(sentence, {tr("Enter the key again"), [&bench] {
                                                  bench.window.enter(Stage::kCollect);
                                                  bench.views.collect->showKey();
                                                }});
  });
  QObject::connect(&protocol, &ProtocolController::stored, context, [&bench](int version) {
    bench.window.say(tr("Version %1 of the protocol is stored in %2.").arg(version).arg(bench.study.fileName()));
  });
  QObject::connect(&protocol, &ProtocolController::keyStored, context, [&window](bool is_set) {
    window.say(is_set ? tr("The research key is set.") : tr("The research key is removed."));
  });
}

void CollectFeature::connectPersons(Bench& bench) {
  CollectController& collect = bench.collect;
  QObject* const context = &bench.features;
  QObject::connect(&collect, &CollectController::refused, context,
                   [&window = bench.window](const QString& sentence, const MessageAct& act) {
                     window.banner().showRemedy(sentence, act);
                   });
  QObject::connect(&collect, &CollectController::withdrawalRefused, context,
                   [&bench](const study::RecordId& person, const QString& sentence) {
                     bench.window.banner().showRemedy(sentence, {tr("Withdraw again…"), [&bench, person] {
                                                                   bench.views.collect->askWithdrawal(person);
                                                                 }});
                   });
  QAction* const fill = bench.window.menus().addAction(MenuSlot::kStudyModel, tr("&Fill with simulated nurses…"));
  followStudy(bench, fill, [&bench] {
    return bench.study.takesOrders() && !bench.collect.isFilling() && !bench.collect.isSessionRunning();
  });
  QObject::connect(&collect, &CollectController::changed, context, [&bench] {
    if (bench.collect.isFilling()) bench.window.say(tr("Simulated nurses are doing their sessions…"));
  });
  QObject::connect(fill, &QAction::triggered, context, [&bench] {
    bench.window.enter(Stage::kCollect);
    bench.views.collect->askFill();
  });
  QAction* const answers = bench.window.menus().addAction(MenuSlot::kStudyModel, tr("&Import answer files…"));
  followStudy(bench, answers, [&bench] { return bench.study.takesOrders() && !bench.collect.isSessionRunning(); });
  QObject::connect(answers, &QAction::triggered, context, [&bench] {
    bench.window.enter(Stage::kCollect);
    bench.views.collect->askAnswers();
  });
  QObject::connect(&collect, &CollectController::answersImported, context,
                   [&bench](int files, int added, const QString& notes) {
                     bench.window.banner().showNote(
                         tr("%n answer file(s) read, %1 with new answers. %2", nullptr, files).arg(added).arg(notes));
                   });
  QAction* const check = bench.window.menus().addAction(MenuSlot::kStudyModel, tr("Check the set-&up…"));
  followStudy(bench, check, [&bench] { return bench.study.takesOrders() && !bench.collect.isSessionRunning(); });
  QObject::connect(check, &QAction::triggered, context, [&bench] { checkSetup(bench); });
  // Its texts are those of one study.
  QObject::connect(&bench.study, &StudyConnection::closed, context, [&bench] { bench.run.setSetup({}); });
  QObject::connect(&bench.views.collect->home(), &StudyHome::setupAsked, context, [&bench] { checkSetup(bench); });
  QObject::connect(&collect, &CollectController::filled, context, [&bench](int count) {
    bench.window.banner().showNote(
        tr("%n simulated nurse(s) were added. They are marked as simulated.", nullptr, count));
  });
  QObject::connect(&collect, &CollectController::withdrawn, context, [&bench](const QString& code) {
    bench.window.banner().showNote(
        tr("Everything of %1 is deleted from %2. Backups and exports made before can still hold the data.")
            .arg(code, bench.study.fileName()));
  });
}

}  // namespace

void addCollect(Bench& bench) {
  auto* const view = new CollectView(bench.collect, bench.protocol, [&author = bench.author] { return author.name(); });
  bench.views.collect = view;
  MainWindow& window = bench.window;
  window.addScreen(Stage::kCollect, view, MainWindow::Needs::kStudy);
  // A study without a model has nothing else to show, unless an open model is recorded into it.
  QObject::connect(&bench.study, &StudyConnection::opened, &bench.features, [&bench] {
    bench.window.setStudyOpen(true);
    if (!bench.study_models.hasModel() && !bench.study_feature->isToRecord()) bench.window.enter(Stage::kCollect);
  });
  QObject::connect(&bench.study, &StudyConnection::closed, &bench.features, [&window] {
    // A window that was closed leads nowhere any more.
    if (window.isVisible()) window.setStudyOpen(false);
  });
  QObject::connect(&bench.study_models, &StudyModels::notesChanged, &bench.features,
                   [view, &models = bench.study_models] { view->home().showData(models.notes()); });
  CollectFeature::connectRun(bench);
  CollectFeature::connectProtocol(bench);
  CollectFeature::connectPersons(bench);
}

namespace {

// How far the first two stages are, in the rail.
struct RailFeature {
  Q_DECLARE_TR_FUNCTIONS(RailFeature)

 public:
  static void follow(Bench& bench) {
    const auto show = [&bench] {
      const int people = static_cast<int>(bench.collect.overview().rows.size());
      bench.window.setStageState(Stage::kCollect, people > 0 ? tr("%n participant(s)", nullptr, people) : QString());
      const int changed = static_cast<int>(
          settingsChange({}, bench.labs.data.settings()).split(QLatin1String(", "), Qt::SkipEmptyParts).size());
      const auto model = bench.models.current();
      const QDateTime built = model ? QDateTime::fromString(text(model->model.created_utc), Qt::ISODate) : QDateTime();
      QStringList state;
      if (built.isValid() && bench.study.isOpen())
        state << tr("built %1").arg(lastSeenText(built.toMSecsSinceEpoch(), utcNowMs()));
      if (changed > 0) state << tr("%n setting(s) changed", nullptr, changed);
      bench.window.setStageState(Stage::kBuild, state.join(QLatin1String(", ")));
    };
    show();
    QObject::connect(&bench.collect, &CollectController::changed, &bench.features, show);
    QObject::connect(&bench.labs.data, &LabData::settingsChanged, &bench.features, show);
    QObject::connect(&bench.models, &ModelController::opened, &bench.features, show);
  }
};

struct LabsFeature {
  Q_DECLARE_TR_FUNCTIONS(LabsFeature)

 public:
  static void addExperts(Bench& bench);
  static void addMethod(Bench& bench);
  static void addPlan(Bench& bench);
  static void addOverview(Bench& bench);
  static void askSignature(Bench& bench, const QString& what);
};

void LabsFeature::askSignature(Bench& bench, const QString& what) {
  auto* const name = new QLineEdit(bench.author.name(), &bench.window);
  auto* const why = new QLineEdit(&bench.window);
  auto* const dialog =
      new FormDialog(tr("Correct the data of a participant"),
                     tr("%1. The old record stays in the file. Who corrects today, and why? It is asked once "
                        "a day and stored with each correction.")
                         .arg(what),
                     {{tr("&Name"), name}, {tr("&Reason"), why}}, tr("Store the correction"), &bench.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  const auto follow = [dialog, name, why] {
    dialog->setReady(!name->text().trimmed().isEmpty() && !why->text().trimmed().isEmpty());
  };
  follow();
  QObject::connect(name, &QLineEdit::textChanged, dialog, follow);
  QObject::connect(why, &QLineEdit::textChanged, dialog, follow);
  Corrections& corrections = bench.labs.corrections;
  QObject::connect(dialog, &QDialog::accepted, &corrections,
                   [&corrections, name, why] { corrections.sign(name->text(), why->text()); });
  QObject::connect(dialog, &QDialog::rejected, &corrections, [&corrections] { corrections.dropUnsigned(); });
  why->setFocus();
  dialog->open();
}

// The lab and the bench look at one place, whichever moves it.
void shareOperatingPoint(Bench& bench, ExpertsLab& lab, ExpertsLabView& view) {
  SceneController& scene = bench.scene;
  const auto follow = [&scene, &lab, &view] {
    // The strip below has the point of an open model.
    view.setPlaceElsewhere(scene.model() != nullptr);
    if (scene.model() == nullptr) return;
    const auto& inputs = scene.model()->model.inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) lab.setValueOf(inputs[i].id, scene.value(i));
  };
  QObject::connect(&scene, &SceneController::valueChanged, &lab, follow);
  QObject::connect(&scene, &SceneController::modelChanged, &lab, follow);
  QObject::connect(&lab, &ExpertsLab::changed, &lab, follow);  // its first model
  QObject::connect(&lab, &ExpertsLab::valueChanged, &scene, [&scene, &lab](std::size_t input) {
    if (scene.model() == nullptr) return;
    if (const auto found = inputNamed(scene.model()->model, lab.built()->model.inputs[input].id))
      scene.setValue(*found, lab.values()[input]);
  });
}

void LabsFeature::addExperts(Bench& bench) {
  LabScreen& screen = *bench.views.labs;
  auto* const experts = new ExpertsLab(bench.labs.data, bench.labs.model, &screen);
  auto* const view = new ExpertsLabView(*experts);
  screen.addLab(tr("Experts"), view, &bench.labs.corrections);
  screen.watch(experts->work(), tr("Comparing the weights"));
  screen.watch(experts->bands().work(), tr("Drawing participants again"));
  shareOperatingPoint(bench, *experts, *view);
  screen.watch(experts->wordsAndRules(), tr("Comparing words and rules"));
  // While a model is being built for tuning: it leads there.
  const auto leads = std::make_shared<bool>(false);
  QObject* const context = &bench.features;
  QObject::connect(view, &ExpertsLabView::benchAsked, context, [&bench, leads] {
    if (!bench.files.mayLoseChanges()) return;
    *leads = true;
    bench.study_models.buildModelWith(bench.labs.data.settings());
  });
  const auto lead = [&window = bench.window, leads] {
    if (std::exchange(*leads, false)) window.enter(Stage::kTune);
  };
  QObject::connect(&bench.models, &ModelController::opened, context, lead);
  QObject::connect(&bench.study_models, &StudyModels::backOffered, context, lead);
  QObject::connect(&bench.study_models, &StudyModels::failed, context, [leads] { *leads = false; });
}

void LabsFeature::addOverview(Bench& bench) {
  LabScreen& screen = *bench.views.labs;
  QWidget* const view =
      makeOverview(bench.labs.overview,
                   {[&bench](BuildPart::Kind kind) {
                      const char* const names[] = {"depth", "speed", "force", "rules", "experts"};
                      bench.search->showLab(names[static_cast<std::size_t>(kind)], nullptr);
                    },
                    [&bench] { bench.window.enter(Stage::kCollect); }, [&bench] { bench.start->chooseTables(); },
                    [&bench] {
                      bench.window.enter(Stage::kCollect);
                      bench.views.collect->askFill();
                    }});
  screen.addLab(tr("Overview"), view, &bench.labs.corrections);
  screen.watch(bench.labs.overview.work(), tr("Comparing what each part does to the force"));
}

void LabsFeature::addMethod(Bench& bench) {
  LabScreen& screen = *bench.views.labs;
  auto* const method = new MethodLab(
      bench.labs.data, [&overview = bench.labs.overview] { return overview.studied(); }, &screen);
  screen.addLab(tr("Method"), new MethodLabView(*method), &bench.labs.corrections);
  screen.watch(method->work(), tr("Comparing the choices of the method"));
  screen.watch([method] { return method->isDrawing(); });
}

void LabsFeature::addPlan(Bench& bench) {
  LabScreen& screen = *bench.views.labs;
  auto* const plan = new PlanLab(bench.labs.data, bench.labs.model, &screen);
  screen.addLab(tr("Plan"), makePlanView(*plan), &bench.labs.corrections);
  screen.watch(plan->work(), tr("Simulating studies"));
}

// From a setting of the speed lab until every plot in sight is painted with it.
void timeSpeedLab(Bench& bench) {
  auto* const clock = new FrameClock(*bench.views.labs, bench.views.labs);
  auto* const shown_time = new FrameStatus(*clock);
  bench.window.strip().setFrameTime(shown_time);
  QObject::connect(&bench.labs.data, &LabData::settingsChanged, clock, [clock, view = bench.views.speed] {
    if (view->isVisible()) clock->begin();
  });
  QObject::connect(&bench.labs.speed, &SpeedLab::resultChanged, clock, [clock, &speed = bench.labs.speed] {
    if (speed.isCurrent()) clock->sent();
  });
  QObject::connect(&bench.window, &MainWindow::entered, shown_time, [shown_time](Stage stage) {
    if (stage != Stage::kBuild) shown_time->hide();
  });
}

}  // namespace

void addLabs(Bench& bench) {
  Labs& labs = bench.labs;
  BenchViews& views = bench.views;
  views.labs = new LabScreen(labs.data);
  views.depth = new DepthLabView(labs.depth, labs.price);
  views.speed = new SpeedLabView(labs.speed, labs.model, labs.corrections, labs.price);
  views.force = new ForceLabView(labs.force, labs.price);
  views.rules = new RulesLabView(labs.rules);
  LabScreen& screen = *views.labs;
  LabsFeature::addOverview(bench);
  screen.addLab(LabsFeature::tr("Depth"), views.depth, &labs.depth);
  screen.addLab(LabsFeature::tr("Speed"), views.speed, &labs.corrections);
  screen.watch(labs.speed.work(), LabsFeature::tr("Clustering the speeds"));
  screen.watch(labs.model, LabsFeature::tr("Building the model"));
  screen.addLab(LabsFeature::tr("Force"), views.force, &labs.corrections);
  screen.watch(labs.force.work(), LabsFeature::tr("Counting the votes"));
  screen.watch([&force = labs.force] { return force.isComparing(); });
  screen.addLab(LabsFeature::tr("Rules"), views.rules, &labs.corrections);
  screen.watch(labs.rules.work(), LabsFeature::tr("Comparing the experts"));
  screen.watch([&rules = labs.rules] { return rules.isComparing(); });
  LabsFeature::addExperts(bench);
  LabsFeature::addMethod(bench);
  LabsFeature::addPlan(bench);
  screen.showPrice(labs.price);
  screen.watch(labs.price.work(), LabsFeature::tr("Comparing the forces before and after"));
  bench.window.addScreen(Stage::kBuild, views.labs, MainWindow::Needs::kStudy);
  timeSpeedLab(bench);
  RailFeature::follow(bench);
  QObject::connect(&bench.run, &SessionRun::changed, &bench.features,
                   [&bench] { bench.labs.data.setSessionRunning(bench.run.isRunning()); });
  QObject::connect(&labs.corrections, &Corrections::stored, &bench.features,
                   [&window = bench.window](const QString& what) {
                     window.say(LabsFeature::tr("Stored as a new record; the old one stays: %1").arg(what));
                   });
  QObject::connect(&labs.corrections, &Corrections::signatureAsked, &bench.features,
                   [&bench](const QString& what) { LabsFeature::askSignature(bench, what); });
  QObject::connect(&labs.corrections, &Corrections::refused, &bench.features,
                   [&window = bench.window](const QString& sentence, const MessageAct& act) {
                     window.banner().showRemedy(sentence, act);
                   });
}

}  // namespace tactus::workbench
