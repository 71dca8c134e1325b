#include "ui/plots/messages_controller.h"

#include "ui/kit/panels.h"
#include "ui/plots/messages_dock.h"
#include "ui/view/map_overlay.h"

namespace mapwright::window {

MessagesController::MessagesController(WindowContext& context, QObject* parent)
    : Controller(parent), dock_(new MessagesDock({}, &context.window)) {
  context.panels.add(dock_, {.side = PanelPlace::Side::Bottom, .tab = 10, .menu_rank = 60, .open = false});
  connect(dock_, &MessagesDock::copyWanted, &context.overlay,
          [overlay = &context.overlay](const QString& text, const QString& said) {
            copyText(*overlay, text, said);
          });
}

void MessagesController::setSession(session::Session* session) { dock_->setSession(session); }

}  // namespace mapwright::window

#include "moc_messages_controller.cpp"
