#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>

#include "app/workbench/base/file_dialog.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/curves/reading_model.h"

namespace tactus::workbench {
namespace {

// Names in the settings.
constexpr auto kGhost = "curves/ghost";
constexpr auto kRange = "curves/range";
constexpr auto kDeviation = "curves/deviation";
constexpr auto kReferenceFiles = "curves/reference_files";
constexpr auto kReferenceNames = "curves/reference_names";

struct CurvesFeature {
  Q_DECLARE_TR_FUNCTIONS(CurvesFeature)

 public:
  static void addActions(Bench& bench);
  static void addZoom(Bench& bench);
  static void chooseReference(Bench& bench);
};

void CurvesFeature::addActions(Bench& bench) {
  QObject* const context = &bench.features;
  WindowMenus& menus = bench.window.menus();
  QAction* const reference =
      menus.addAction(MenuSlot::kFilePictures, tr("Open re&ference curve…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O);
  QAction* const picture =
      menus.addAction(MenuSlot::kFilePictures, tr("Save &picture of the curves…"), Qt::CTRL | Qt::Key_E);
  QAction* const published = menus.addAction(MenuSlot::kFilePictures, tr("Add p&ublished forces to the curves"));
  published->setEnabled(false);
  QObject::connect(reference, &QAction::triggered, context, [&bench] { chooseReference(bench); });
  QObject::connect(published, &QAction::triggered, context,
                   [&bench] { bench.references.addPublished(*bench.scene.procedure()); });
  const auto enable = [published, &scene = bench.scene] {
    published->setEnabled(scene.procedure() != nullptr && !scene.procedure()->published.empty());
  };
  QObject::connect(&bench.scene, &SceneController::modelChanged, published, enable);
  QObject::connect(&bench.scene, &SceneController::procedureChanged, published, enable);
  QObject::connect(&bench.references, &ReferenceController::refused, context, [&bench](const QString& sentence) {
    bench.window.banner().showRemedy(tr("The reference curve is not shown. %1").arg(sentence),
                                     {tr("Open another curve…"), [&bench] { chooseReference(bench); }});
  });
  QObject::connect(picture, &QAction::triggered, &bench.views.curves->plotMenu(), &PlotMenu::choosePicture);
  for (QAction* action : {reference, picture}) {
    action->setEnabled(false);
    QObject::connect(&bench.models, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

// The input on the x axis, in every plot that shows it.
void CurvesFeature::addZoom(Bench& bench) {
  SceneController& scene = bench.scene;
  CurvesPanel* const curves = bench.views.curves;
  constexpr double kStep = 1.5;
  WindowMenus& menus = bench.window.menus();
  QAction* const in = menus.addAction(MenuSlot::kView, tr("Zoom &in at the operating point"), QKeySequence::ZoomIn);
  QAction* const out = menus.addAction(MenuSlot::kView, tr("&Zoom out"), QKeySequence::ZoomOut);
  QAction* const all = menus.addAction(MenuSlot::kView, tr("Show the &whole axis"), Qt::CTRL | Qt::Key_0);
  const auto zoom = [&scene](double factor) { scene.ranges().zoom(scene.xVariable(), scene.readingX(), factor); };
  QObject::connect(in, &QAction::triggered, &bench.features, [zoom] { zoom(1 / kStep); });
  QObject::connect(out, &QAction::triggered, &bench.features, [zoom] { zoom(kStep); });
  QObject::connect(all, &QAction::triggered, &bench.features, [&scene] { scene.ranges().showAll(scene.xVariable()); });
  QAction* const mark = menus.addAction(MenuSlot::kView, tr("&Measure from the operating point"), Qt::CTRL | Qt::Key_M);
  mark->setCheckable(true);
  QObject::connect(mark, &QAction::triggered, &bench.features, [curves, &scene](bool on) {
    curves->setMark(on ? std::optional(scene.value(scene.xInput())) : std::nullopt);
  });
  QObject::connect(curves, &CurvesPanel::markChanged, mark,
                   [curves, mark] { mark->setChecked(curves->mark().has_value()); });
  for (QAction* action : {in, out, all, mark}) {
    action->setEnabled(false);
    QObject::connect(&bench.models, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

void openReferences(Bench& bench);
void storeReferences(Bench& bench);

void keepChoices(Bench& bench) {
  QSettings& settings = bench.settings;
  GhostController& ghost = bench.ghost;
  const auto chosen = [&settings](const char* key, bool otherwise) {
    return settings.value(QLatin1String(key), otherwise).toBool();
  };
  const SpreadShown standard;
  bench.views.curves->setSpreadShown({chosen(kRange, standard.range), chosen(kDeviation, standard.deviation)});
  QObject::connect(bench.views.curves, &CurvesPanel::spreadChosen, &bench.features, [&settings](SpreadShown shown) {
    settings.setValue(QLatin1String(kRange), shown.range);
    settings.setValue(QLatin1String(kDeviation), shown.deviation);
  });
  // Every edit changes the ghost, and few the choice.
  QObject::connect(&ghost, &GhostController::changed, &bench.features, [&settings, &ghost, chosen] {
    if (ghost.isOn() != chosen(kGhost, true)) settings.setValue(QLatin1String(kGhost), ghost.isOn());
  });
  QObject::connect(
      &bench.models, &ModelController::opened, &bench.features, [&bench] { openReferences(bench); },
      Qt::SingleShotConnection);
}

// Files that are gone are said once, and forgotten.
void openReferences(Bench& bench) {
  const QStringList files = bench.settings.value(QLatin1String(kReferenceFiles)).toStringList();
  const QStringList names = bench.settings.value(QLatin1String(kReferenceNames)).toStringList();
  QStringList unique = files;
  unique.removeDuplicates();
  for (const QString& file : unique) {
    bench.references.open(file);
    // Of a file with several curves some may have been taken away.
    QStringList others;
    for (const ReferenceCurve& curve : bench.references.all()) {
      if (!names.contains(curve.name)) others << curve.name;
    }
    for (const QString& name : others) bench.references.remove(name);
  }
  storeReferences(bench);
  QObject::connect(&bench.references, &ReferenceController::changed, &bench.features,
                   [&bench] { storeReferences(bench); });
}

void storeReferences(Bench& bench) {
  QStringList files;
  QStringList names;
  for (const ReferenceCurve& curve : bench.references.all()) {
    if (curve.file.isEmpty()) continue;
    files << curve.file;
    names << curve.name;
  }
  bench.settings.setValue(QLatin1String(kReferenceFiles), files);
  bench.settings.setValue(QLatin1String(kReferenceNames), names);
}

void CurvesFeature::chooseReference(Bench& bench) {
  const QString folder = QFileInfo(bench.models.current()->path).absolutePath();
  const QString path = file_dialog::getOpenFileName(&bench.window, tr("Lay a reference curve over the plot"), folder,
                                                    tr("Tables (*.csv);;All files (*)"));
  if (!path.isEmpty()) bench.references.open(path);
}

}  // namespace

void addCurves(Bench& bench) {
  bench.ghost.setOn(bench.settings.value(QLatin1String(kGhost), true).toBool());
  auto* readings = new ReadingModel(bench.scene, &bench.features);
  auto* curves = new CurvesPanel(bench.scene, *readings, bench.ghost, bench.references);
  bench.views.curves = curves;
  bench.panels.curves = &bench.window.addPanel(QStringLiteral("curves"), CurvesFeature::tr("Force curves"), curves);
  bench.panels.reading = &bench.window.addPanel(QStringLiteral("reading"), CurvesFeature::tr("Forces here"),
                                                new ReadingPanel(bench.scene, *readings));
  keepChoices(bench);
  const auto show_pace = [curves, &edits = bench.edits] { curves->setFast(edits.inGesture()); };
  QObject::connect(&bench.edits, &EditController::changed, curves, show_pace);
  QObject::connect(&bench.edits, &EditController::historyChanged, curves, show_pace);
  CurvesFeature::addActions(bench);
  CurvesFeature::addZoom(bench);
}

}  // namespace tactus::workbench
