#include "ui/maps/mapping_dock.h"

#include <cmath>

#include <QAction>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/kit/wrapping_row.h"
#include "ui/view/notice_bar.h"

namespace mapwright::ui {

namespace {

/// Does what the action does, with its text, its reason and whether it is possible.
QPushButton* buttonOf(QAction* action, QWidget* parent) {
  QPushButton* const button = compactButton(action->text(), parent);
  const auto follow = [button, action] {
    button->setText(action->text());
    button->setEnabled(action->isEnabled());
    button->setVisible(action->isVisible());
    button->setToolTip(action->toolTip());
  };
  QObject::connect(action, &QAction::changed, button, follow);
  QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
  follow();
  return button;
}

QString heading(const MappingState& state) {
  switch (state.phase) {
    case MappingState::Phase::None:
      return MappingDock::tr("The robot is not mapping.");
    case MappingState::Phase::Unknown:
      return MappingDock::tr("The robot has not said whether it is mapping.");
    case MappingState::Phase::Away:
      return MappingDock::tr("The robot was mapping when the connection was lost.");
    case MappingState::Phase::Running:
      break;
  }
  return state.extends.isEmpty() ? MappingDock::tr("The robot is mapping.")
                                 : MappingDock::tr("The robot is mapping more of %1.").arg(state.extends);
}

}  // namespace

MappingDock::MappingDock(const QList<QAction*>& actions, QWidget* parent)
    : QDockWidget(tr("Mapping"), parent),
      said_(wrappedLabel({}, this)),
      trouble_(wrappedLabel({}, this)),
      unconfirmed_(wrappedLabel({}, this)),
      lasts_(new PlainLabel(this)),
      submaps_(new PlainLabel(this)),
      size_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("mapping"));
  auto* const body = new QWidget(this);
  auto* const form = new QFormLayout;
  form->addRow(tr("Duration"), lasts_);
  form->addRow(tr("Submaps"), submaps_);
  form->addRow(tr("Size"), size_);
  auto* const buttons = new WrappingRow(QMargins());
  for (QAction* const action : actions) buttons->add(buttonOf(action, body));
  body->setLayout(
      columnOf({said_, form, trouble_, buttons, unconfirmed_, LayoutItem::rest()}, 8, QMargins(8, 6, 8, 6)));
  setScrolledWidget(*this, body);
  setTextColor(*trouble_, appColors().warning_text);
  setTextColor(*unconfirmed_, appColors().secondary_text);
  unconfirmed_->setVisible(false);
  state_.phase = MappingState::Phase::Unknown;
  setState({});
}

void MappingDock::setState(const MappingState& state) {
  if (state == state_) return;
  state_ = state;
  const QString none = QStringLiteral("–");
  const bool shown = state.phase == MappingState::Phase::Running || state.phase == MappingState::Phase::Away;
  said_->setText(state.manager.isEmpty()
                     ? heading(state)
                     : heading(state) + QLatin1Char(' ') + tr("Its map manager is %1.").arg(state.manager));
  lasts_->setText(!shown          ? none
                  : state.lasts_s ? lengthText(qint64(*state.lasts_s))
                                  : tr("at least %1").arg(lengthText(qint64(state.seen_s))));
  submaps_->setText(shown && state.submaps > 0 ? countText(state.submaps) : none);
  size_->setText(shown && state.width_m > 0
                     ? tr("%1 × %2 m").arg(state.width_m, 0, 'f', 1).arg(state.height_m, 0, 'f', 1)
                     : none);
  trouble_->setText(state.trouble);
  trouble_->setVisible(!state.trouble.isEmpty());
}

void MappingDock::setUnconfirmed(const QString& remark) {
  unconfirmed_->setText(remark);
  unconfirmed_->setVisible(!remark.isEmpty());
}

QString MappingDock::said() const {
  return QStringList{said_->text(), lasts_->text(), submaps_->text(), size_->text(), trouble_->text()}.join(
      QLatin1Char('|'));
}

}  // namespace mapwright::ui

#include "moc_mapping_dock.cpp"
