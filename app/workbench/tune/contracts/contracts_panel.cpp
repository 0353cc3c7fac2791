// The contracts of the open model as a list: mark and word of the state, the sentence, where it is broken, and a button
// to feel it there.
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/contracts/contracts_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kInside = theme::kGrid / 2;

QString markOf(ContractState state) {
  switch (state) {
    case ContractState::kProved: return QStringLiteral("✓");
    case ContractState::kBroken: return QStringLiteral("✗");
    case ContractState::kOpen: return QStringLiteral("?");
    case ContractState::kComputing: break;
  }
  return QStringLiteral("…");
}

QColor inkOf(ContractState state) {
  const QColor green(0x2e, 0x7d, 0x32);
  switch (state) {
    case ContractState::kProved: return theme::readableText(green);
    case ContractState::kBroken: return theme::errorInk();
    case ContractState::kOpen:
    case ContractState::kComputing: break;
  }
  return theme::mutedInk();
}

/// `✓ proved` in its color; of an older model without the fill.
class StateSign : public QWidget {
 public:
  explicit StateSign(QWidget* parent) : QWidget(parent) { setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed); }

  void setState(ContractState state, bool old) {
    state_ = state;
    old_ = old;
    setAccessibleName(stateText(state, old));
    update();
  }

  /// Wide enough for every state, so that the sentences begin together.
  QSize sizeHint() const override {
    const QFontMetrics metrics(theme::smallFont());
    int widest = 0;
    for (const auto state :
         {ContractState::kComputing, ContractState::kProved, ContractState::kBroken, ContractState::kOpen}) {
      for (const bool old : {false, true}) widest = std::max(widest, metrics.horizontalAdvance(words(state, old)));
    }
    return {widest + 2 * theme::kGrid, metrics.height() + kInside};
  }

 protected:
  // The colors are those of the look at this moment.
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = inkOf(state_);
    QColor fill = ink;
    fill.setAlphaF(old_ || state_ == ContractState::kComputing ? 0 : 0.14F);
    painter.setPen(old_ ? QPen(theme::border(), 1, Qt::DashLine) : QPen(Qt::NoPen));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), height() / 2.0, height() / 2.0);
    painter.setFont(theme::smallFont());
    painter.setPen(old_ ? theme::mutedInk() : ink);
    painter.drawText(rect(), Qt::AlignCenter, words(state_, old_));
  }

 private:
  static QString words(ContractState state, bool old) {
    return markOf(state) + QLatin1Char(' ') + stateText(state, old);
  }

  ContractState state_ = ContractState::kComputing;
  bool old_ = false;
};

