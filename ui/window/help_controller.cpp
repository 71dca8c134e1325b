#include "ui/window/help_controller.h"

#include <QDateTime>
#include <QDialog>

#include "robot/address.h"
#include "robot/robot.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/status_text.h"
#include "ui/robot/recent_robots.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/window/command_palette.h"
#include "ui/window/diagnostics_dialog.h"
#include "ui/window/manual_window.h"
#include "ui/window/shortcut_sheet.h"
#include "ui/window/support_text.h"
#include "ui/window/watched_application.h"
#include "words/listed.h"

namespace mapwright::ui {

HelpController::HelpController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  QWidget* const window = &context.window;
  Actions& actions = context.actions;
  actions.add({.id = "manual",
               .text = tr("&Manual"),
               .icon = "info",
               .keys = {"F1"},
               .tip = tr("How to do it: tasks, keys and commands, with a search"),
               .menu = {MenuGroup::Finding, 5}},
              this, &HelpController::showManual);
  actions.add({.id = "palette",
               .text = tr("&Find anything…"),
               .icon = "palette",
               .keys = {"Ctrl+K"},
               .tip = tr("Search commands, objects, submaps, maps, layers and topics by name"),
               .menu = {MenuGroup::Finding, 10},
               .bar = {BarGroup::FarEnd, 10}},
              window, [&actions, &findings = context.findings, window] {
                auto* const palette = new CommandPalette(actions, findings, window);
                palette->setAttribute(Qt::WA_DeleteOnClose);
                palette->open();
              });
  actions.add({.id = "shortcuts",
               .text = tr("&Keys and gestures"),
               .icon = "keyboard",
               .keys = {"?"},
               .reach = Reach::OutsideText,
               .tip = tr("All keyboard shortcuts and gestures on one page"),
               .menu = {MenuGroup::Finding, 20}},
              window, [&actions, window] { makeShortcutSheet(actions, window)->open(); });
  actions.add({.id = "diagnostics",
               .text = tr("&Diagnostics"),
               .icon = "settings",
               .tip = tr("Threads, memory and messages: usage, limits and rates"),
               .menu = {MenuGroup::About, 5}},
              this, &HelpController::showDiagnostics);
  actions.add(
      {.id = "copyDiagnostics",
       .text = tr("&Copy diagnostics"),
       .icon = "copy",
       .tip = words::paragraph(
           {tr("Versions, system, numbers and problems as a text, for people who help."), leftOutSentence()}),
       .menu = {MenuGroup::About, 7}},
      this, &HelpController::copyDiagnostics);
  actions.add({.id = "about",
               .text = tr("&About mapwright"),
               .icon = "info",
               .tip = tr("Version and licences"),
               .menu = {MenuGroup::About, 10}},
              window, [window] { makeAboutBox(window)->open(); });
}

HelpController::~HelpController() { delete diagnostics_; }

Diagnostics HelpController::look() const {
  const work::Workers& workers = *context_.workers;
  Diagnostics now{workers.threads(), workers.running(), workers.waiting(), context_.scene.memory(),
                  context_.budgets};
  if (session::Session* const session = context_.current.session()) {
    now.held = now.held + session->memory();
    if (const robot::OffersTopics* const of = robot::topicsOfferedBy(session->robot()))
      now.reception = of->reception();
  }
  if (const Stalls* const stalls = WatchedApplication::stalls()) now.stalls = *stalls;
  return now;
}

void HelpController::copyDiagnostics() {
  Support support{textOf(look())};
  Privacy privacy = privacyHere();
  const session::Session* const session = context_.current.session();
  const auto namesOf = [&](const QString& address, const QStringList& more) {
    const auto parsed = context_.addresses.parse(address);
    QStringList names = more;
    if (parsed) names << parsed->url.host() << robot::hostOf(*parsed);
    return names;
  };
  if (session) {
    const robot::Robot& robot = session->robot();
    const robot::RobotIdentity identity = robot.identity();
    const robot::ConnectionState connection = session->connection();
    // A file is called by its own name, which is no robot's.
    const auto parsed = context_.addresses.parse(robot.address());
    if (!parsed || !parsed->url.host().isEmpty())
      privacy.robots << namesOf(robot.address(), {identity.name, identity.serial});
    support.robot << tr("Open: %1, %2").arg(robot.address(), connectionWord(connection.phase));
    if (connection.reason.any()) support.robot << sentences::wordsOf(connection.reason);
    if (!identity.model.isEmpty() && !identity.version.isEmpty())
      support.robot << tr("Model: %1, version %2").arg(identity.model, identity.version);
    else if (!identity.model.isEmpty())
      support.robot << tr("Model: %1").arg(identity.model);
    support.problems =
        session->problems().toText(QDateTime::currentDateTime()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  }
  for (const RecentRobot& recent : RecentRobots(context_.settings, context_.addresses).list())
    privacy.robots << namesOf(recent.address, {recent.name, recent.look.called});
  copyText(context_.overlay, supportText(support, systemLines(), privacy), tr("Diagnostics copied"));
}

void HelpController::showDiagnostics() {
  // Non-modal, so that it can be watched while working.
  if (!diagnostics_) {
    diagnostics_ = new DiagnosticsDialog([this] { return look(); }, context_.settings, &context_.window);
    diagnostics_->setAttribute(Qt::WA_DeleteOnClose);
    connect(diagnostics_, &DiagnosticsDialog::copyWanted, this, &HelpController::copyDiagnostics);
  }
  diagnostics_->show();
  diagnostics_->raise();
  diagnostics_->activateWindow();
}

void HelpController::showManual() {
  if (!manual_) manual_ = new ManualWindow(&context_.window);
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

}  // namespace mapwright::ui

#include "moc_help_controller.cpp"
