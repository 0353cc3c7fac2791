#include "app/workbench/tune/rules/rule_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_weight.h"

namespace tactus::workbench {

WordButton::WordButton(const QString& word, const QString& key, std::optional<QColor> color, QWidget* parent)
    : QAbstractButton(parent), key_(key), color_(color) {
  setText(word);
  setAccessibleName(word);
  setToolTip(key.isEmpty() ? tr("Answer %1").arg(word) : tr("Answer %1 (key %2)").arg(word, key));
  setFont(theme::smallFont());
  // The keys stay with the grids.
  setFocusPolicy(Qt::NoFocus);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAttribute(Qt::WA_Hover);
}

void WordButton::setMarked(bool marked) {
  if (marked == marked_) return;
  marked_ = marked;
  update();
}

QSize WordButton::sizeHint() const {
  return {fontMetrics().horizontalAdvance(key_ + QStringLiteral("  ") + text()) + 2 * theme::kGrid,
          fontMetrics().height() + 10};
}

void WordButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  painter.setOpacity(isEnabled() ? (isDown() ? 0.75 : 1.0) : 0.4);
  const QRectF place = QRectF(rect()).adjusted(2, 2, -2, -2);
  const QString shown = fontMetrics().elidedText(key_.isEmpty() ? text() : key_ + QStringLiteral("  ") + text(),
                                                 Qt::ElideRight, static_cast<int>(place.width()) - 6);
  if (color_) {
    paintForceWord(painter, place, {shown, *color_});
  } else {
    paintNoWord(painter, place);
    painter.setPen(theme::mutedInk());
    painter.drawText(place, Qt::AlignCenter, shown);
  }
  if (!marked_ && !(underMouse() && isEnabled())) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(marked_ ? theme::ink() : theme::accent(), 2));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
}

namespace {

constexpr std::size_t kMostOnALine = 6;  // words and the empty answer; more get a second line
constexpr std::size_t kMostKeys = 9;

}  // namespace

