#include "ui/waypoints/waypoint_conflicts.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "placing/arrange.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/wrapping_row.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::ui {
namespace {

class ConflictText {
  Q_DECLARE_TR_FUNCTIONS(WaypointConflict)
};

}  // namespace

std::optional<edit::Key> conflictAt(const edit::WaypointDocument& document, const Eigen::Vector2d& world_m,
                                    double reach_m) {
  std::optional<edit::Key> nearest;
  for (const auto& [key, conflict] : document.conflicts()) {
    const map::Waypoint* const here = document.find(key);
    for (const map::Waypoint* side : {here, conflict.theirs ? &*conflict.theirs : nullptr}) {
      if (!side) continue;
      const double distance = (side->position_m - world_m).norm();
      if (!(distance <= reach_m)) continue;
      reach_m = distance;
      nearest = key;
    }
  }
  return nearest;
}

void fillConflictMenu(QMenu& menu, const edit::WaypointDocument& document, const edit::Key& key,
                      const std::function<void(ConflictChoice)>& decided) {
  const auto found = document.conflicts().find(key);
  if (found == document.conflicts().end()) return;
  const edit::Conflict& conflict = found->second;
  const auto& any = conflict.mine ? conflict.mine : conflict.theirs;
  // Untrusted names: an ampersand in them is not a mnemonic.
  const QString which =
      any ? shortWaypointName(*any).replace(QLatin1Char('&'), QLatin1String("&&")) : QString();
  menu.addAction(themedIcon(QStringLiteral("problem")),
                 ConflictText::tr("%1 was changed here and elsewhere").arg(which))
      ->setEnabled(false);
  const auto add = [&](const QString& text, const char* name, ConflictChoice choice) {
    QAction* const action = menu.addAction(text, &menu, [decided, choice] { decided(choice); });
    action->setObjectName(QLatin1String(name));
  };
  add(conflict.mine ? ConflictText::tr("Keep &mine") : ConflictText::tr("&Delete it, as I did"),
      "conflictMine", ConflictChoice::Mine);
  add(conflict.theirs ? ConflictText::tr("Take &theirs") : ConflictText::tr("Delete it, as &they did"),
      "conflictTheirs", ConflictChoice::Theirs);
  if (conflict.mine && conflict.theirs)
    add(ConflictText::tr("Keep &both"), "conflictBoth", ConflictChoice::Both);
}

void decideConflict(WaypointEditing& editing, const edit::Key& key, ConflictChoice choice) {
  edit::WaypointDocument* const document = editing.document();
  if (!document || !editing.editable() || !document->conflicts().contains(key)) return;
  if (choice == ConflictChoice::Mine)
    return document->decide(key, edit::Side::Mine, ConflictText::tr("keep mine"));
  // Impossible if one of them is deleted.
  const map::Waypoint* const here = document->find(key);
  const bool both = choice == ConflictChoice::Both && here && document->conflicts().at(key).theirs;
  std::optional<map::Waypoint> mine = both ? std::optional(*here) : std::nullopt;
  document->decide(key, edit::Side::Theirs, ConflictText::tr("take theirs"));
  if (!mine) return;
  std::set<std::string> taken = editing.names();
  mine->source.clear();  // that is theirs
  if (taken.contains(mine->name)) mine->name = placing::nextName(mine->name, taken);
  editing.addAll({std::move(*mine)}, ConflictText::tr("keep %1 as well"));
}

ConflictBox::ConflictBox(QWidget* parent)
    : QFrame(parent),
      text_(wrappedLabel({}, this)),
      mine_(compactButton(tr("Keep mine"), this,
                          tr("Keep the change made here: the filled triangle on the map"))),
      theirs_(compactButton(tr("Take theirs"), this,
                            tr("Keep the change made elsewhere: the hollow triangle on the map"))),
      both_(compactButton(tr("Keep both"), this,
                          tr("Keep theirs, and mine as a second waypoint with its own name"))),
      locate_(compactButton(tr("Show"), this, tr("Show both on the map"))),
      previous_(compactButton(QString(QChar(0x2039)), this, tr("Previous conflict"))),
      next_(compactButton(QString(QChar(0x203a)), this, tr("Next conflict"))) {
  setObjectName(QStringLiteral("details"));
  for (QPushButton* button : {previous_, next_}) {
    button->setAccessibleName(button->toolTip());
    button->setMaximumWidth(28);
  }
  auto* const choices = new WrappingRow(QMargins());
  for (QPushButton* const button : {mine_, theirs_, both_, locate_, previous_, next_}) choices->add(button);
  setLayout(columnOf({text_, choices}, 4, QMargins(8, 6, 8, 6)));
  const auto decides = [this](QPushButton* button, ConflictChoice choice) {
    connect(button, &QPushButton::clicked, this, [this, choice] { Q_EMIT decided(current_, choice); });
  };
  decides(mine_, ConflictChoice::Mine);
  decides(theirs_, ConflictChoice::Theirs);
  decides(both_, ConflictChoice::Both);
  connect(locate_, &QPushButton::clicked, this, [this] { Q_EMIT locateWanted(current_); });
  connect(previous_, &QPushButton::clicked, this, [this] { step(-1); });
  connect(next_, &QPushButton::clicked, this, [this] { step(1); });
  hide();
}

void ConflictBox::refresh(const edit::WaypointDocument* document, const std::set<edit::Key>& selected) {
  document_ = document;
  keys_.clear();
  if (document) {
    for (const auto& [key, conflict] : document->conflicts()) keys_.push_back(key);
  }
  // Whatever came first, the selection or the conflict.
  const auto chosen =
      std::find_if(keys_.begin(), keys_.end(), [&](const edit::Key& key) { return selected.contains(key); });
  if (chosen != keys_.end() && !(selected.contains(current_) && document->conflicts().contains(current_)))
    current_ = *chosen;
  // When one is decided the next one comes.
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), current_);
  current_ = at != keys_.end() ? *at : keys_.empty() ? edit::Key() : keys_.front();
  setVisible(!keys_.empty());
  if (!keys_.empty()) show(*document);
}

void ConflictBox::step(int by) {
  if (keys_.empty() || !document_) return;
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), current_) - keys_.begin();
  const auto count = std::ptrdiff_t(keys_.size());
  current_ = keys_[std::size_t((at + by + count) % count)];
  show(*document_);
  Q_EMIT locateWanted(current_);
}

void ConflictBox::show(const edit::WaypointDocument& document) {
  const auto& conflict = document.conflicts().at(current_);
  const auto& any = conflict.mine ? conflict.mine : conflict.theirs ? conflict.theirs : conflict.base;
  const QString which = any ? shortWaypointName(*any) : QString();
  const auto count = qsizetype(keys_.size());
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), current_) - keys_.begin() + 1;
  QString text = count == 1 ? tr("%1 was changed here and elsewhere.").arg(which)
                            : tr("%1 was changed here and elsewhere (%2 of %3).")
                                  .arg(which, QString::number(at), QString::number(count));
  text_->setText(text + QLatin1Char('\n') + conflictText(conflict));
  both_->setVisible(conflict.mine && conflict.theirs);
  previous_->setVisible(count > 1);
  next_->setVisible(count > 1);
}

QString ConflictBox::shown() const { return isHidden() ? QString() : text_->text(); }

}  // namespace mapwright::ui

#include "moc_waypoint_conflicts.cpp"
