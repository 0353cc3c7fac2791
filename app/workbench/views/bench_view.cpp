#include "app/workbench/views/bench_view.h"

#include <QVBoxLayout>

#include "app/workbench/controllers/force_map.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/models/reading_model.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/curves_panel.h"
#include "app/workbench/views/feel_panel.h"
#include "app/workbench/views/map_panel.h"
#include "app/workbench/views/model_header.h"
#include "app/workbench/views/panel_area.h"
#include "app/workbench/views/reading_panel.h"
#include "app/workbench/views/rule_panel.h"
#include "app/workbench/views/variable_row.h"

namespace tactus::workbench {
namespace {

// Names in the settings.
constexpr auto kTerms = "terms";
constexpr auto kCurves = "curves";
constexpr auto kReading = "reading";
constexpr auto kMap = "map";
constexpr auto kRules = "rules";
constexpr auto kFeel = "feel";

}  // namespace

BenchView::BenchView(SceneController& scene, FeelController& feel, QSettings& settings, QWidget* parent)
    : QWidget(parent), panels_(new PanelArea(settings, this)) {
  auto* readings = new ReadingModel(scene, this);
  curves_ = new CurvesPanel(scene, *readings);
  auto* map = new ForceMapController(scene, this);
  map_ = new MapPanel(scene, *map);
  panels_->addPanel(QLatin1String(kTerms), tr("Membership functions"), new VariableRow(scene));
  panels_->addPanel(QLatin1String(kCurves), tr("Force curves"), curves_);
  panels_->addPanel(QLatin1String(kReading), tr("Forces here"), new ReadingPanel(scene, *readings));
  panels_->addPanel(QLatin1String(kMap), tr("Force map"), map_);
  panels_->addPanel(QLatin1String(kRules), tr("Rules that act here"), new RulePanel(scene));
  panels_->addPanel(QLatin1String(kFeel), tr("Feel"), new FeelPanel(scene, feel));
  place();

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(new ModelHeader(scene, this));
  layout->addWidget(panels_, 1);
}

void BenchView::place() {
  using How = PanelPlace::How;
  panels_->addPlaces(Stage::kUnderstand, {{kCurves, How::kFirst, "", 100},
                                          {kRules, How::kBelow, kCurves, 48},
                                          {kMap, How::kRight, kCurves, 44},
                                          {kReading, How::kRight, kRules, 24}});
  // The editor leads in this stage (edit_parts.cpp adds it); feeling is one click away.
  panels_->addPlaces(Stage::kTune, {{"membership_editor", How::kFirst, "", 100},
                                    {kCurves, How::kRight, "membership_editor", 46},
                                    {kTerms, How::kBelow, kCurves, 44},
                                    {kReading, How::kTab, kTerms},
                                    {"history", How::kTab, kTerms},
                                    {kFeel, How::kTab, kCurves}});
}

PlotMenu& BenchView::curvesMenu() { return curves_->plotMenu(); }

PlotMenu& BenchView::mapMenu() { return map_->plotMenu(); }

}  // namespace tactus::workbench
