#include "window/problems/problems_controller.h"

#include <algorithm>

#include "window/clipboard.h"
#include "window/current_session.h"
#include "window/docks/problems_dock.h"
#include "window/panels.h"
#include "window/status/window_status_bar.h"

namespace mapwright::window {

namespace {

const QString kShownKey = QStringLiteral("window/problemsShown");

/// An error that still holds; what is wrong with the robot itself has its own notice.
bool isError(const session::LoggedProblem& row, const std::vector<map::SafetyCondition>& safety) {
  if (row.resolved || row.problem.severity != map::Severity::Error) return false;
  return std::none_of(safety.begin(), safety.end(), [&](const map::SafetyCondition& condition) {
    return map::problemOf(condition).subject == row.problem.subject;
  });
}

}  // namespace

ProblemsController::ProblemsController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new ProblemsDock(&context.window)) {
  context_.panels.add(dock_, {.side = PanelPlace::Side::Bottom, .tab = 20, .menu_rank = 50, .open = false});
  connect(dock_, &ProblemsDock::retryWanted, this, &ProblemsController::retryWanted);
  connect(dock_, &ProblemsDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  connect(&context_.bar, &WindowStatusBar::problemsWanted, this, [this] { context_.panels.open(dock_); });
}

void ProblemsController::setSession(session::Session* session) {
  dock_->setSession(session);
  if (session) connect(session, &session::Session::problemsChanged, this, &ProblemsController::openOnce);
}

void ProblemsController::recall(const QSettings& settings) {
  if (context_.panels.restored()) shown_once_ = settings.value(kShownKey, false).toBool();
}

void ProblemsController::remember(QSettings& settings) { settings.setValue(kShownKey, shown_once_); }

void ProblemsController::openOnce() {
  // So that nobody overlooks the first error; after that the count in the status bar is enough.
  session::Session* const session = context_.current.session();
  if (shown_once_ || !session) return;
  const auto& rows = session->problems().rows();
  const auto& safety = session->safety().conditions();
  if (std::none_of(rows.begin(), rows.end(),
                   [&](const session::LoggedProblem& row) { return isError(row, safety); })) {
    return;
  }
  shown_once_ = true;
  context_.panels.open(dock_);
}

}  // namespace mapwright::window
