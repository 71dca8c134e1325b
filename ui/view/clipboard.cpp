#include "ui/view/clipboard.h"

#include <QClipboard>
#include <QGuiApplication>

#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/qt_plain.h"

namespace mapwright::window {

void copyText(MapOverlay& overlay, const QString& text, const QString& said) {
  QGuiApplication::clipboard()->setText(words::plainText(text));
  overlay.toasts()->add(Mark::Good, said);
}

}  // namespace mapwright::window
