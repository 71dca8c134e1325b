// Compares what the map shows with a picture that is expected of it.
#pragma once

#include <memory>

#include <QDialog>
#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"
#include "work/workers.h"

namespace mapwright::suite {
struct Facts;
}

namespace mapwright::ui {

class ExpectedController : public Controller {
  Q_OBJECT
 public:
  explicit ExpectedController(WindowContext& context, QObject* parent = nullptr);
  ~ExpectedController() override;

  /// Draws the map as the commands do, at the place and in the size of `picture`, a PNG whose report or facts
  /// lie beside it, with the theme and the layers that the facts name, or else as on screen; shows what
  /// differs.
  void compareWith(const QString& picture);
  QDialog* dialog() const { return dialog_; }  // null: nothing is shown

  void setSession(session::Session* session) override;

 private:
  struct Comparing;
  struct Compared;
  void askAndCompare();
  void look();
  void onPicture();
  static Compared compare(const QString& expected, const QString& actual, const suite::Facts& facts);
  void show(const Compared& compared);
  void report(const QString& problem);

  WindowContext& context_;
  std::unique_ptr<Comparing> comparing_;  // null: nothing is drawn
  QPointer<QDialog> dialog_;
  work::Tasks share_;  // comparing; goes first
};

}  // namespace mapwright::ui
