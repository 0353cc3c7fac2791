// The choices of one contract in plain words, with the sentence that they make.
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/tune/contracts/contracts_controller.h"

namespace tactus::workbench {
namespace {

using fuzzy::Contract;
using ContractKind = fuzzy::Contract::Kind;

constexpr int kFormWide = 520;  // px
constexpr double kMostJnd = 50;

class ContractForm : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(ContractForm)

 public:
  ContractForm(ContractsController& contracts, Contract contract, std::optional<std::size_t> index, QWidget* parent)
      : QDialog(parent),
        contracts_(contracts),
        model_(contracts.model()),
        index_(index),
        contract_(std::move(contract)),
        sentence_(new QLabel(this)),
        form_(new QFormLayout) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("contract_form"));
    setWindowTitle(index ? tr("Change a contract") : tr("Add a contract"));
    fillGaps();
    sentence_->setFont(theme::headingFont());
    sentence_->setTextFormat(Qt::PlainText);
    sentence_->setWordWrap(true);
    // First the layout: a label that is shown before it has a window would be a window of its own.
    QVBoxLayout* const column = makeColumn(this, {sentence_, form_}, 2 * theme::kGrid, inset(2 * theme::kGrid));
    addFields();
    addWhere();
    auto* const note = new QLabel(
        tr("It is checked at every place of the inputs, not at samples. A place is in a word where it belongs to it by "
           "one half or more."),
        this);
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    setMuted(*note);
    auto* const take = new QPushButton(index ? tr("Change the contract") : tr("Add the contract"), this);
    take->setDefault(true);
    take->setObjectName(QStringLiteral("contract_take"));
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    column->addWidget(note);
    column->addLayout(makeRow({spring(1), cancel, take}));
    setMinimumWidth(appearance::scaled(kFormWide));
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(take, &QPushButton::clicked, this, [this] { takeIt(); });
    showSentence();
  }

 private:
  const fuzzy::Variable& input() const { return model_.inputs[inputNamed(model_, contract_.input).value_or(0)]; }

  /// What a new contract has no choice for yet, or an old one has under a name that is gone.
  void fillGaps() {
    if (fuzzy::membersOf(contract_.kind).input && !inputNamed(model_, contract_.input)) {
      const auto way = contract_.kind == ContractKind::kNoStep || contract_.kind == ContractKind::kNeverHarder
                           ? fuzzy::wayOf(model_.inputs)
                           : std::nullopt;
      contract_.input = model_.inputs[way.value_or(0)].id;
    }
    if (contract_.kind == ContractKind::kNeverHarder) fillWords();
    if (contract_.kind == ContractKind::kNoStep && !(contract_.within > 0)) {
      contract_.within = stepOf(input());
      contract_.limit = 1;
      contract_.limit_in_jnd = model_.output.unit == "N";
    }
    const bool is_new = !index_;
    if (is_new && contract_.kind == ContractKind::kNeverAbove) contract_.limit = model_.output.max;
    std::erase_if(contract_.where, [this](const fuzzy::Condition& one) {
      const auto of = inputNamed(model_, one.input);
      return !of || fuzzy::findTerm(model_.inputs[*of].terms, one.term) == nullptr;
    });
  }

  void fillWords() {
    const auto& terms = input().terms;
    if (terms.empty()) return;
    if (fuzzy::findTerm(terms, contract_.word) == nullptr) contract_.word = terms.front().id;
    if (fuzzy::findTerm(terms, contract_.than) == nullptr) contract_.than = terms.back().id;
  }

  QComboBox* choice(const QString& name, const QString& id) {
    auto* const box = new QComboBox(this);
    box->setAccessibleName(name);
    box->setObjectName(id);
    return box;
  }

  void fillTerms(QComboBox& box, const std::string& chosen) {
    const QSignalBlocker quiet(&box);
    box.clear();
    for (const fuzzy::Term& term : input().terms) box.addItem(labelOf(term), text(term.id));
    box.setCurrentIndex(box.findData(text(chosen)));
  }

  QComboBox* inputChoice() {
    auto* const box = choice(tr("Input"), QStringLiteral("contract_input"));
    for (const fuzzy::Variable& one : model_.inputs) box->addItem(labelOf(one), text(one.id));
    box->setCurrentIndex(box->findData(text(contract_.input)));
    connect(box, &QComboBox::activated, this, [this, box] {
      contract_.input = box->currentData().toString().toStdString();
      if (word_ != nullptr) {
        fillWords();
        fillTerms(*word_, contract_.word);
        fillTerms(*than_, contract_.than);
      }
      if (within_ != nullptr) makeWithin();
      showWhere();
      showSentence();
    });
    return box;
  }

  QComboBox* kindChoice(const QString& name, std::initializer_list<std::pair<QString, ContractKind>> kinds) {
    auto* const box = choice(name, QStringLiteral("contract_kind"));
    for (const auto& [words, kind] : kinds) box->addItem(words, static_cast<int>(kind));
    box->setCurrentIndex(box->findData(static_cast<int>(contract_.kind)));
    connect(box, &QComboBox::activated, this, [this, box] {
      contract_.kind = static_cast<ContractKind>(box->currentData().toInt());
      showSentence();
    });
    return box;
  }

  QComboBox* wordChoice(const QString& name, const QString& id, std::string Contract::*word) {
    auto* const box = choice(name, id);
    fillTerms(*box, contract_.*word);
    connect(box, &QComboBox::activated, this, [this, box, word] {
      contract_.*word = box->currentData().toString().toStdString();
      showSentence();
    });
    return box;
  }

  NumberBox* numberBox(const fuzzy::Variable& variable, double step, const QString& name, const QString& id,
                       double Contract::*number) {
    auto* const box = new NumberBox(variable, step, this);
    box->setAccessibleName(name);
    box->setObjectName(id);
    box->setExact(contract_.*number);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, box, number] {
      contract_.*number = box->exact();
      showSentence();
    });
    return box;
  }

  /// Its unit and its room are those of the chosen input.
  void makeWithin() {
    fuzzy::Variable way = input();
    way.max -= way.min;
    way.min = stepOf(input()) / 1000;
    contract_.within = std::clamp(contract_.within, way.min, way.max);
    NumberBox* const box =
        numberBox(way, stepOf(input()), tr("Within"), QStringLiteral("contract_within"), &Contract::within);
    if (within_ != nullptr) {
      delete form_->replaceWidget(within_, box);
      within_->hide();
      within_->deleteLater();
    }
    within_ = box;
  }

  void makeLimit() {
    fuzzy::Variable limit = model_.output;
    if (contract_.limit_in_jnd) {
      limit.unit = "JND";
      limit.min = 0;
      limit.max = kMostJnd;
    }
    if (contract_.kind == ContractKind::kNoStep) limit.min = limit.max / 1000;
    contract_.limit = std::clamp(contract_.limit, limit.min, limit.max);
    const double step = contract_.limit_in_jnd ? 0.1 : stepOf(model_.output);
    NumberBox* const box = numberBox(limit, step, tr("Limit"), QStringLiteral("contract_limit"), &Contract::limit);
    if (limit_ != nullptr) {
      delete limit_row_->replaceWidget(limit_, box);
      limit_->hide();
      limit_->deleteLater();
    }
    limit_ = box;
  }

  void addFields() {
    switch (contract_.kind) {
      case ContractKind::kNeverRaises:
      case ContractKind::kNeverLowers:
        form_->addRow(tr("More of"), inputChoice());
        form_->addRow(tr("does this"),
                      kindChoice(tr("Promise"), {{tr("never raises the force"), ContractKind::kNeverRaises},
                                                 {tr("never lowers the force"), ContractKind::kNeverLowers}}));
        break;
      case ContractKind::kNeverHarder:
        form_->addRow(tr("Along"), inputChoice());
        word_ = wordChoice(tr("The softer word"), QStringLiteral("contract_word"), &Contract::word);
        than_ = wordChoice(tr("The harder word"), QStringLiteral("contract_than"), &Contract::than);
        form_->addRow(tr("the word"), word_);
        form_->addRow(tr("is never harder than"), than_);
        break;
      case ContractKind::kNoStep: {
        form_->addRow(tr("Along"), inputChoice());
        makeWithin();
        form_->addRow(tr("within"), within_);
        auto* const unit = choice(tr("Unit of the change"), QStringLiteral("contract_unit"));
        if (model_.output.unit == "N" || contract_.limit_in_jnd) unit->addItem(tr("just-noticeable differences"), true);
        unit->addItem(tr("units of the force"), false);
        unit->setCurrentIndex(unit->findData(contract_.limit_in_jnd));
        makeLimit();
        limit_row_ = makeRow({limit_, unit, spring(1)});
        form_->addRow(tr("never by more than"), limit_row_);
        connect(unit, &QComboBox::activated, this, [this, unit] {
          contract_.limit_in_jnd = unit->currentData().toBool();
          makeLimit();
          showSentence();
        });
        break;
      }
      case ContractKind::kNeverAbove:
      case ContractKind::kNeverBelow:
        form_->addRow(tr("The force is"), kindChoice(tr("Promise"), {{tr("never above"), ContractKind::kNeverAbove},
                                                                     {tr("never below"), ContractKind::kNeverBelow}}));
        makeLimit();
        form_->addRow(tr("the limit"), limit_);
        break;
      case ContractKind::kNeverSilent: break;
    }
  }

  /// `Only where Depth is [anything]`, for each input.
  void addWhere() {
    for (const fuzzy::Variable& one : model_.inputs) {
      auto* const box =
          choice(tr("Only where %1 is").arg(labelOf(one)), QStringLiteral("contract_where_") + text(one.id));
      box->addItem(tr("anything"), QString());
      for (const fuzzy::Term& term : one.terms) box->addItem(labelOf(term), text(term.id));
      const auto there = std::find_if(contract_.where.begin(), contract_.where.end(),
                                      [&](const fuzzy::Condition& condition) { return condition.input == one.id; });
      if (there != contract_.where.end()) box->setCurrentIndex(box->findData(text(there->term)));
      form_->addRow(tr("where %1 is").arg(labelOf(one)), box);
      where_.push_back(box);
      connect(box, &QComboBox::activated, this, [this] {
        takeWhere();
        showSentence();
      });
    }
    showWhere();
  }

  /// The two words of a comparison say where it is along that input.
  void showWhere() {
    for (std::size_t i = 0; i < where_.size(); ++i) {
      const bool may = contract_.kind != ContractKind::kNeverHarder || model_.inputs[i].id != contract_.input;
      form_->setRowVisible(where_[i], may);
      if (!may) where_[i]->setCurrentIndex(0);
    }
    takeWhere();
  }

  void takeWhere() {
    contract_.where.clear();
    for (std::size_t i = 0; i < where_.size(); ++i) {
      const std::string term = where_[i]->currentData().toString().toStdString();
      if (!term.empty()) contract_.where.push_back({model_.inputs[i].id, term});
    }
  }

  void showSentence() { sentence_->setText(contractSentence(model_, contract_)); }

  void takeIt() {
    for (NumberBox* const box : {within_, limit_}) {
      if (box != nullptr && !box->commit()) return;
    }
    if (index_ ? contracts_.replace(*index_, contract_) : contracts_.add(contract_)) accept();
  }

  ContractsController& contracts_;
  fuzzy::ForceModel model_;  ///< as it was when the form was opened
  std::optional<std::size_t> index_;
  Contract contract_;
  QLabel* sentence_;
  QFormLayout* form_;
  QComboBox* word_ = nullptr;
  QComboBox* than_ = nullptr;
  NumberBox* within_ = nullptr;
  NumberBox* limit_ = nullptr;
  QBoxLayout* limit_row_ = nullptr;
  std::vector<QComboBox*> where_;
};

}  // namespace

QDialog* makeContractForm(ContractsController& contracts, const Contract& contract, std::optional<std::size_t> index,
                          QWidget* parent) {
  return new ContractForm(contracts, contract, index, parent);
}

}  // namespace tactus::workbench
