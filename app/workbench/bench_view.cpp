#include "app/workbench/bench_view.h"

#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "app/workbench/understand/curves/reading_panel.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/understand/here/variable_row.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/understand/map/surface_panel.h"

namespace tactus::workbench {
namespace {

// Names in the settings.
constexpr auto kTerms = "terms";
constexpr auto kCurves = "curves";
constexpr auto kReading = "reading";
constexpr auto kMap = "map";
constexpr auto kRules = "rules";
constexpr auto kFeel = "feel";
// Added by the parts of the window that own them.
constexpr auto kMembershipEditor = "membership_editor";
constexpr auto kRuleEditor = "rule_editor";
constexpr auto kFindings = "findings";
constexpr auto kSurface = "surface";
constexpr auto kHistory = "history";

}  // namespace

BenchView::BenchView(SceneController& scene, FeelController& feel, QSettings& settings, QWidget* parent)
    : QWidget(parent), panels_(new PanelArea(settings, this)) {
  auto* readings = new ReadingModel(scene, this);
  curves_ = new CurvesPanel(scene, *readings);
  auto* map = new ForceMapController(scene, this);
  map_ = new MapPanel(scene, *map);
  feel_panel_ = new FeelPanel(scene, feel);
  panels_->addPanel(QLatin1String(kTerms), tr("Membership functions"), new VariableRow(scene));
  panels_->addPanel(QLatin1String(kCurves), tr("Force curves"), curves_);
  panels_->addPanel(QLatin1String(kReading), tr("Forces here"), new ReadingPanel(scene, *readings));
  panels_->addPanel(QLatin1String(kMap), tr("Map"), map_);
  panels_->addPanel(QLatin1String(kSurface), tr("Surface"), new SurfacePanel(scene, *map));
  panels_->addPanel(QLatin1String(kRules), tr("Rules here"), new RulePanel(scene));
  panels_->addPanel(QLatin1String(kFeel), tr("Feel"), feel_panel_);
  place();

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  header_ = new ModelHeader(scene, this);
  layout->addWidget(header_);
  layout->addWidget(panels_, 1);
}

void BenchView::place() {
  using How = PanelPlace::How;
  panels_->addPlaces(Stage::kUnderstand, {{kCurves, How::kFirst, "", 100},
                                          {kRules, How::kBelow, kCurves, 46},
                                          {kMap, How::kRight, kCurves, 44},
                                          {kSurface, How::kTab, kMap},
                                          {kTerms, How::kTab, kRules},
                                          {kReading, How::kRight, kRules, 26}});
  // What is edited, what that does to the curves, and how it feels, at one glance.
  panels_->addPlaces(Stage::kTune, {{kMembershipEditor, How::kFirst, "", 100},
                                    {kRuleEditor, How::kTab, kMembershipEditor},
                                    {kFindings, How::kTab, kMembershipEditor},
                                    {kCurves, How::kRight, kMembershipEditor, 51},
                                    {kFeel, How::kBelow, kCurves, 52},
                                    {kMap, How::kTab, kFeel},
                                    {kSurface, How::kTab, kFeel},
                                    {kRules, How::kTab, kFeel},
                                    {kReading, How::kTab, kFeel},
                                    {kHistory, How::kTab, kFeel}});
}

void BenchView::toggleFeel() { feel_panel_->toggle(); }

PlotMenu& BenchView::curvesMenu() { return curves_->plotMenu(); }

PlotMenu& BenchView::mapMenu() { return map_->plotMenu(); }

}  // namespace tactus::workbench
