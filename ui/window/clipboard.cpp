#include "window/clipboard.h"

#include <QClipboard>
#include <QGuiApplication>

#include "window/map/map_overlay.h"
#include "window/map/toast_stack.h"
#include "words/qt_plain.h"

namespace mapwright::window {

void copyText(MapOverlay& overlay, const QString& text, const QString& said) {
  QGuiApplication::clipboard()->setText(words::plainText(text));
  overlay.toasts()->add(Mark::Good, said);
}

}  // namespace mapwright::window
