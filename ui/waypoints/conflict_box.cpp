#include "ui/waypoints/conflict_box.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {

ConflictBox::ConflictBox(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      mine_(new QPushButton(tr("Keep mine"), this)),
      theirs_(new QPushButton(tr("Take theirs"), this)),
      previous_(new QPushButton(QString(QChar(0x2039)), this)),
      next_(new QPushButton(QString(QChar(0x203a)), this)),
      locate_(new QPushButton(tr("Show"), this)) {
  setObjectName(QStringLiteral("details"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  mine_->setToolTip(tr("Keep the change made here: the filled triangle on the map"));
  theirs_->setToolTip(tr("Keep the change made elsewhere: the hollow triangle on the map"));
  previous_->setAccessibleName(tr("Previous conflict"));
  next_->setAccessibleName(tr("Next conflict"));
  previous_->setToolTip(previous_->accessibleName());
  next_->setToolTip(next_->accessibleName());
  locate_->setToolTip(tr("Show both on the map"));
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  for (QPushButton* button : {mine_, theirs_, locate_}) {
    button->setObjectName(QStringLiteral("compact"));
    row->addWidget(button);
  }
  row->addStretch();
  for (QPushButton* button : {previous_, next_}) {
    button->setObjectName(QStringLiteral("compact"));
    button->setMaximumWidth(28);
    row->addWidget(button);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  column->setSpacing(4);
  column->addWidget(text_);
  column->addLayout(row);
  connect(mine_, &QPushButton::clicked, this, [this] { Q_EMIT decided(current_, true); });
  connect(theirs_, &QPushButton::clicked, this, [this] { Q_EMIT decided(current_, false); });
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
  if (selected != selected_) {
    selected_ = selected;
    for (const edit::Key& key : selected) {
      if (document && document->conflicts().contains(key)) current_ = key;
    }
  }
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
  previous_->setVisible(count > 1);
  next_->setVisible(count > 1);
}

QString ConflictBox::shown() const { return isHidden() ? QString() : text_->text(); }

}  // namespace mapwright::window

#include "moc_conflict_box.cpp"
