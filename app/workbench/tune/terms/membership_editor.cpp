#include "app/workbench/tune/terms/membership_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/term_list.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {
namespace {

constexpr int kRefusalMs = 8000;  // long enough to read two sentences
constexpr double kWide = 0.25;    // of the universe, without a corner
constexpr double kBeyond = 0.15;  // of the way to the last corner: its handle stands free

/// Where the corners stand close: up to a little behind the last one before the widest stretch without any. Nothing
/// where no stretch is wide, or none comes after the first corner.
std::optional<figures::Interval> crowdedPart(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  const double range = variable.max - variable.min;
  std::vector<double> corners{variable.min, variable.max};
  for (const fuzzy::Term& term : terms) {
    for (const double corner : term.points) {
      if (term.shape != fuzzy::Shape::kGaussian && corner > variable.min && corner < variable.max)
        corners.push_back(corner);
    }
  }
  std::sort(corners.begin(), corners.end());
  std::size_t last = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    if (corners[i + 1] - corners[i] > corners[last + 1] - corners[last]) last = i;
  }
  if (last == 0 || corners[last + 1] - corners[last] < kWide * range) return std::nullopt;
  const double step = std::pow(10, std::floor(std::log10(range)) - 1);
  const double high = corners[last] + kBeyond * (corners[last] - variable.min);
  return figures::Interval{variable.min, std::min(std::ceil(high / step) * step, corners[last + 1])};
}

}  // namespace

MembershipEditor::MembershipEditor(EditController& edits, TermController& terms, SceneController& scene,
                                   const GhostController& ghost, QWidget* parent)
    : Card(parent),
      edits_(edits),
      terms_(terms),
      scene_(scene),
      ghost_(ghost),
      variables_(new QTabBar(this)),
      whose_(new QComboBox(this)),
      own_(new QCheckBox(tr("Own terms"), this)),
      scope_(new QLabel(tr("For"), this)),
      for_one_(new QToolButton(this)),
      for_all_(new QToolButton(this)),
      keeps_sum_(new QCheckBox(tr("Terms sum to one"), this)),
      add_(new QToolButton(this)),
      notes_button_(new NotesButton(this)),
      origin_(new QToolButton(this)),
      zoom_(new QToolButton(this)),
      plot_(new MembershipEditorPlot(scene.ranges(), this)),
      hint_(new ElidedLabel(this)),
      hint_time_(new QTimer(this)),
      sliders_(new TermSliders(terms, this)),
      table_(new TermTable(terms, this)) {
  variables_->setExpanding(false);
  variables_->setUsesScrollButtons(false);
  variables_->setElideMode(Qt::ElideRight);
  variables_->setFont(theme::smallFont());
  variables_->setAccessibleName(tr("Variable"));
  new TabLook(*variables_);
  whose_->setAccessibleName(tr("Whose terms"));
  whose_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  whose_->setToolTip(tr("Choose the shared terms, or the terms of one expert"));
  own_->setToolTip(tr("Give the expert terms of its own for this variable; otherwise the shared ones hold"));
  keeps_sum_->setToolTip(tr("Keep the sum of memberships at one: a vertex moves together with its neighbor's vertex"));
  for (QToolButton* button : {for_one_, for_all_}) {
    button->setCheckable(true);
    button->setFont(theme::smallFont());
  }
  scope_->setFont(theme::smallFont());
  for_one_->setToolTip(tr("Give the expert their own terms for this variable; the terms of the others do not change"));
  for_all_->setToolTip(tr("Change the terms of all experts who share them"));
  add_->setText(tr("Add term…"));
  origin_->setText(tr("Where from?"));
  origin_->setFont(theme::smallFont());
  origin_->setToolTip(tr("Show the trials of the study behind the selected vertex"));
  origin_->hide();
  zoom_->setFont(theme::smallFont());
  hint_->setFont(theme::smallFont());
  hint_time_->setSingleShot(true);
  hint_time_->setInterval(kRefusalMs);

  buildPlace();
  connectAll();
  showModel();
}

void MembershipEditor::buildPlace() {
  auto* modes = makeRow({whose_, own_, scope_, for_one_, for_all_, keeps_sum_, spring(1), add_,
                         new PlotMenu(
                             *plot_, [this] { return table(); }, this)});
  // Beside the hint: the row above is full while the scope is one expert.
  auto* hints = makeRow({{hint_, 1}, zoom_, origin_, notes_button_});
  makeColumn(this, {variables_, modes, {plot_, 1}, hints, sliders_, table_}, 4, inset(theme::kGrid));
}

