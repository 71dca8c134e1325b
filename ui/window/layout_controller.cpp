#include "ui/window/layout_controller.h"

#include <utility>

#include <QActionGroup>
#include <QScreen>

#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/panels.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/replay_state.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

namespace {

const QString kRoleKey = QStringLiteral("layout/role");
// Of earlier versions, which had one layout for everything.
const QString kOldStateKey = QStringLiteral("window/state");

QString stateKey(Role role) { return QStringLiteral("layout/") + idOf(role); }

}  // namespace

LayoutController::LayoutController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  const auto add = [&](Role role, ActionSpec spec) {
    spec.toggle = true;
    actions_[role] = context.actions.add(spec, this, [this, role] { choose(role); });
  };
  add(Role::Operate, {.id = "layoutOperate",
                      .text = tr("&Operate"),
                      .keys = {"Ctrl+1"},
                      .tip = tr("Layout for waypoints and the robot"),
                      .menu = {MenuGroup::Layouts, 10},
                      .bar = {BarGroup::Layouts, 10}});
  add(Role::Inspect, {.id = "layoutInspect",
                      .text = tr("&Inspect"),
                      .keys = {"Ctrl+2"},
                      .tip = tr("Layout for submaps, layers and problems"),
                      .menu = {MenuGroup::Layouts, 20},
                      .bar = {BarGroup::Layouts, 20}});
  add(Role::Replay, {.id = "layoutReplay",
                     .text = tr("&Replay"),
                     .keys = {"Ctrl+3"},
                     .tip = tr("Layout for recordings: timeline, events, messages and plots"),
                     .menu = {MenuGroup::Layouts, 30},
                     .bar = {BarGroup::Layouts, 30}});
  auto* const group = new QActionGroup(this);
  for (const auto& [role, action] : actions_) group->addAction(action);
  // Only then it is known which panels are in front.
  connect(&context_.panels, &Panels::arranged, this, &LayoutController::keepFocus);
  connect(&context_.panels, &Panels::arranged, &context_.panels, &Panels::standBack);
}

Layout LayoutController::fresh() const {
  const QMainWindow& window = context_.window;
  // Its size is only known later if it fills the screen.
  const bool fills = window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen);
  return layoutFor(role_, fills && window.screen() ? window.screen()->availableSize() : window.size());
}

void LayoutController::choose(Role role) {
  chosen_ = true;
  show(role);
}

void LayoutController::show(Role role) {
  if (role == role_) return;
  had_focus_ = context_.window.focusWidget();
  Q_EMIT leaving();
  states_[role_] = context_.panels.state();
  role_ = role;
  if (role == Role::Replay) context_.overlay.toasts()->withdraw(offer());
  actions_[role]->setChecked(true);
  const bool restored = context_.panels.restore(states_[role], fresh());
  if (!restored) context_.panels.arrange(fresh());
  if (restored) keepFocus();
  if (restored) standBackSoon();
  Q_EMIT shown(role);
}

void LayoutController::standBackSoon() {
  // Only then it is known which panels are in front.
  QMetaObject::invokeMethod(&context_.panels, &Panels::standBack, Qt::QueuedConnection);
}

void LayoutController::keepFocus() {
  if (!had_focus_) return;
  // Whatever takes it from a panel that goes is in nobody's mind: keys would be typed there.
  QWidget* const had = std::exchange(had_focus_, nullptr);
  const bool there = had->isVisible() && !had->visibleRegion().isEmpty();
  (there ? had : &context_.view)->setFocus();
}

void LayoutController::setSession(session::Session* session) {
  if (!replayOf(session)) context_.overlay.toasts()->withdraw(offer());
  if (!session) return;
  standBackSoon();
  connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, [this] {
    // No panel is taken away from whoever is working there.
    if (context_.window.focusWidget() == &context_.view) standBackSoon();
  });
  if (!chosen_ && !opened_) {
    const auto markOpened = [this, session] {
      opened_ = opened_ || session->connection().phase == robot::ConnectionPhase::Online;
    };
    connect(session, &session::Session::connectionChanged, this, markOpened);
    markOpened();
    // Robots tell what they can do once they are connected.
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, [this, session] {
      // No panel is taken away from whoever is working there.
      const bool elsewhere = context_.window.focusWidget() != &context_.view;
      if (!chosen_ && !elsewhere && !context_.viewpoint.chosen()) pick(*session);
    });
    return pick(*session);
  }
  if (replayOf(session) && role_ != Role::Replay && !std::exchange(offered_, true)) offerReplay();
}

void LayoutController::pick(session::Session& session) {
  if (replayOf(&session)) return show(Role::Replay);
  const bool waypoints = session.robot().waypointStore() || session.robot().waypointSource();
  show(waypoints ? Role::Operate : Role::Inspect);
}

QString LayoutController::offer() {
  return tr("The layout Replay has the timeline, events, messages and plots side by side.");
}

void LayoutController::offerReplay() {
  context_.overlay.toasts()->add(Mark::Neutral, offer(), {tr("Use it"), [this] { choose(Role::Replay); }});
}

void LayoutController::recall(const QSettings& settings) {
  const QString remembered = settings.value(kRoleKey).toString();
  for (const Role role : kRoles) {
    states_[role] = settings.value(stateKey(role)).toByteArray();
    if (remembered != idOf(role)) continue;
    role_ = role;
    chosen_ = true;
  }
  actions_[role_]->setChecked(true);
  context_.panels.arrange(fresh());
  context_.panels.restore(states_[role_], fresh());
  Q_EMIT shown(role_);
}

void LayoutController::remember(QSettings& settings) {
  Q_EMIT leaving();
  states_[role_] = context_.panels.state();
  store(settings);
}

void LayoutController::save(QSettings& settings) {
  // What belongs to a replay is taken away when that ends, and not while it is looked at.
  if (!replayOf(context_.current.session())) states_[role_] = context_.panels.state();
  store(settings);
}

void LayoutController::store(QSettings& settings) {
  for (const auto& [role, state] : states_) settings.setValue(stateKey(role), state);
  if (chosen_) settings.setValue(kRoleKey, idOf(role_));
  settings.remove(kOldStateKey);
}

void LayoutController::reset() { context_.panels.arrange(fresh()); }

}  // namespace mapwright::ui

#include "moc_layout_controller.cpp"
