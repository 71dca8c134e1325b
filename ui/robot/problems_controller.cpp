#include "ui/robot/problems_controller.h"

#include <algorithm>

#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/session.h"
#include "ui/kit/panels.h"
#include "ui/robot/problems_dock.h"
#include "ui/shell/current_session.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

/// An active error; problems of the robot itself have their own notice.
bool isError(const session::LoggedProblem& row, const std::vector<map::SafetyCondition>& safety) {
  if (row.resolved || row.problem.severity != map::Severity::Error) return false;
  return std::none_of(safety.begin(), safety.end(), [&](const map::SafetyCondition& condition) {
    return map::problemOf(condition).subject == row.problem.subject;
  });
}

}  // namespace

ProblemsController::ProblemsController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new ProblemsDock(&context.window)) {
  context_.panels.add(dock_,
                      {.side = PanelPosition::Side::Bottom, .tab = 20, .menu_rank = 50, .open = false});
  connect(dock_, &ProblemsDock::retryWanted, this, &ProblemsController::retryWanted);
  connect(dock_, &ProblemsDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  connect(&context_.bar, &WindowStatusBar::problemsWanted, this, [this] { context_.panels.open(dock_); });
}

void ProblemsController::setSession(session::Session* session) {
  dock_->setSession(session);
  told_ = false;
  if (session)
    connect(session, &session::Session::problemsChanged, this, &ProblemsController::reportFirstError);
}

void ProblemsController::reportFirstError() {
  // So that it is noticed; after that the count in the status bar is enough. The panel does not open by
  // itself: it could appear where the user is about to click.
  session::Session* const session = context_.current.session();
  if (told_ || !session) return;
  const auto& rows = session->problems().rows();
  const auto& safety = session->safety().conditions();
  const auto error = std::find_if(rows.begin(), rows.end(),
                                  [&](const session::LoggedProblem& row) { return isError(row, safety); });
  if (error == rows.end()) return;
  told_ = true;
  if (!dock_->visibleRegion().isEmpty()) return;
  const QString subject = words::plainName(sentences::nameOf(error->problem.subject));
  const QString sentence = sentences::sentenceOf(error->problem);
  context_.overlay.toasts()->add(Mark::Bad, subject.isEmpty() ? sentence : words::about(subject, sentence),
                                 {tr("Show problems"), [this] { context_.panels.open(dock_); }});
}

}  // namespace mapwright::ui

#include "moc_problems_controller.cpp"
