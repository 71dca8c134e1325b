// Undoing, making it again and saving, whatever is being edited.
#pragma once

#include "window/controller.h"
#include "window/window_context.h"

namespace mapwright::window {

class EditController : public Controller {
  Q_OBJECT
 public:
  explicit EditController(WindowContext& context, QObject* parent = nullptr);

 private:
  void refresh();

  WindowContext& context_;
  QAction *undo_, *redo_, *save_;
};

}  // namespace mapwright::window
