// Compares what the map shows with a picture that is expected of it.
#pragma once

#include <memory>

#include <QDialog>
#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class ExpectedController : public Controller {
  Q_OBJECT
 public:
  explicit ExpectedController(WindowContext& context, QObject* parent = nullptr);
  ~ExpectedController() override;

  /// Draws the map at the place and in the size of `picture`, a PNG whose report lies beside it, with the
  /// theme and the layers that facts beside it name, or else as on screen; shows what differs.
  void compareWith(const QString& picture);
  QDialog* dialog() const { return dialog_; }  // null: nothing is shown

  void setSession(session::Session* session) override;

 private:
  struct Drawing;
  void askAndCompare();
  void take();
  void show(const QString& sentence, const QString& difference);
  void tell(const QString& problem);

  WindowContext& context_;
  std::unique_ptr<Drawing> drawing_;  // null: nothing is drawn
  QPointer<QDialog> dialog_;
};

}  // namespace mapwright::window
