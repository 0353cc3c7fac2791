#include "app/workbench/feel/feel_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/device/device_search.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_status.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {
namespace {

constexpr int kSideBySide = 540;  // px: from this width on hand and patient stand next to each other
constexpr int kRoomyWidth = 820;  // px at 100 %: from this size on all steps of the procedure are listed
constexpr int kRoomyHeight = 360;
constexpr int kLowHeight = 380;     // px at 100 %: below it the hand, the force and the picture alone are shown
constexpr int kLowTrace = 50;       // px, the least height of the trace with more room
constexpr int kLowestPicture = 84;  // px, with large text in a low panel
constexpr int kOpenWidth = 900;     // px: from this size on the panel is for feeling alone
constexpr int kOpenHeight = 480;
constexpr int kOpenPicture = 296;   // px: the least height of the picture then
constexpr double kOpenForce = 2.4;  // times as large as in a small panel

// Wrapped text in a card must not make the height of the whole panel depend on its width: it would scroll where all
// fits.
class CardHolder : public QWidget {
 public:
  bool hasHeightForWidth() const override { return false; }
};

QString swatch(const QColor& color, const QString& name) {
  return QStringLiteral("<span style=\"color:%1\">■</span> %2").arg(color.name(), name.toHtmlEscaped());
}

}  // namespace

