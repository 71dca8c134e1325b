// The robot's raw messages.
#pragma once

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class MessagesDock;

class MessagesController : public Controller {
  Q_OBJECT
 public:
  explicit MessagesController(WindowContext& context, QObject* parent = nullptr);

  MessagesDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;

 private:
  MessagesDock* dock_;
};

}  // namespace mapwright::ui
