#include "app/workbench/participant/screens/thanks_screen.h"

#include <QVBoxLayout>

#include "app/workbench/participant/kit/column.h"

namespace tactus::workbench::nurse {

ThanksScreen::ThanksScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      curve_title_(new Label(look, TextRole::kTitle, phrase(QStringLiteral("thx.curve")))),
      curve_(new ForceCurve(look)),
      print_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("thx.print")), this)) {
  auto* main = new QWidget(this);
  auto* column = new QVBoxLayout(main);
  keepSpacing(look, *column, 1);
  column->addWidget(curve_title_);
  column->addWidget(curve_, 1);
  setTitle(phrase(QStringLiteral("thx.title")));
  setHint(phrase(QStringLiteral("thx.line")));
  setMain(main);
  addExtra(print_);
  backButton().hide();
  primaryButton().setPhrase(phrase(QStringLiteral("thx.done")));
  connect(print_, &QAbstractButton::clicked, this, &ThanksScreen::print);
  connect(this, &ScreenFrame::primary, this, &ThanksScreen::done);
  setState({});
}

void ThanksScreen::setState(const ThanksState& state) {
  curve_->setCurve(state.curve);
  curve_->setVisible(!state.curve.empty());
  curve_title_->setVisible(!state.curve.empty());
  print_->setVisible(state.may_print && !state.curve.empty());
  setSimulated(state.simulated);
}

}  // namespace tactus::workbench::nurse
