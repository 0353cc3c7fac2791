#include "app/workbench/deliver/link/link_text.h"

#include <QCoreApplication>

#include "app/workbench/deliver/link/link_controller.h"

namespace tactus::workbench {
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

}  // namespace tactus::workbench
