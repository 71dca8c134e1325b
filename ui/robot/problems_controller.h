// The list of what went wrong.
#pragma once

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class ProblemsDock;

class ProblemsController : public Controller {
  Q_OBJECT
 public:
  explicit ProblemsController(WindowContext& context, QObject* parent = nullptr);

  ProblemsDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;

 Q_SIGNALS:
  void retryWanted();

 private:
  void reportFirstError();

  WindowContext& context_;
  ProblemsDock* dock_;
  bool told_ = false;  // an error of this session has been reported
};

}  // namespace mapwright::ui
