#include "app/workbench/deliver/link/link_dialog.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QCoreApplication>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"

namespace tactus::workbench {

LinkSign::LinkSign(const LinkController& link, QWidget* parent) : QToolButton(parent), link_(link) {
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  QPalette colors = palette();
  colors.setColor(QPalette::ButtonText, theme::accent());
  setPalette(colors);
  connect(&link_, &LinkController::changed, this, &LinkSign::showState);
  showState();
}

QSize LinkSign::sizeFor(const QString& text) const {
  const QFontMetrics metrics = fontMetrics();
  const int more = metrics.horizontalAdvance(text) - metrics.horizontalAdvance(this->text());
  return QToolButton::sizeHint() + QSize(more, 0);
}

QSize LinkSign::sizeHint() const { return sizeFor(full_); }

QSize LinkSign::minimumSizeHint() const { return sizeFor(brief_); }

void LinkSign::resizeEvent(QResizeEvent* event) {
  QToolButton::resizeEvent(event);
  fit();
}

void LinkSign::fit() { setText(sizeHint().width() <= width() ? full_ : brief_); }

void LinkSign::showState() {
  // The place becomes known with the next size; until then the text stays as long as it is.
  const bool short_now = !brief_.isEmpty() && text() == brief_;
  setVisible(link_.isServing());
  full_ = servingText(link_);
  brief_ = shortServingText(link_);
  setAccessibleName(full_);
  setToolTip(full_ + QLatin1Char('\n') + tr("Click to see who is connected, or to stop"));
  setText(short_now ? brief_ : full_);
  updateGeometry();
}

LinkRow::LinkRow(const LinkController& link, QWidget* parent)
    : QWidget(parent), link_(link), state_(new QLabel(this)), open_(new QPushButton(this)) {
  auto* name = new QLabel(tr("Live link"), this);
  name->setFont(theme::headingFont());
  state_->setTextFormat(Qt::PlainText);
  state_->setWordWrap(true);
  makeRow(this, {{makeColumn({name, state_}, 2), 1}, {open_, 0, Qt::AlignVCenter}}, 2 * theme::kGrid);
  connect(open_, &QPushButton::clicked, this, &LinkRow::asked);
  connect(&link_, &LinkController::changed, this, &LinkRow::showState);
  showState();
}

void LinkRow::showState() {
  const bool serving = link_.isServing();
  state_->setText(serving ? servingText(link_) : tr("Off. A running simulator can follow each edit."));
  setInk(*state_, serving ? theme::accent() : theme::ink());
  open_->setText(serving ? tr("Show who is connected…") : tr("Serve to a simulator…"));
}

namespace {

struct LinkText {
  Q_DECLARE_TR_FUNCTIONS(LinkText)
};

}  // namespace

QString servingText(const LinkController& link) {
  if (!link.isServing()) return {};
  return LinkText::tr("Serving %1 · %2").arg(link.address(), connectedText(link));
}

QString shortServingText(const LinkController& link) {
  if (!link.isServing()) return {};
  return LinkText::tr("Serving · %1").arg(link.clients().size());
}

QString connectedText(const LinkController& link) {
  const auto count = static_cast<int>(link.clients().size());
  if (count > 0) return LinkText::tr("%n connected", nullptr, count);
  const auto& left = link.allLeftAt();
  return left ? LinkText::tr("the last left at %1").arg(left->toString(QStringLiteral("HH:mm")))
              : LinkText::tr("none connected");
}

namespace {

constexpr int kWidth = 560;         // px
constexpr int kClientsHeight = 80;  // px, five lines
constexpr int kLargestPort = 65535;

QLineEdit* makeReadOut(const QString& name, QWidget* parent) {
  auto* field = new QLineEdit(parent);
  field->setReadOnly(true);
  field->setAccessibleName(name);
  return field;
}

QToolButton* makeCopyButton(const QString& name, QLineEdit* field, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(LinkDialog::tr("Copy"));
  button->setAccessibleName(name);
  QObject::connect(button, &QToolButton::clicked, field,
                   [field] { QGuiApplication::clipboard()->setText(field->text()); });
  return button;
}

}  // namespace

LinkDialog::LinkDialog(LinkController& link, QWidget* parent)
    : QDialog(parent),
      link_(link),
      state_(new QLabel(this)),
      failure_(new MessageBanner(this)),
      toggle_(new QPushButton(this)),
      port_(new QSpinBox(this)),
      address_(makeReadOut(tr("Address"), this)),
      token_file_(makeReadOut(tr("Token file"), this)),
      copy_address_(makeCopyButton(tr("Copy the address"), address_, this)),
      copy_token_file_(makeCopyButton(tr("Copy the path of the token file"), token_file_, this)),
      count_(new QLabel(this)),
      clients_(new WrappedLabel(this)) {
  setWindowTitle(tr("Serve to a simulator"));
  setMinimumWidth(kWidth);
  auto* what = new QLabel(this);
  what->setWordWrap(true);
  what->setText(
      tr("Programs of yours on this computer get the model that is shown, each edit of it at once, and what the hand "
         "feels. A simulator that says where it is stands on the force curves. The program starts with this off."));
  state_->setFont(theme::headingFont());
  toggle_->setDefault(true);
  connect(toggle_, &QPushButton::clicked, &link_, [this] {
    failure_->hide();
    link_.isServing() ? link_.stop() : link_.start();
  });

  auto* head = makeRow({{state_, 1}, toggle_}, kStyleGap);

  auto* fields = new QGridLayout;
  fields->setHorizontalSpacing(2 * theme::kGrid);
  fields->setVerticalSpacing(theme::kGrid);
  const auto addRow = [&](const QString& label, QWidget* field, QWidget* copy) {
    const int row = fields->rowCount();
    auto* name = new QLabel(label, this);
    name->setMinimumWidth(name->sizeHint().width() + theme::kGrid / 2);
    fields->addWidget(name, row, 0);
    fields->addWidget(field, row, 1);
    if (copy != nullptr) fields->addWidget(copy, row, 2);
  };
  port_->setRange(0, kLargestPort);
  port_->setSpecialValueText(tr("Any free port"));
  port_->setAccessibleName(tr("Port"));
  port_->setToolTip(tr("Choose one if your simulator expects a fixed port; 0 takes any free one."));
  connect(port_, &QSpinBox::valueChanged, &link_,
          [this](int port) { link_.choosePort(static_cast<std::uint16_t>(port)); });
  addRow(tr("Port"), port_, nullptr);
  addRow(tr("Address"), address_, copy_address_);
  addRow(tr("Token file"), token_file_, copy_token_file_);
  fields->setColumnStretch(1, 1);

  auto* card = new Card(this);
  auto* inside = makeColumn(card, {head, fields, count_}, 2 * theme::kGrid, inset(2 * theme::kGrid));
  clients_->setMinimumHeight(kClientsHeight);
  clients_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  clients_->setTextFormat(Qt::PlainText);
  setInk(*clients_, theme::mutedInk());
  inside->addWidget(clients_, 1);

  makeColumn(this, {what, failure_, {card, 1}}, 2 * theme::kGrid, inset(3 * theme::kGrid));

  connect(&link_, &LinkController::changed, this, &LinkDialog::showState);
  connect(&link_, &LinkController::failed, this, &LinkDialog::showFailure);
  showState();
}

void LinkDialog::bringUp() {
  show();
  raise();
  activateWindow();
}

void LinkDialog::showState() {
  const bool serving = link_.isServing();
  state_->setText(serving ? tr("Serving") : tr("Off"));
  toggle_->setText(serving ? tr("Stop") : tr("Start"));
  address_->setText(link_.address());
  token_file_->setText(link_.tokenFile());
  // The end says which one it is.
  token_file_->setToolTip(link_.tokenFile());
  address_->setPlaceholderText(tr("none"));
  token_file_->setPlaceholderText(tr("none"));
  port_->setEnabled(!serving);
  copy_address_->setEnabled(serving);
  copy_token_file_->setEnabled(serving);
  QStringList lines;
  for (const auto& client : link_.clients()) {
    const QString name = client.name.empty() ? tr("A simulator without a name") : harmless(text(client.name));
    lines << (client.wants_state ? tr("%1 (%2), follows the hand").arg(name, text(client.address))
                                 : QStringLiteral("%1 (%2)").arg(name, text(client.address)));
  }
  count_->setText(serving ? tr("Simulators: %1").arg(connectedText(link_)) : tr("No simulator can connect"));
  clients_->setText(!lines.isEmpty() ? lines.join(QLatin1Char('\n'))
                    : serving        ? tr("Give a simulator the address and the token file.")
                                     : QString());
}

void LinkDialog::showFailure(const QString& sentence) {
  // Another program may have the chosen port.
  const bool chosen = port_->value() != 0;
  failure_->showRemedy(tr("No simulator is served. %1").arg(sentence),
                       {chosen ? tr("Take any free port") : tr("Try again"), [this] {
                          port_->setValue(0);
                          link_.start();
                        }});
}

}  // namespace tactus::workbench
