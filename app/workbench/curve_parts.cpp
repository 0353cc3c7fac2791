#include "app/workbench/curve_parts.h"

#include <QAction>
#include <QFileInfo>
#include <QSettings>

#include "app/workbench/base/file_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "app/workbench/understand/curves/reference_controller.h"

namespace tactus::workbench {
namespace {

// Names in the settings.
constexpr auto kGhost = "curves/ghost";
constexpr auto kRange = "curves/range";
constexpr auto kDeviation = "curves/deviation";
constexpr auto kReferenceFiles = "curves/reference_files";
constexpr auto kReferenceNames = "curves/reference_names";

}  // namespace

CurveParts::CurveParts(MainWindow& window, const ModelController& models, SceneController& scene,
                       const EditController& edits, GhostController& ghost, ReferenceController& references,
                       QSettings& settings)
    : window_(window), models_(models), references_(references), settings_(settings) {
  ghost.setOn(settings_.value(QLatin1String(kGhost), true).toBool());
  auto* readings = new ReadingModel(scene, this);
  curves_ = new CurvesPanel(scene, *readings, ghost, references);
  curves_panel_ = &window_.addPanel(QStringLiteral("curves"), tr("Force curves"), curves_);
  reading_panel_ = &window_.addPanel(QStringLiteral("reading"), tr("Forces here"), new ReadingPanel(scene, *readings));
  keepChoices(ghost);
  const auto show_pace = [this, &edits] { curves_->setFast(edits.inGesture()); };
  connect(&edits, &EditController::changed, curves_, show_pace);
  connect(&edits, &EditController::historyChanged, curves_, show_pace);
  addActions();
  addZoom(scene);
}

void CurveParts::addActions() {
  WindowMenus& menus = window_.menus();
  QAction* const reference =
      menus.addAction(MenuSlot::kFilePictures, tr("Open re&ference curve…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O);
  QAction* const picture =
      menus.addAction(MenuSlot::kFilePictures, tr("Save &picture of the curves…"), Qt::CTRL | Qt::Key_E);
  connect(reference, &QAction::triggered, this, &CurveParts::chooseReference);
  connect(&references_, &ReferenceController::refused, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The reference curve is not shown. %1").arg(sentence),
                                {tr("Open another curve…"), [this] { chooseReference(); }});
  });
  connect(picture, &QAction::triggered, &curves_->plotMenu(), &PlotMenu::choosePicture);
  for (QAction* action : {reference, picture}) {
    action->setEnabled(false);
    connect(&models_, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

// The input on the x axis, in every plot that shows it.
void CurveParts::addZoom(SceneController& scene) {
  constexpr double kStep = 1.5;
  WindowMenus& menus = window_.menus();
  QAction* const in = menus.addAction(MenuSlot::kView, tr("Zoom &in at the operating point"), QKeySequence::ZoomIn);
  QAction* const out = menus.addAction(MenuSlot::kView, tr("&Zoom out"), QKeySequence::ZoomOut);
  QAction* const all = menus.addAction(MenuSlot::kView, tr("Show the &whole axis"), Qt::CTRL | Qt::Key_0);
  const auto zoom = [&scene](double factor) { scene.ranges().zoom(scene.xVariable(), scene.readingX(), factor); };
  connect(in, &QAction::triggered, this, [zoom] { zoom(1 / kStep); });
  connect(out, &QAction::triggered, this, [zoom] { zoom(kStep); });
  connect(all, &QAction::triggered, this, [&scene] { scene.ranges().showAll(scene.xVariable()); });
  QAction* const mark = menus.addAction(MenuSlot::kView, tr("&Measure from the operating point"), Qt::CTRL | Qt::Key_M);
  mark->setCheckable(true);
  connect(mark, &QAction::triggered, this, [this, &scene](bool on) {
    curves_->setMark(on ? std::optional(scene.value(scene.xInput())) : std::nullopt);
  });
  connect(curves_, &CurvesPanel::markChanged, mark, [this, mark] { mark->setChecked(curves_->mark().has_value()); });
  for (QAction* action : {in, out, all, mark}) {
    action->setEnabled(false);
    connect(&models_, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

void CurveParts::keepChoices(GhostController& ghost) {
  const auto chosen = [this](const char* key, bool otherwise) {
    return settings_.value(QLatin1String(key), otherwise).toBool();
  };
  const SpreadShown standard;
  curves_->setSpreadShown({chosen(kRange, standard.range), chosen(kDeviation, standard.deviation)});
  connect(curves_, &CurvesPanel::spreadChosen, this, [this](SpreadShown shown) {
    settings_.setValue(QLatin1String(kRange), shown.range);
    settings_.setValue(QLatin1String(kDeviation), shown.deviation);
  });
  // Every edit changes the ghost, and few the choice.
  connect(&ghost, &GhostController::changed, this, [this, &ghost, chosen] {
    if (ghost.isOn() != chosen(kGhost, true)) settings_.setValue(QLatin1String(kGhost), ghost.isOn());
  });
  connect(&models_, &ModelController::opened, this, &CurveParts::openReferences, Qt::SingleShotConnection);
}

// Files that are gone are said once, and forgotten.
void CurveParts::openReferences() {
  const QStringList files = settings_.value(QLatin1String(kReferenceFiles)).toStringList();
  const QStringList names = settings_.value(QLatin1String(kReferenceNames)).toStringList();
  QStringList unique = files;
  unique.removeDuplicates();
  for (const QString& file : unique) {
    references_.open(file);
    // Of a file with several curves some may have been taken away.
    QStringList others;
    for (const ReferenceCurve& curve : references_.all()) {
      if (!names.contains(curve.name)) others << curve.name;
    }
    for (const QString& name : others) references_.remove(name);
  }
  storeReferences();
  connect(&references_, &ReferenceController::changed, this, &CurveParts::storeReferences);
}

void CurveParts::storeReferences() {
  QStringList files;
  QStringList names;
  for (const ReferenceCurve& curve : references_.all()) {
    files << curve.file;
    names << curve.name;
  }
  settings_.setValue(QLatin1String(kReferenceFiles), files);
  settings_.setValue(QLatin1String(kReferenceNames), names);
}

void CurveParts::chooseReference() {
  const QString folder = QFileInfo(models_.current()->path).absolutePath();
  const QString path = file_dialog::getOpenFileName(&window_, tr("Lay a reference curve over the plot"), folder,
                                                    tr("Tables (*.csv);;All files (*)"));
  if (!path.isEmpty()) references_.open(path);
}

}  // namespace tactus::workbench