FeelPanel::FeelPanel(SceneController& scene, FeelController& feel, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      feel_(feel),
      keys_(new FeelKeys(feel, this)),
      search_(new DeviceSearch(this)),
      device_(new DeviceBar(feel, *search_, this)),
      patient_(new PatientControls(scene, feel, this)),
      pad_(new TubePad(this)),
      force_(new QLabel(this)),
      bar_(new ForceBar(this)),
      limits_(new ElidedLabel(this)),
      large_(new QPushButton(tr("Feel large (F10)"), this)),
      split_(new QCheckBox(tr("Split"), this)),
      follow_(new QCheckBox(tr("Plots follow"), this)),
      legend_(new QLabel(this)),
      trace_(new ForceTracePlot(this)),
      solid_box_(new QCheckBox(tr("3-D view"), this)),
      solid_note_(new QLabel(this)),
      solid_(new anatomy::SolidView(this)),
      procedure_(new ProcedurePanel(this)),
      placement_(new PlacementCard(this)) {
  build();
  connectAll();
  if (scene_.model()) adoptModel();
  showState();
  showFelt();
}

FeelPanel::~FeelPanel() = default;

void FeelPanel::build() {
  trace_->setMinimumHeight(kLowTrace);
  force_->setFont(theme::titleFont());
  force_->setTextFormat(Qt::PlainText);
  keepFitted(*force_,
             [this] { force_->setMinimumWidth(force_->fontMetrics().horizontalAdvance(QStringLiteral("-0.000 N"))); });
  limits_->setFont(theme::smallFont());
  legend_->setFont(theme::smallFont());
  // It must not make the panel wider than its place.
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  limits_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setInk(*limits_, theme::warningInk());
  for (QCheckBox* box : {split_, follow_, solid_box_}) {
    box->setFocusPolicy(Qt::TabFocus);
    box->setFont(theme::smallFont());
  }
  large_->setFont(theme::headingFont());
  large_->setMinimumHeight(5 * theme::kGrid);
  large_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  large_->setToolTip(tr("Show the hand, the force and the patient in the whole window"));
  large_->hide();
  split_->setToolTip(tr("Show what makes up the force: fuzzy force, friction and limits"));
  follow_->setToolTip(tr("Move depth and speed of all plots with the tool in the hand"));
  follow_->setChecked(feel_.followsHand());
  solid_box_->setToolTip(tr("Show the body from the side, from the front and turned (F4)"));
  setMuted(*solid_note_);
  solid_note_->setWordWrap(true);
  solid_->setFont(theme::smallFont());
  solid_->hide();
  solid_note_->hide();
  showLegend();

  auto* number_row = makeRow({{force_, 0, Qt::AlignTop}, {bar_, 1}});
  copy_ = new PlotMenu(
      *trace_, [this] { return traceTable(scene_, feel_.history(), traced_on_); }, this);
  auto* options = makeRow({split_, follow_, {limits_, 1}, copy_});
  hand_ = new QVBoxLayout;
  hand_->setSpacing(4);
  hand_->addWidget(pad_);
  hand_->addLayout(number_row);
  hand_->addLayout(options);
  hand_->addWidget(legend_);
  hand_->addWidget(trace_, 1);
  hand_->addWidget(large_);

  picture_ = new QBoxLayout(QBoxLayout::TopToBottom);
  picture_->setSpacing(theme::kGrid);
  body_place_ = new QVBoxLayout;
  body_place_->addWidget(solid_);
  body_place_->addWidget(solid_note_);
  picture_->addLayout(body_place_, 3);
  foot_ = new QHBoxLayout;
  foot_->addWidget(procedure_, 1);
  foot_->addWidget(solid_box_, 0, Qt::AlignTop);
  picture_->addLayout(foot_, 0);
  auto* patient = makeColumn({patient_, {picture_, 1}}, 4);

  auto* content = new Card;
  halves_ = new QBoxLayout(QBoxLayout::LeftToRight);
  halves_->setSpacing(2 * theme::kGrid);
  halves_->addLayout(hand_, 1);
  halves_->addLayout(patient, 1);
  auto* column =
      makeColumn(content, {device_, {halves_, 1}, placement_}, theme::kGrid - 2, inset(theme::kGrid, theme::kGrid - 2));
  cards_ = column;

  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  makeColumn(this, {scroll});
  arrange();
}

void FeelPanel::addCard(const QString& name, QWidget* card) {
  auto* holder = new CardHolder;
  makeColumn(holder, {card});
  auto* drawer = new DrawerButton(name, holder, *cards_);
  foot_->addWidget(drawer, 0, Qt::AlignBottom);
  drawer->setFolded(low_);
  drawers_ << drawer;
}

void FeelPanel::showLegend() {
  QStringList lines;
  for (const LegendEntry& entry : trace_->legend()) {
    const bool area = entry.fill.style() != Qt::NoBrush;
    lines << swatch(area ? theme::onCard(entry.fill.color()) : entry.pen.color(), entry.name);
  }
  // In two rows where one would be cut off.
  constexpr qsizetype kInOneRow = 4;
  const QString gap = QStringLiteral("  ");
  QStringList rows{lines.mid(0, kInOneRow).join(gap)};
  if (lines.size() > kInOneRow) rows << lines.mid(kInOneRow).join(gap);
  legend_->setText(rows.join(QStringLiteral("<br>")));
  legend_->setVisible(!low_ && !lines.isEmpty());
}

void FeelPanel::arrange() {
  const int inside = width() - 2 * theme::kGrid;
  const int beside_hand = inside - halves_->spacing() - hand_->minimumSize().width();
  const bool narrow = width() < kSideBySide || beside_hand < patient_->leastWidth();
  patient_->fit(narrow ? inside : beside_hand);
  const bool open = width() >= kOpenWidth && height() >= kOpenHeight;
  const bool roomy =
      !narrow && !open && width() >= appearance::scaled(kRoomyWidth) && height() >= appearance::scaled(kRoomyHeight);
  // Open, the picture stands left and large.
  const auto direction = narrow ? QBoxLayout::TopToBottom : open ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight;
  if (halves_->direction() != direction) halves_->setDirection(direction);
  halves_->setStretch(0, roomy ? 4 : open ? 3 : 1);
  halves_->setStretch(1, roomy ? 5 : open ? 2 : 1);
  const auto picture = roomy ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
  if (picture_->direction() != picture) picture_->setDirection(picture);
  picture_->setStretch(0, 3);
  picture_->setStretch(1, roomy ? 2 : 0);
  const bool low = !narrow && !open && height() < appearance::scaled(kLowHeight);
  procedure_->setDetail(roomy ? ProcedurePanel::Detail::kList
                        : low ? ProcedurePanel::Detail::kHeading
                              : ProcedurePanel::Detail::kStep);
  if (open != open_) setOpen(open);
  if (low != low_) setLow(low);
  const int least_height = open ? kOpenPicture : low ? kLowestPicture : 0;
  least_picture_ = least_height;
  if (body_ != nullptr) body_->setMinimumHeight(least_height);
  solid_->setMinimumHeight(least_height);
  const bool room = roomy || open || low;  // a drawer has room
  if (room != std::exchange(roomy_, room)) emit roomChanged(room);
}

void FeelPanel::setOpen(bool open) {
  open_ = open;
  QFont font = theme::titleFont();
  if (open) font.setPointSizeF(font.pointSizeF() * kOpenForce);
  force_->setFont(font);
  bar_->setLarge(open);
  device_->setFoldable(open);
}

void FeelPanel::setLow(bool low) {
  low_ = low;
  pad_->setLow(low);
  // A trace of some px says nothing.
  for (QWidget* part :
       {static_cast<QWidget*>(trace_), static_cast<QWidget*>(split_), copy_, static_cast<QWidget*>(placement_)})
    part->setVisible(!low);
  large_->setVisible(low);
  showLegend();
  if (!low) trace_->setHistory(feel_.history());
  for (DrawerButton* drawer : drawers_) drawer->setFolded(low);
}

void FeelPanel::toggle() { device_->toggle(); }

void FeelPanel::connectAll() {
  connect(pad_, &TubePad::targetMoved, &feel_.session(), &DeviceSession::setTarget);
  connect(pad_, &TubePad::gripped, &feel_.session(), &DeviceSession::setHeld);
  connect(split_, &QCheckBox::toggled, this, [this](bool split) {
    trace_->setSplit(split);
    showLegend();
    trace_->setHistory(feel_.history());
  });
  connect(large_, &QPushButton::clicked, this, &FeelPanel::largeAsked);
  connect(follow_, &QCheckBox::toggled, &feel_, &FeelController::setFollowsHand);
  connect(solid_box_, &QCheckBox::toggled, this, &FeelPanel::showBody);
  connect(solid_box_, &QCheckBox::toggled, this, &FeelPanel::solidChanged);
  connect(placement_, &PlacementCard::newPlacementRequested, &feel_, &FeelController::newPlacement);
  connect(&feel_, &FeelController::stateChanged, this, &FeelPanel::showState);
  connect(&feel_, &FeelController::advanced, this, &FeelPanel::showFelt);
  connect(&feel_, &FeelController::failed, device_, &DeviceBar::showFailure);
  connect(&feel_, &FeelController::poseChanged, this, &FeelPanel::showPose);
  connect(&feel_, &FeelController::placementEnded, this, [this] { placement_->setSummary(feel_.lastPlacement()); });
  connect(&scene_, &SceneController::modelChanged, this, &FeelPanel::adoptModel);
  connect(&scene_, &SceneController::procedureChanged, this, &FeelPanel::adoptProcedure);
  connect(&scene_, &SceneController::modelEdited, this, &FeelPanel::showRegions);
}

void FeelPanel::showRegions() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto input = fuzzy::wayOf(model.inputs);
  const auto depth = input ? std::optional(model.inputs[*input]) : std::nullopt;
  // What counts as flexed follows from the terms.
  showPose();
  if (depth == depth_) return;
  depth_ = depth;
  regions_ = depth ? depthRegions(*depth) : std::vector<DepthRegion>();
  showTip(feel_.depthMm());
  placement_->setProgress(feel_.strokes(), feel_.depthMm(), regionText(feel_.depthMm()));
}

