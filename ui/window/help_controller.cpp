#include "ui/window/help_controller.h"

#include <QDialog>

#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/window/command_palette.h"
#include "ui/window/diagnostics_dialog.h"
#include "ui/window/manual_window.h"
#include "ui/window/shortcut_sheet.h"

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
  actions.add({.id = "about",
               .text = tr("&About mapwright"),
               .icon = "info",
               .tip = tr("Version and licences"),
               .menu = {MenuGroup::About, 10}},
              window, [window] { makeAboutBox(window)->open(); });
}

HelpController::~HelpController() { delete diagnostics_; }

void HelpController::showDiagnostics() {
  // Non-modal, so that it can be watched while working.
  if (!diagnostics_) {
    const auto look = [&context = context_] {
      Diagnostics now{context.workers->threads(), context.workers->running(), context.workers->waiting(),
                      context.scene.memory(), context.budgets};
      if (session::Session* const session = context.current.session()) {
        now.held = now.held + session->memory();
        if (const robot::OffersTopics* const of = robot::topicsOfferedBy(session->robot()))
          now.reception = of->reception();
      }
      return now;
    };
    diagnostics_ = new DiagnosticsDialog(look, context_.settings, &context_.window);
    diagnostics_->setAttribute(Qt::WA_DeleteOnClose);
    connect(diagnostics_, &DiagnosticsDialog::copyWanted, this,
            [this](const QString& text) { copyText(context_.overlay, text, tr("Diagnostics copied")); });
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
