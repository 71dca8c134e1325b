// Help: the manual, commands by name, keyboard shortcuts, about the program.
#pragma once

#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class DiagnosticsDialog;
struct Diagnostics;
class ManualWindow;

class HelpController : public Controller {
  Q_OBJECT
 public:
  explicit HelpController(WindowContext& context, QObject* parent = nullptr);
  ~HelpController() override;

 private:
  void showDiagnostics();
  void copyDiagnostics();
  Diagnostics look() const;
  void showManual();

  WindowContext& context_;
  QPointer<DiagnosticsDialog> diagnostics_;
  ManualWindow* manual_ = nullptr;  // once opened; hidden when it is closed
};

}  // namespace mapwright::ui