void FeelPanel::showPose() {
  const auto& inputs = scene_.model()->model.inputs;
  const auto posed = posedInput(scene_.procedure().get(), scene_.model()->model);
  if (!posed) return;
  const auto word = strongestTerm(inputs[*posed], scene_.value(*posed));
  const auto pose =
      word ? study::ItemCondition{inputs[*posed].id, inputs[*posed].terms[*word].id} : study::ItemCondition();
  // The body moves as the force changes; at once the first time.
  if (body_ != nullptr) body_->setPose(pose, std::exchange(posed_, true));
  solid_->setPose(pose);
}

void FeelPanel::showBody() {
  const auto about = scene_.procedure();
  if (body_ != nullptr && (about == nullptr || &body_->about() != about.get())) {
    delete body_;
    body_ = nullptr;
    posed_ = false;
  }
  if (about != nullptr && body_ == nullptr) {
    body_ = anatomy::makeBodyView(about, this);
    body_->setFont(theme::smallFont());
    body_->setAccessibleName(tr("The tool on its way, from the side"));
    body_->setMinimumHeight(least_picture_);
    body_place_->insertWidget(0, body_);
  }
  showSolid();
  showTip(feel_.depthMm());
}

void FeelPanel::setSolid(bool on) { solid_box_->setChecked(on); }

void FeelPanel::showSolid() {
  const auto about = scene_.procedure();
  const bool wanted = solid_box_->isChecked();
  const QString missing = wanted && scene_.model() ? anatomy::SolidView::missing(about.get()) : QString();
  const bool shown = wanted && about != nullptr && missing.isEmpty();
  solid_note_->setText(missing);
  solid_note_->setVisible(!missing.isEmpty());
  solid_->setAbout(about);
  solid_->setVisible(shown);
  if (body_ != nullptr) body_->setVisible(!shown);
}

QString FeelPanel::regionText(double depth_mm) const {
  const auto region = depth_mm > 0 ? regionAt(regions_, depth_mm) : std::nullopt;
  return region ? regions_[*region].label : QString();
}

