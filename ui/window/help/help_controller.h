// Finding one's way: commands by name, keys, what this program is.
#pragma once

#include <QPointer>

#include "window/controller.h"
#include "window/window_context.h"

namespace mapwright::window {

class DiagnosticsDialog;

class HelpController : public Controller {
  Q_OBJECT
 public:
  explicit HelpController(WindowContext& context, QObject* parent = nullptr);
  ~HelpController() override;

 private:
  void showDiagnostics();

  WindowContext& context_;
  QPointer<DiagnosticsDialog> diagnostics_;
};

}  // namespace mapwright::window
