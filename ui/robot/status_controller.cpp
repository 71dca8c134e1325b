#include "ui/robot/status_controller.h"

#include "session/session.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/on_screen.h"
#include "ui/view/replay_state.h"

namespace mapwright::ui {

StatusController::StatusController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  connect(&context_.current, &CurrentSession::stateChanged, this, &StatusController::refresh);
  connect(&context_.unsaved, &UnsavedChanges::changed, this, &StatusController::refreshTitle);
}

void StatusController::setSession(session::Session* session) { context_.bar.setSession(session); }

void StatusController::refresh() {
  session::Session* const session = context_.current.session();
  const MapsInView in_view = mapsInView(context_.scene);
  auto state = emptyState(session, in_view);
  // Data that a bag does not contain by this time is not on its way: the rest is shown.
  const bool waits =
      state && (state->kind == EmptyState::Kind::WaitingForList || hasToldNoMap(session, in_view));
  if (waits && replayOf(session) && session->connection().phase == robot::ConnectionPhase::Online)
    state.reset();
  context_.overlay.card()->setState(state);
  const bool submaps_left_out = context_.scene.robotPlace().drawn == scene::ScreenPart::None;
  context_.bar.setInView(in_view.submaps && !submaps_left_out, in_view.whole,
                         submapsOf(session, context_.scene));
  refreshTitle();
}

void StatusController::refreshTitle() {
  const QString title = windowTitle(context_.current.session(), context_.scene, context_.current.called());
  context_.window.setWindowTitle(context_.unsaved.any() ? QStringLiteral("• %1").arg(title) : title);
}

}  // namespace mapwright::ui

#include "moc_status_controller.cpp"