void FeelPanel::showTip(double depth_mm) {
  const auto region = depth_mm > 0 ? regionAt(regions_, depth_mm) : std::nullopt;
  std::optional<anatomy::LitRange> lit;
  if (region) lit = {regions_[*region].from_mm, regions_[*region].to_mm, regions_[*region].label};
  if (body_ != nullptr) {
    body_->setDepth(depth_mm);
    body_->light(lit);
  }
  solid_->setDepth(depth_mm);
  solid_->light(lit);
}

void FeelPanel::adoptProcedure() {
  const procedure::Procedure* const about = scene_.procedure().get();
  procedure_->setSteps(stepsOf(about));
  showBody();
  showRegions();
}

void FeelPanel::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  adoptProcedure();
  trace_->setOutput(model.output);
  device_->setModelOpen(true);
  arrange();
  showFelt();
}

void FeelPanel::showState() {
  const bool running = feel_.isRunning();
  if (const auto device = feel_.device()) traced_on_ = device;
  // Nothing listens to the keys of the program while there is no force to stop.
  keys_->setOn(running);
  placement_->setRunning(running);
  trace_->setHistory(feel_.history());
  showLegend();
  showFelt();
}

void FeelPanel::showFelt() {
  if (!isVisible()) return;
  const haptics::Sample& sample = feel_.latest();
  const double depth_mm = feel_.depthMm();
  showForce();
  TubePad::Reading reading;
  reading.hand_mm = sample.position_mm;
  reading.tube_mm = sample.position_mm - sample.stretch_mm;
  reading.target_mm = feel_.session().targetMm();
  reading.running = feel_.isRunning();
  reading.replay = feel_.isReplay();
  reading.live = feel_.session().isHandLive();
  reading.latch = feel_.session().grip().latch;
  reading.held = sample.phase != render::Phase::kReleased;
  reading.armed = armed_;
  reading.recorded_s = recorded_s_;
  pad_->setReading(reading);
  showTip(depth_mm);
  procedure_->setDepth(depth_mm);
  placement_->setProgress(feel_.strokes(), depth_mm, regionText(depth_mm));
  device_->showProgress();
  trace_due_ = !trace_due_;
  if (!low_ && (trace_due_ || !feel_.isRunning())) trace_->setHistory(feel_.history());
}

void FeelPanel::showRecording(bool armed, std::optional<int> recorded_s) {
  armed_ = armed;
  recorded_s_ = recorded_s;
  showFelt();
}

void FeelPanel::showForce() {
  const haptics::Sample& sample = feel_.latest();
  bar_->setScale(trace_->topN(), feel_.session().limits().force_cap_n * sample.scale);
  bar_->setForces(sample.force_n, sample.source_force_n);
  QString force = forceText(sample.force_n, "N");
  // The number is that of the procedure.
  if (sample.scale != 1) force = tr("%1, in the hand 1 : %2").arg(force, QString::number(sample.scale));
  if (force != force_->text()) force_->setText(force);
  const QString limits = limitText();
  limits_->setFullText(limits);
  if (scene_.model() == nullptr) return;
  const fuzzy::Variable& output = scene_.model()->model.output;
  const auto word = feel_.isRunning() ? strongestTerm(output, sample.force_n) : std::nullopt;
  if (!word) return solid_->setFelt(std::nullopt);
  solid_->setFelt(anatomy::FeltForce{force + QStringLiteral("  ") + labelOf(output.terms[*word]),
                                     theme::force(*word, output.terms.size())});
}

QString FeelPanel::limitText() const {
  if (!feel_.isRunning()) return {};
  struct Limit {
    std::uint32_t bit;
    QString text;
  };
  const std::uint32_t limited = feel_.latest().limited;
  for (const Limit& limit :
       {Limit{haptics::kLimitedByThermal, tr("the device rests")},
        Limit{haptics::kLimitedByStaleDevice, tr("the device is silent")},
        Limit{haptics::kLimitedByGui, tr("the program was silent")},
        Limit{haptics::kLimitedByPassivity, tr("vibration damped")},
        Limit{haptics::kLimitedByCap, tr("at the force cap")},
        Limit{haptics::kLimitedByGap, tr("fading in after a stall")}, Limit{haptics::kLimitedByFadeIn, tr("fading in")},
        Limit{haptics::kLimitedByStiffness,
              tr("spring softened to %1 N/mm").arg(numberText(feel_.latest().stiffness_n_mm))}}) {
    if ((limited & limit.bit) != 0) return limit.text;
  }
  return {};
}

void FeelPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void FeelPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showLegend();
  // Later: the parts get their fonts now.
  if (event->type() == QEvent::FontChange) QMetaObject::invokeMethod(this, &FeelPanel::arrange, Qt::QueuedConnection);
}

void FeelPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showFelt();
}

}  // namespace tactus::workbench
