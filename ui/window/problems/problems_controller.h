// The list of what went wrong.
#pragma once

#include "window/controller.h"
#include "window/window_context.h"

namespace mapwright::window {

class ProblemsDock;

class ProblemsController : public Controller {
  Q_OBJECT
 public:
  explicit ProblemsController(WindowContext& context, QObject* parent = nullptr);

  ProblemsDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;

 Q_SIGNALS:
  void retryWanted();

 private:
  void openOnce();

  WindowContext& context_;
  ProblemsDock* dock_;
  /// They have opened by themselves, once for good: whether they are open is the user's from then on.
  bool shown_once_ = false;
};

}  // namespace mapwright::window
