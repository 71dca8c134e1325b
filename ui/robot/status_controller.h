// Shows the state in the status bar, the title, and the card of an empty map.
#pragma once

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class StatusController : public Controller {
  Q_OBJECT
 public:
  explicit StatusController(WindowContext& context, QObject* parent = nullptr);
  void setSession(session::Session* session) override;

 private:
  void refresh();
  void refreshTitle();

  WindowContext& context_;
};

}  // namespace mapwright::ui
