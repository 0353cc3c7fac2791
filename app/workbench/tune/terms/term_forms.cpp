#include "app/workbench/tune/terms/term_forms.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QStringList>
#include <algorithm>
#include <vector>

#include "app/editing/edit_text.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/tune/terms/cut_picture.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

using fuzzy::Term;

constexpr int kMostParts = 8;

struct TermForms {
  Q_DECLARE_TR_FUNCTIONS(TermForms)
};

QString cutsText(const std::vector<double>& cuts, const fuzzy::Variable& variable) {
  QStringList parts;
  for (const double cut : cuts) parts << text(editing::numberText(variable, cut));
  return parts.join(QStringLiteral("; "));
}

// Places that cut the part of the core inside the universe into equal parts.
std::vector<double> equalCuts(const fuzzy::Variable& variable, const Term& term, int parts) {
  const auto shape = fuzzy::MembershipFunction::of(term);
  const double from = std::max(shape.b, variable.min);
  const double to = std::min(shape.c, variable.max);
  std::vector<double> cuts;
  for (int i = 1; i < parts; ++i) cuts.push_back(roundedPlace(variable, from + (to - from) * i / parts));
  return cuts;
}

}  // namespace

void askSplit(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent) {
  const Term* const found = fuzzy::findTerm(terms.terms(), term);
  if (found == nullptr) return;
  const Term whole = *found;
  const fuzzy::Variable variable = terms.variable();
  auto* form = new PopupForm(TermForms::tr("Split %1").arg(labelOf(whole)), TermForms::tr("Split"), parent);
  const int rules = static_cast<int>(terms.rulesOf(term));
  const bool output = variable.id == terms.model().output.id;
  if (rules > 0 && !output) {
    form->setNote(
        TermForms::tr("Its %n rule(s) are copied to each part, so the force stays as it is until you change a part.",
                      nullptr, rules));
  }
  auto* parts = new NumberBox({"parts", {}, "1", 2, kMostParts, {}}, 1, form);
  parts->setWhole();
  parts->setButtonSymbols(QAbstractSpinBox::UpDownArrows);
  parts->setFixedWidth(parts->sizeHint().width());
  parts->setAccessibleName(TermForms::tr("Number of parts"));
  auto* cuts = new QLineEdit(cutsText(equalCuts(variable, whole, 2), variable), form);
  cuts->setAccessibleName(TermForms::tr("Cuts"));
  auto* picture = new CutPicture(variable, whole, form);
  picture->setCuts(equalCuts(variable, whole, 2));
  form->addField(TermForms::tr("Parts:"), parts);
  const QString unit = unitText(variable.unit);
  form->addField(unit.isEmpty() ? TermForms::tr("Cuts:") : TermForms::tr("Cuts (%1):").arg(unit), cuts);
  form->addField(TermForms::tr("Drag:"), picture);
  QObject::connect(parts, &NumberBox::valueChanged, form, [variable, whole, cuts, picture](double count) {
    picture->setCuts(equalCuts(variable, whole, static_cast<int>(count)));
    cuts->setText(cutsText(picture->cuts(), variable));
  });
  QObject::connect(picture, &CutPicture::moved, cuts,
                   [variable, cuts](const std::vector<double>& places) { cuts->setText(cutsText(places, variable)); });
  QObject::connect(cuts, &QLineEdit::textEdited, picture, [picture, unit](const QString& typed) {
    if (const auto places = typedNumbers(typed, unit)) picture->setCuts(*places);
  });
  QObject::connect(form, &PopupForm::accepted, form, [&terms, term, cuts, parts, unit, form] {
    if (!parts->commit()) {
      form->setNote(parts->refusal());
      return;
    }
    const auto places = typedNumbers(cuts->text(), unit);
    if (!places) {
      form->setNote(
          TermForms::tr("%1 Type the cuts with semicolons between them, such as 290; 365.").arg(places.error()));
      return;
    }
    if (const QString why = terms.whyNotSplit(term, *places); !why.isEmpty()) {
      form->setNote(why);
      return;
    }
    form->close();
    terms.split(term, *places);
  });
  form->openAt(anchor);
}

void askRemove(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent) {
  const int rules = static_cast<int>(terms.rulesOf(term));
  if (rules == 0) {
    terms.remove(term, false);
    return;
  }
  const Term* const found = fuzzy::findTerm(terms.terms(), term);
  if (found == nullptr) return;
  auto* form = new PopupForm(TermForms::tr("Remove %1").arg(labelOf(*found)),
                             TermForms::tr("Remove it and its %n rule(s)", nullptr, rules), parent);
  form->setNote(TermForms::tr("%n rule(s) name this term and go with it. Undo brings all back.", nullptr, rules));
  QObject::connect(form, &PopupForm::accepted, form, [&terms, term, form] {
    form->close();
    terms.remove(term, true);
  });
  form->openAt(anchor);
}

}  // namespace tactus::workbench
