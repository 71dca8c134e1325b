// Undo, redo and save for whatever is being edited; the history as a dock.
#pragma once

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

class QDockWidget;

namespace mapwright::ui {

class EditController : public Controller {
  Q_OBJECT
 public:
  explicit EditController(WindowContext& context, QObject* parent = nullptr);
  ~EditController() override;
  QDockWidget* history() const { return history_; }

 private:
  void addHistory();
  void refresh();

  WindowContext& context_;
  QDockWidget* history_ = nullptr;
  QAction *undo_, *redo_, *save_;
};

}  // namespace mapwright::ui