/// One contract.
class ContractRow : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(ContractRow)

 public:
  ContractRow(ContractsController& contracts, std::size_t index, QWidget* parent)
      : QWidget(parent),
        contracts_(contracts),
        index_(index),
        sign_(new StateSign(this)),
        sentence_(new QLabel(this)),
        details_(new QLabel(this)),
        feel_(new QPushButton(this)),
        change_(new QToolButton(this)) {
    for (QLabel* label : {sentence_, details_}) {
      label->setTextFormat(Qt::PlainText);
      label->setWordWrap(true);
      label->setTextInteractionFlags(Qt::TextSelectableByMouse);
      label->setFocusPolicy(Qt::NoFocus);
    }
    setMuted(*details_);
    sentence_->setObjectName(QStringLiteral("contract_sentence"));
    details_->setObjectName(QStringLiteral("contract_details"));
    feel_->setObjectName(QStringLiteral("contract_feel"));
    change_->setObjectName(QStringLiteral("contract_change"));
    feel_->setToolTip(
        tr("Move the operating point to where the contract is broken; pressed again, to the other place"));
    change_->setText(QStringLiteral("⋯"));
    change_->setAutoRaise(true);
    change_->setToolTip(tr("Change or remove this contract"));
    change_->setPopupMode(QToolButton::InstantPopup);
    auto* const menu = new QMenu(change_);
    menu->addAction(tr("&Change…"), this, [this] {
      makeContractForm(contracts_, contracts_.model().contracts[index_], index_, window())->open();
    });
    menu->addAction(tr("&Remove"), this, [this] { contracts_.remove(index_); });
    change_->setMenu(menu);

    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, kInside, 0, kInside);
    grid->setHorizontalSpacing(theme::kGrid);
    grid->setVerticalSpacing(kInside);
    grid->setColumnStretch(1, 1);
    grid->addWidget(sign_, 0, 0, Qt::AlignTop);
    grid->addWidget(sentence_, 0, 1);
    grid->addWidget(change_, 0, 2, Qt::AlignTop);
    grid->addWidget(details_, 1, 1);
    grid->addLayout(makeRow({feel_, spring(1)}), 2, 1);
    connect(feel_, &QPushButton::clicked, this, [this] {
      const std::size_t place = next_;
      next_ = places_ > 1 ? 1 - next_ : 0;
      nameFeel();
      contracts_.feel(index_, place);
    });
  }

  void show(const ShownContract& shown) {
    sign_->setState(shown.state, shown.old);
    sentence_->setText(shown.sentence);
    change_->setAccessibleName(tr("Change or remove: %1").arg(shown.sentence));
    details_->setText(shown.details);
    details_->setVisible(!shown.details.isEmpty());
    details_->setEnabled(!shown.old);
    if (shown.sentence != shown_sentence_ || shown.places.size() != places_) next_ = 0;
    shown_sentence_ = shown.sentence;
    places_ = shown.places.size();
    feel_->setVisible(places_ > 0);
    feel_->setEnabled(!shown.old);
    nameFeel();
  }

 private:
  void nameFeel() {
    feel_->setText(next_ == 0 ? tr("Feel it here") : tr("Feel the other place"));
    feel_->setAccessibleName(feel_->text() + QStringLiteral(": ") + shown_sentence_);
  }

  ContractsController& contracts_;
  std::size_t index_;
  StateSign* sign_;
  QLabel* sentence_;
  QLabel* details_;
  QPushButton* feel_;
  QToolButton* change_;
  QString shown_sentence_;
  std::size_t places_ = 0;
  std::size_t next_ = 0;  ///< the place that a press goes to
};

class ContractsPanel : public Card {
  Q_DECLARE_TR_FUNCTIONS(ContractsPanel)

 public:
  explicit ContractsPanel(ContractsController& contracts)
      : contracts_(contracts),
        summary_(new ElidedLabel(this)),
        add_(new QPushButton(tr("Add a contract"), this)),
        menu_(new QMenu(add_)),
        list_(new QWidget(this)),
        lines_(makeColumn(list_, {}, kInside, {0, 0, theme::kGrid, 0})),
        empty_(new QLabel(this)),
        body_(new PageStack(this)) {
    summary_->setFont(theme::headingFont());
    summary_->setObjectName(QStringLiteral("contracts_summary"));
    add_->setObjectName(QStringLiteral("contracts_add"));
    add_->setMenu(menu_);
    empty_->setTextFormat(Qt::PlainText);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    setMuted(*empty_);
    empty_->setText(
        tr("No contract yet. A contract is one sentence that the model has to keep everywhere, such as: the force is "
           "never above 1 N. It is proved, or broken with a place where you can feel it."));
    lines_->addStretch(1);
    auto* const scroll = new QScrollArea(this);
    scroll->setWidget(list_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QWidget* surface : {scroll->viewport(), list_}) surface->setAutoFillBackground(false);
    body_->addWidget(scroll);
    auto* const none = new QWidget(this);
    makeColumn(none, {spring(1), empty_, spring(1)}, theme::kGrid, inset(2 * theme::kGrid, 0));
    body_->addWidget(none);
    makeColumn(this, {makeRow({{summary_, 1}, add_}), {body_, 1}}, theme::kGrid, inset(theme::kGrid));
    connect(menu_, &QMenu::aboutToShow, this, [this] { fillMenu(); });
    refresh_ = new Refresh(this, [this] { adopt(); });
    connect(&contracts_, &ContractsController::changed, refresh_, &Refresh::request);
    refresh_->request();
  }