void MembershipEditor::connectAll() {
  connect(&ghost_, &GhostController::changed, this, &MembershipEditor::showGhost);
  connect(variables_, &QTabBar::currentChanged, this, [this](int index) {
    if (!filling_ && index >= 0) terms_.setVariable(variables_->tabData(index).toString().toStdString());
  });
  connect(whose_, &QComboBox::activated, this,
          [this](int index) { terms_.setExpert(whose_->itemData(index).toString().toStdString()); });
  connect(own_, &QCheckBox::clicked, this, [this](bool own) {
    terms_.setOwnList(own);
    showModes();
  });
  connect(for_one_, &QToolButton::clicked, this, [this] { terms_.chooseScope(false); });
  connect(for_all_, &QToolButton::clicked, this, [this] { terms_.chooseScope(true); });
  connect(&terms_, &TermController::scopeAsked, this, &MembershipEditor::askScope);
  connect(&terms_, &TermController::scopeChosen, this, [this] {
    showModes();
    showHint();
  });
  connect(keeps_sum_, &QCheckBox::clicked, &terms_, &TermController::setKeepsSum);
  connect(add_, &QToolButton::clicked, this, &MembershipEditor::askAdd);
  connect(plot_, &MembershipEditorPlot::originAsked, this, &MembershipEditor::askOrigin);
  connect(origin_, &QToolButton::clicked, this, [this] {
    const auto grip = terms_.selected();
    if (!grip) return;
    const auto points = pointsOf(terms_.terms(), *grip);
    if (!points.empty()) askOrigin(grip->term, points.front());
  });

  connect(zoom_, &QToolButton::clicked, this, [this] {
    const fuzzy::Variable& variable = terms_.variable();
    ShownRanges& ranges = scene_.ranges();
    const auto part = crowdedPart(variable, terms_.terms());
    ranges.isPart(variable) || !part ? ranges.showAll(variable) : ranges.show(variable, *part);
  });
  connect(&scene_.ranges(), &ShownRanges::changed, this, &MembershipEditor::showZoom);
  connect(plot_, &MembershipEditorPlot::selected, &terms_, &TermController::select);
  connect(plot_, &MembershipEditorPlot::moveBegun, &terms_, &TermController::beginMove);
  connect(plot_, &MembershipEditorPlot::moved, &terms_, &TermController::moveBy);
  connect(plot_, &MembershipEditorPlot::moveEnded, &terms_, &TermController::endMove);
  connect(plot_, &MembershipEditorPlot::moveCancelled, &terms_, &TermController::cancelMove);
  connect(plot_, &MembershipEditorPlot::stepped, &terms_, &TermController::step);
  connect(plot_, &MembershipEditorPlot::stepsEnded, &terms_, &TermController::endSteps);
  connect(plot_, &MembershipEditorPlot::nextWanted, &terms_, &TermController::selectNext);

  connect(&edits_, &EditController::modelReset, this, &MembershipEditor::showModel);
  connect(&edits_, &EditController::refused, this, &MembershipEditor::showRefusal);
  connect(&terms_, &TermController::listChanged, this, &MembershipEditor::showList);
  connect(&terms_, &TermController::termsChanged, this, &MembershipEditor::showTerms);
  connect(&terms_, &TermController::locksChanged, this, &MembershipEditor::showLocks);
  connect(&terms_, &TermController::selectionChanged, this, &MembershipEditor::showSelection);
  connect(&scene_, &SceneController::readingChanged, this, &MembershipEditor::showValue);
  connect(hint_time_, &QTimer::timeout, this, &MembershipEditor::showHint);
}

void MembershipEditor::showEvent(QShowEvent* event) {
  // Hidden, it followed nothing.
  showModel();
  Card::showEvent(event);
}

void MembershipEditor::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  sliders_->fitInto(height());
  nameVariables();
}

// With short names where the labels of the model do not fit beside each other; the tool tips have them.
void MembershipEditor::nameVariables() {
  if (!terms_.isOpen()) return;
  const auto& inputs = terms_.model().inputs;
  if (variables_->count() != static_cast<int>(inputs.size()) + 1) return;
  const auto name = [&](QString (*text_of)(const fuzzy::Variable&)) {
    for (std::size_t i = 0; i < inputs.size(); ++i) variables_->setTabText(static_cast<int>(i), text_of(inputs[i]));
    variables_->setTabText(variables_->count() - 1, text_of(terms_.model().output));
  };
  name(labelOf);
  if (variables_->sizeHint().width() > contentsRect().width() - 2 * theme::kGrid) name(shortLabelOf);
}

