#include "app/workbench/participant/kit/label.h"

#include <QPainter>
#include <QTextLayout>
#include <algorithm>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kBetween = 0.55;  // of a line, after a paragraph

QStringList linesOf(const QString& text, const QFont& font, double width) {
  QTextLayout layout(text, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  QStringList lines;
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines;
}

}  // namespace

PagedText::PagedText(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&look, &Look::changed, this, &PagedText::paginate);
}

void PagedText::setParagraphs(std::vector<Phrase> paragraphs) {
  if (paragraphs == paragraphs_) return;
  paragraphs_ = std::move(paragraphs);
  page_ = 0;
  paginate();
}

void PagedText::setPage(int page) {
  page_ = std::clamp(page, 0, std::max(0, pages() - 1));
  update();
  emit paged();
}

void PagedText::resizeEvent(QResizeEvent* /*event*/) { paginate(); }

void PagedText::paginate() {
  const QFont font = look_.font();
  const double line_height = QFontMetricsF(font).lineSpacing();
  pages_.assign(1, {});
  double y = 0;
  QString all;
  for (const Phrase& paragraph : paragraphs_) {
    const QStringList lines = linesOf(look_.say(paragraph), font, std::max(1, width()));
    all += look_.say(paragraph) + QLatin1Char('\n');
    // A paragraph stays together where a page holds it.
    const double high = line_height * static_cast<double>(lines.size());
    if (y + high > height() && y > 0 && high <= height()) {
      pages_.emplace_back();
      y = 0;
    }
    for (const QString& line : lines) {
      if (y + line_height > height() && y > 0) {
        pages_.emplace_back();
        y = 0;
      }
      pages_.back().push_back({line, y});
      y += line_height;
    }
    y += kBetween * line_height;
  }
  setAccessibleName(all.trimmed());
  setPage(page_);
}

void PagedText::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setFont(look_.font());
  painter.setPen(colors::kInk);
  const double ascent = painter.fontMetrics().ascent();
  for (const Line& line : pages_[static_cast<std::size_t>(page_)])
    painter.drawText(QPointF(0, line.y + ascent), line.text);
}

namespace {

constexpr double kLeadFactor = 1.2;

}  // namespace

Label::Label(const Look& look, TextRole role, QWidget* parent) : Label(look, role, Phrase{}, parent) {}

Label::Label(const Look& look, TextRole role, const Phrase& text, QWidget* parent)
    : QLabel(parent), look_(look), role_(role), text_(text) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  const bool muted = role == TextRole::kTitle || role == TextRole::kMuted;
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, muted ? colors::kMutedInk : colors::kInk);
  setPalette(colors);
  connect(&look, &Look::changed, this, &Label::refreshState);
  refreshState();
}

void Label::setPhrase(const Phrase& text) {
  if (text == text_) return;
  text_ = text;
  refreshState();
}

void Label::refreshState() {
  const bool bold = role_ == TextRole::kLead || role_ == TextRole::kTitle;
  setFont(look_.font(role_ == TextRole::kLead ? kLeadFactor : 1, bold));
  setText(look_.say(text_));
}

TextBlock::TextBlock(const Look& look, QWidget* parent) : QWidget(parent), look_(look), layout_(new QVBoxLayout(this)) {
  keepSpacing(look, *layout_, 2);
}

Label* TextBlock::add(TextRole role, const Phrase& text) {
  auto* label = new Label(look_, role, text, this);
  label->setVisible(!text.isEmpty());
  layout_->addWidget(label);
  return label;
}

void TextBlock::add(QWidget* widget, Qt::Alignment alignment) { layout_->addWidget(widget, 0, alignment); }

void TextBlock::center() {
  layout_->insertStretch(0, 2);
  layout_->addStretch(3);
}

void showOrHide(Label& label, const Phrase& text) {
  label.setPhrase(text);
  label.setVisible(!text.isEmpty());
}

}  // namespace tactus::workbench::nurse