 protected:
  void showEvent(QShowEvent* event) override {
    contracts_.hold(*this);
    Card::showEvent(event);
  }
  void hideEvent(QHideEvent* event) override {
    contracts_.hold(*this, false);
    Card::hideEvent(event);
  }

 private:
  void fillMenu() {
    menu_->clear();
    if (!contracts_.isOpen()) return;
    const fuzzy::ForceModel& model = contracts_.model();
    const auto offered = offeredContracts(model);
    if (!offered.empty()) addMenuHeading(*menu_, tr("What this procedure and its inputs suggest"));
    for (const fuzzy::Contract& one : offered) {
      // An ampersand of a label is no key.
      QString sentence = contractSentence(model, one);
      menu_->addAction(sentence.replace(QLatin1Char('&'), QLatin1String("&&")), this,
                       [this, one] { contracts_.add(one); });
    }
    addMenuHeading(*menu_, tr("With choices of your own"));
    const auto add = [&](const QString& text, fuzzy::Contract::Kind kind) {
      menu_->addAction(text, this, [this, kind] {
        fuzzy::Contract contract;
        contract.kind = kind;
        makeContractForm(contracts_, contract, std::nullopt, window())->open();
      });
    };
    add(tr("More of an &input never raises or lowers the force…"), fuzzy::Contract::Kind::kNeverRaises);
    add(tr("One &word is never harder than another…"), fuzzy::Contract::Kind::kNeverHarder);
    add(tr("The force never &steps…"), fuzzy::Contract::Kind::kNoStep);
    add(tr("The force is never &above or below…"), fuzzy::Contract::Kind::kNeverAbove);
    add(tr("Some &rule fires everywhere…"), fuzzy::Contract::Kind::kNeverSilent);
  }

  void adopt() {
    const auto& shown = contracts_.shown();
    // The rows that stay keep the keyboard.
    while (rows_.size() > shown.size()) {
      rows_.back()->hide();
      rows_.back()->deleteLater();
      rows_.pop_back();
    }
    while (rows_.size() < shown.size()) {
      rows_.push_back(new ContractRow(contracts_, rows_.size(), list_));
      lines_->insertWidget(static_cast<int>(rows_.size()) - 1, rows_.back());
    }
    for (std::size_t i = 0; i < shown.size(); ++i) rows_[i]->show(shown[i]);
    body_->setCurrentIndex(shown.empty() ? 1 : 0);
    add_->setEnabled(contracts_.isOpen());
    summary_->setFullText(summary());
    refresh_->setRefining(!shown.empty() && contracts_.isBusy());
  }

  QString summary() const {
    if (contracts_.shown().empty()) return tr("Contracts");
    QStringList parts;
    const auto add = [&](ContractState state, const QString& word) {
      const auto count = contracts_.count(state);
      if (count > 0) parts << QStringLiteral("%1 %2").arg(count).arg(word);
    };
    add(ContractState::kBroken, stateText(ContractState::kBroken, false));
    add(ContractState::kOpen, stateText(ContractState::kOpen, false));
    add(ContractState::kProved, stateText(ContractState::kProved, false));
    if (!contracts_.isCurrent()) parts << tr("checking…");
    return parts.join(QStringLiteral(" · "));
  }

  ContractsController& contracts_;
  ElidedLabel* summary_;
  QPushButton* add_;
  QMenu* menu_;
  QWidget* list_;
  QVBoxLayout* lines_;
  QLabel* empty_;
  PageStack* body_;
  std::vector<ContractRow*> rows_;
  Refresh* refresh_ = nullptr;
};

}  // namespace

QWidget* makeContractsPanel(ContractsController& contracts) { return new ContractsPanel(contracts); }

}  // namespace tactus::workbench