void MembershipEditor::showModel() {
  setEnabled(terms_.isOpen());
  if (!terms_.isOpen() || !isVisible()) return;
  const fuzzy::ForceModel& model = terms_.model();
  filling_ = true;
  while (variables_->count() > 0) variables_->removeTab(0);
  const auto add_tab = [this](const fuzzy::Variable& variable) {
    const int index = variables_->addTab(labelOf(variable));
    variables_->setTabData(index, text(variable.id));
    variables_->setTabToolTip(index, axisText(variable));
    if (variable.id == terms_.list().variable) variables_->setCurrentIndex(index);
  };
  for (const fuzzy::Variable& input : model.inputs) add_tab(input);
  add_tab(model.output);
  filling_ = false;
  nameVariables();
  showList();
  showHint();
}

void MembershipEditor::showExperts() {
  const QSignalBlocker no_signal(whose_);
  whose_->clear();
  const fuzzy::ForceModel& model = terms_.model();
  const std::string& variable = terms_.list().variable;
  const QString readers = text(editing::readersText(model, {variable, {}}));
  whose_->addItem(readers.isEmpty() ? tr("Shared terms") : tr("Shared terms (%1)").arg(readers), QString());
  for (const fuzzy::Expert& expert : model.experts) {
    const bool own = !editing::listOf(expert, variable).expert.empty();
    const bool alone = !own && editing::readersOf(model, {variable, {}}).size() == 1;
    whose_->addItem(own || alone ? tr("Terms of %1").arg(labelOf(expert)) : tr("%1: shared terms").arg(text(expert.id)),
                    text(expert.id));
  }
  whose_->setCurrentIndex(std::max(0, whose_->findData(text(terms_.expert()))));
}

void MembershipEditor::showList() {
  if (!terms_.isOpen() || !isVisible()) return;
  showExperts();
  showTerms();
  showSelection();
  showLocks();
}

void MembershipEditor::showTerms() {
  if (!isVisible()) return;
  plot_->setTerms(terms_.variable(), terms_.terms());
  plot_->setStopped(edits_.stopped());
  showGhost();
  showZoom();
  if (!edits_.stopped().isEmpty()) showRefusal(tr("It goes no further: stopped by %1.").arg(edits_.stopped()));
  showModes();
  showValue();
}

// The same range as in the other plots of this input.
void MembershipEditor::showZoom() {
  if (!terms_.isOpen() || !isVisible()) return;
  const fuzzy::Variable& variable = terms_.variable();
  const auto part = crowdedPart(variable, terms_.terms());
  const bool zoomed = scene_.ranges().isPart(variable);
  zoom_->setVisible(part.has_value() || zoomed);
  zoom_->setText(
      zoomed ? tr("Show all")
             : tr("Zoom to %1–%2").arg(numberText(variable.min), quantityText(part ? part->high : 0, variable.unit)));
  zoom_->setToolTip(zoomed ? tr("Show the whole universe in all plots of this input")
                           : tr("Show where the corners stand close, in all plots of this input"));
}

void MembershipEditor::showGhost() {
  if (!terms_.isOpen() || !isVisible()) return;
  const auto before = ghost_.before();
  plot_->setGhost(before ? termsBefore(before->model, terms_.list(), terms_.variable()) : std::vector<fuzzy::Term>());
}

void MembershipEditor::showModes() {
  const bool of_expert = !terms_.expert().empty();
  own_->setVisible(of_expert && !terms_.isSharedWithOthers());
  own_->setChecked(!terms_.list().expert.empty());
  keeps_sum_->setChecked(terms_.keepsSum());
  plot_->setSumToOne(terms_.keepsSum());
  showScope();
  showNotes();
}

void MembershipEditor::setNotes(BuildNotes notes) {
  notes_ = std::move(notes);
  showNotes();
}

void MembershipEditor::showNotes() {
  const QVector<NoteGroup> groups = terms_.isOpen() ? groupsAbout(notes_, terms_.variable()) : QVector<NoteGroup>();
  const bool warns = !groups.isEmpty() && !groups.first().sentences.isEmpty();
  notes_button_->setNotes(NotesButton::counted(countOf(groups)), groups, warns);
}

void MembershipEditor::showScope() {
  const bool asks = terms_.isSharedWithOthers();
  for (QWidget* part :
       {static_cast<QWidget*>(scope_), static_cast<QWidget*>(for_one_), static_cast<QWidget*>(for_all_)}) {
    part->setVisible(asks);
  }
  if (!asks) return;
  const auto expert = editing::findExpert(terms_.model(), terms_.expert());
  if (!expert) return;
  const qsizetype count = static_cast<qsizetype>(terms_.readers().size());
  for_one_->setText(tr("%1 only").arg(text((*expert)->id)));
  for_all_->setText(count == 2 ? tr("Both") : tr("All %n", nullptr, static_cast<int>(count)));
  for_one_->setAccessibleName(tr("Edit for %1 only").arg(labelOf(**expert)));
  for_all_->setAccessibleName(tr("Edit for all who share the terms"));
  for_one_->setChecked(false);
  for_all_->setChecked(terms_.editsForAll());
  setInk(*scope_, terms_.editsForAll() ? theme::mutedInk() : theme::ink());
}

