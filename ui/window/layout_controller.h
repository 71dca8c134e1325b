// Which of its layouts the window has: one for each role, remembered separately, one click apart.
#pragma once

#include <map>

#include <QByteArray>
#include <QPointer>
#include <QWidget>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"
#include "ui/window/layouts.h"

class QAction;

namespace mapwright::ui {

class LayoutController : public Controller {
  Q_OBJECT
 public:
  explicit LayoutController(WindowContext& context, QObject* parent = nullptr);

  Role role() const { return role_; }
  /// The user's choice, which stands from then on.
  void choose(Role role);

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  /// While the window is used.
  void save(QSettings& settings);
  void reset() override;

 Q_SIGNALS:
  /// The present one is left: what does not belong to it goes now.
  void leaving();
  void shown(Role role);

 private:
  void show(Role role);
  /// Where it was before another layout was shown, if that is still to be seen; otherwise on the map.
  void keepFocus();
  void standBackSoon();
  void store(QSettings& settings);
  /// As long as the user has not chosen: by what was opened.
  void pick(session::Session& session);
  void offerReplay();
  static QString offer();
  Layout fresh() const;

  WindowContext& context_;
  std::map<Role, QAction*> actions_;
  std::map<Role, QByteArray> states_;  // of the panels, as they were left
  Role role_ = Role::Inspect;
  QPointer<QWidget> had_focus_;
  bool chosen_ = false;   // by the user, at any time
  bool opened_ = false;   // something that was there, since the start
  bool offered_ = false;  // the layout of replays
};

}  // namespace mapwright::ui