WordBar::WordBar(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(2);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void WordBar::setWords(const std::vector<fuzzy::Term>& words) {
  QStringList labels;
  for (const fuzzy::Term& word : words) labels << labelOf(word);
  if (none_ != nullptr && labels == words_) return;
  words_ = labels;
  for (WordButton* button : buttons_) delete button;
  buttons_.clear();
  delete none_;
  const auto place = [&](WordButton* button, std::size_t index) {
    const std::size_t columns = std::min(kMostOnALine, words.size() + 1);
    grid_->addWidget(button, static_cast<int>(index / columns), static_cast<int>(index % columns));
    grid_->setColumnStretch(static_cast<int>(index % columns), 1);
  };
  for (std::size_t w = 0; w < words.size(); ++w) {
    const QString key = w < kMostKeys ? QString::number(w + 1) : QString();
    buttons_.push_back(new WordButton(labels[static_cast<qsizetype>(w)], key, theme::force(w, words.size()), this));
    connect(buttons_.back(), &QAbstractButton::clicked, this, [this, w] { emit chosen(w); });
    place(buttons_.back(), w);
  }
  none_ = new WordButton(tr("No answer"), QString(), std::nullopt, this);
  none_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  none_->setToolTip(tr("Remove the answer (Delete)"));
  connect(none_, &QAbstractButton::clicked, this, &WordBar::cleared);
  place(none_, words.size());
}

void WordBar::setAnswer(std::optional<std::size_t> word) {
  for (std::size_t w = 0; w < buttons_.size(); ++w) buttons_[w]->setMarked(w == word);
  if (none_ != nullptr) none_->setMarked(!word);
}

RuleCellBar::RuleCellBar(RuleController& rules, QWidget* parent)
    : QWidget(parent),
      rules_(rules),
      conditions_(new ElidedLabel(this)),
      weight_(makeWeightBox(this)),
      enabled_(new QCheckBox(tr("Enabled"), this)),
      words_(new WordBar(this)) {
  conditions_->setFont(theme::smallFont());
  weight_->setAccessibleName(tr("Weight of the selected rule"));
  enabled_->setAccessibleName(tr("The selected rule is enabled"));
  // A click leaves the keys with the grids.
  enabled_->setFocusPolicy(Qt::TabFocus);
  makeColumn(this, {makeRow({{conditions_, 1}, new QLabel(tr("Weight"), this), weight_, enabled_}), words_}, 4);

  connect(words_, &WordBar::chosen, &rules_, &RuleController::answerAndGoOn);
  connect(words_, &WordBar::cleared, &rules_, [this] { rules_.answer(std::nullopt); });
  connect(weight_, &NumberBox::valueChanged, this, [this](double weight) {
    const auto cell = rules_.selected();
    if (cell && rules_.cell(*cell).rule) rules_.weigh(*rules_.cell(*cell).rule, weight);
  });
  connect(weight_, &NumberBox::editingFinished, this, [this] {
    rules_.endWeighing();
    if (weight_->hasFocus()) emit done();
  });
  connect(enabled_, &QCheckBox::clicked, this, [this](bool on) {
    const auto cell = rules_.selected();
    if (cell && rules_.cell(*cell).rule) rules_.enable({*rules_.cell(*cell).rule}, on);
  });
}

void RuleCellBar::showCell() {
  if (!rules_.isOpen()) return;
  const auto selected = rules_.selected();
  words_->setWords(rules_.words());
  words_->setEnabled(selected.has_value());
  const editing::GridCell none;
  const editing::GridCell& cell = selected ? rules_.cell(*selected) : none;
  QString sentence = selected ? rules_.conditionsOf(*selected) : tr("Click a cell to answer it.");
  if (cell.conflict) {
    sentence = tr("Conflict with a rule for %1. Choose an answer to resolve it. %2")
                   .arg(rules_.otherAnswers(*selected).join(tr(" and ")), sentence);
  }
  if (cell.conflict != warns_) {
    warns_ = cell.conflict;
    QPalette colors;
    if (warns_) colors.setColor(QPalette::WindowText, theme::warningInk());
    conditions_->setPalette(colors);
  }
  conditions_->setFullText(sentence);
  words_->setAnswer(cell.rule ? rules_.wordOf(cell.then) : std::nullopt);
  weight_->setEnabled(cell.rule.has_value());
  enabled_->setEnabled(cell.rule.has_value());
  const QSignalBlocker no_weight(weight_);
  const QSignalBlocker no_enabled(enabled_);
  // Typed text stays until it is committed.
  if (weight_->exact() != cell.weight) weight_->setExact(cell.weight);
  enabled_->setChecked(cell.rule && cell.enabled);
}

RuleGridPane::RuleGridPane(RuleController& rules, QWidget* parent)
    : QWidget(parent),
      rules_(rules),
      area_(new QScrollArea(this)),
      grids_(new RuleGrids(rules)),
      cell_(new RuleCellBar(rules, this)),
      hint_(new ElidedLabel(this)),
      refresh_(new Refresh(this, [this] { showRules(); })) {
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  area_->setWidget(grids_);
  setFocusProxy(grids_);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->viewport()->setAutoFillBackground(false);
  grids_->setAutoFillBackground(false);
  hint_->setFont(theme::smallFont());
  hint_->setForegroundRole(QPalette::PlaceholderText);

  makeColumn(this, {{area_, 1}, cell_, hint_}, 6);

  connect(&rules_, &RuleController::rulesChanged, refresh_, &Refresh::request);
  connect(&rules_, &RuleController::hereChanged, refresh_, &Refresh::request);
  connect(&rules_, &RuleController::selectionChanged, this, &RuleGridPane::showSelection);
  connect(cell_, &RuleCellBar::done, grids_, [this] { grids_->setFocus(); });
  setFocusProxy(grids_);
  refresh_->request();
}

void RuleGridPane::showRules() {
  if (!rules_.isOpen()) return;
  // The keys need a cell to begin with.
  rules_.beginAnywhere();
  grids_->showRules();
  cell_->showCell();
  const std::size_t words = std::min<std::size_t>(9, rules_.words().size());
  hint_->setFullText(
      tr("1–%1 answer and go on · Space skips · Del empties · arrows move · bar: how strongly it acts here")
          .arg(words));
}

void RuleGridPane::showSelection() {
  if (!isVisible() || !rules_.isOpen()) return;
  cell_->showCell();
  if (const auto cell = rules_.selected()) {
    const QRect place = grids_->cellRect(*cell);
    area_->ensureVisible(place.center().x(), place.center().y(), place.width(), place.height());
  }
}

namespace {

constexpr int kTall = 760;  // px, with room for the grids and a list below them

// Fills a box with texts and ids, where they differ from those it has.
void fill(QComboBox& box, const QStringList& texts, const QStringList& ids, const QString& chosen) {
  const QSignalBlocker no_signal(&box);
  bool same = box.count() == texts.size();
  for (int i = 0; same && i < box.count(); ++i) same = box.itemText(i) == texts[i] && box.itemData(i) == ids[i];
  if (!same) {
    box.clear();
    for (qsizetype i = 0; i < texts.size(); ++i) box.addItem(texts[i], ids[i]);
  }
  box.setCurrentIndex(box.findData(chosen));
}

}  // namespace

RuleEditor::RuleEditor(RuleController& rules, QWidget* parent)
    : Card(parent),
      rules_(rules),
      experts_(new QComboBox(this)),
      columns_(new QComboBox(this)),
      tabs_(new QTabBar(this)),
      panes_(new QSplitter(Qt::Vertical, this)),
      refresh_(new Refresh(this, [this] { showHead(); })) {
  experts_->setAccessibleName(tr("Whose rules"));
  experts_->setToolTip(tr("Choose the expert whose rules are edited"));
  columns_->setAccessibleName(tr("Input of the columns"));
  columns_->setToolTip(tr("Choose the input that the grids cross with each other one"));
  for (QComboBox* box : {experts_, columns_}) box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  tabs_->setExpanding(false);
  tabs_->setUsesScrollButtons(false);
  tabs_->addTab(tr("Grids"));
  tabs_->addTab(tr("All rules"));
  tabs_->setAccessibleName(tr("Grids or list"));
  new TabLook(*tabs_);
  // One rule stands in a grid, several or one of another form in the list.
  connect(&rules_.selection(), &Selection::rulesPointed, this, [this] {
    const auto rule = rules_.selection().rule();
    if (!rule || !rules_.cellOf(*rule)) tabs_->setCurrentIndex(1);
  });
  panes_->addWidget(new RuleGridPane(rules, this));
  panes_->addWidget(new RuleListPane(rules, this));
  panes_->setChildrenCollapsible(false);
  panes_->setHandleWidth(theme::kGrid);
  panes_->widget(1)->hide();

  makeColumn(this, {makeRow({experts_, columns_, spring(1), tabs_}), {panes_, 1}}, 6, inset(theme::kGrid));

  connect(tabs_, &QTabBar::currentChanged, this, &RuleEditor::arrange);
  connect(experts_, &QComboBox::activated, this,
          [this](int index) { rules_.setExpert(experts_->itemData(index).toString().toStdString()); });
  connect(columns_, &QComboBox::activated, this,
          [this](int index) { rules_.setRegion(columns_->itemData(index).toString().toStdString()); });
  connect(&rules_, &RuleController::rulesChanged, refresh_, &Refresh::request);
  // At once: what is disabled until it was painted refuses the keyboard that a click on a rule elsewhere hands to it.
  connect(&rules_, &RuleController::rulesChanged, this, [this] { setEnabled(rules_.isOpen()); });
  setEnabled(rules_.isOpen());
  arrange();
  refresh_->request();
}

void RuleEditor::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const bool tall = height() >= kTall;
  if (tall == tall_) return;
  tall_ = tall;
  arrange();
  if (tall_) panes_->setSizes({3 * height() / 5, 2 * height() / 5});
}

void RuleEditor::arrange() {
  const bool list = tabs_->currentIndex() == 1;
  tabs_->setVisible(!tall_);
  columns_->setVisible(tall_ || !list);
  panes_->widget(0)->setVisible(tall_ || !list);
  panes_->widget(1)->setVisible(tall_ || list);
  // The keys that answer are those of the rules.
  setFocusProxy(panes_->widget(list && !tall_ ? 1 : 0));
}

void RuleEditor::showHead() {
  if (!rules_.isOpen()) return;
  const fuzzy::ForceModel& model = rules_.model();
  QStringList texts;
  QStringList ids;
  for (const fuzzy::Expert& expert : model.experts) {
    texts << labelOf(expert);
    ids << text(expert.id);
  }
  fill(*experts_, texts, ids, text(rules_.expert().id));
  texts.clear();
  ids.clear();
  for (const fuzzy::Variable& input : model.inputs) {
    texts << tr("Columns: %1").arg(labelOf(input));
    ids << text(input.id);
  }
  fill(*columns_, texts, ids, text(rules_.region()));
  tabs_->setTabText(1, tr("All rules (%1)").arg(rules_.expert().rules.size()));
}

}  // namespace tactus::workbench