// The first edit of terms that others share asks for whom it is; the answer stays visible.
void MembershipEditor::askScope() {
  const auto expert = editing::findExpert(terms_.model(), terms_.expert());
  if (!expert) return;
  hint_time_->stop();
  setInk(*scope_, theme::warningInk());
  setInk(*hint_, theme::warningInk());
  hint_->setFullText(tr("%1 share these terms. Edit for %2 only, or for all of them? Choose above.")
                         .arg(text(editing::readersText(terms_.model(), terms_.list())), text((*expert)->id)),
                     tr("Shared terms: edit for %1 only, or for all? Choose above.").arg(text((*expert)->id)));
  for_one_->setFocus();
}

void MembershipEditor::showLocks() {
  std::vector<std::vector<bool>> locked;
  for (const fuzzy::Term& term : terms_.terms()) {
    std::vector<bool> of_term;
    for (std::size_t p = 0; p < term.points.size(); ++p) of_term.push_back(terms_.isLocked(term.id, p));
    locked.push_back(std::move(of_term));
  }
  plot_->setLocked(std::move(locked));
}

void MembershipEditor::showSelection() {
  plot_->setSelected(terms_.selected());
  origin_->setEnabled(terms_.selected() && terms_.selected()->part != Grip::Part::kTerm);
}

void MembershipEditor::setOriginsKnown(bool known) { origin_->setVisible(known); }

void MembershipEditor::askOrigin(std::size_t term, std::size_t point) {
  emit originAsked(terms_.list().variable, terms_.terms()[term].id, point);
}

void MembershipEditor::showValue() {
  if (!scene_.model() || !terms_.isOpen() || !isVisible()) return;
  const std::string& variable = terms_.list().variable;
  const auto& inputs = scene_.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].id != variable) continue;
    plot_->setValue(i == scene_.xInput() ? scene_.readingX() : scene_.value(i));
    return;
  }
  const Reading reading = scene_.reading();
  plot_->setValue(reading.mean.fired ? std::optional(reading.mean.force_n) : std::nullopt);
}

void MembershipEditor::showRefusal(const QString& sentence) {
  setInk(*hint_, theme::warningInk());
  hint_->setFullText(sentence);
  hint_time_->start();
}

void MembershipEditor::showHint() {
  setInk(*hint_, theme::mutedInk());
  hint_->setFullText(
      tr("Drag a vertex, an edge or a term. Arrow keys move it, Shift+arrow in larger steps; Esc cancels."));
}

void MembershipEditor::askAdd() {
  if (!terms_.isOpen()) return;
  const fuzzy::Variable variable = terms_.variable();
  auto* form = new PopupForm(tr("Add a term to %1").arg(labelOf(variable)), tr("Add"), this);
  if (terms_.keepsSum()) form->setNote(tr("The term that holds this place makes room for the new one."));
  auto* name = new QLineEdit(form);
  name->setAccessibleName(tr("Name of the new term"));
  auto* place = new NumberBox(variable, editing::editStep(variable, editing::StepSize::kFine), form);
  place->setAccessibleName(tr("Place of the new term"));
  place->setValue(roundedPlace(variable, roomiestPlace(variable, terms_.terms())));
  form->addField(tr("Name:"), name);
  form->addField(tr("Around:"), place);
  connect(form, &PopupForm::accepted, this, [this, form, name, place] {
    if (name->text().trimmed().isEmpty()) {
      form->setNote(tr("The new term needs a name."));
      name->setFocus();
      return;
    }
    if (!place->commit()) {
      form->setNote(place->refusal());
      return;
    }
    form->close();
    terms_.add(name->text(), place->value());
  });
  form->openAt(*add_);
}

PlotTable MembershipEditor::table() {
  const std::string& expert = terms_.list().expert;
  const QString whose = expert.empty()
                            ? tr("shared terms (%1)").arg(text(editing::readersText(terms_.model(), terms_.list())))
                            : tr("terms of %1").arg(text(expert));
  PlotTable out = captionedTerms(scene_, terms_.variable(), whose);
  plot_->fillTable(out);
  return out;
}

}  // namespace tactus::workbench
