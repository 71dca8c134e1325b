// View > Language: chosen here, spoken from the next start on.
#pragma once

#include <QMessageBox>
#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class LanguageController : public Controller {
  Q_OBJECT
 public:
  explicit LanguageController(WindowContext& context, QObject* parent = nullptr);

  /// "system" or a code.
  void choose(const QString& language);
  QMessageBox* remark() const { return remark_; }  // null = none is open

 private:
  WindowContext& context_;
  QPointer<QMessageBox> remark_;
};

}  // namespace mapwright::ui
