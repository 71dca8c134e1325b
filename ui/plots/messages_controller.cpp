#include "ui/plots/messages_controller.h"

#include "session/session.h"
#include "ui/kit/findings.h"
#include "ui/kit/panels.h"
#include "ui/plots/messages_dock.h"
#include "ui/view/map_overlay.h"

namespace mapwright::ui {

MessagesController::MessagesController(WindowContext& context, QObject* parent)
    : Controller(parent), dock_(new MessagesDock({}, &context.window)) {
  context.panels.add(dock_, {.side = PanelPosition::Side::Bottom, .tab = 10, .menu_rank = 60, .open = false});
  context.findings.add([this, &panels = context.panels]() -> Findings::Search {
    return [this, &panels, topics = dock_->knownTopics()](const QString&, const Findings::See& see) {
      for (const QString& topic : topics) {
        see({topic, tr("Topic"), QStringLiteral("list"), [this, &panels, topic] {
               panels.open(dock_);
               dock_->chooseTopic(topic);
             }});
      }
    };
  });
  connect(dock_, &MessagesDock::copyWanted, &context.overlay,
          [overlay = &context.overlay](const QString& text, const QString& said) {
            copyText(*overlay, text, said);
          });
}

void MessagesController::setSession(session::Session* session) { dock_->setSession(session); }

}  // namespace mapwright::ui

#include "moc_messages_controller.cpp"
