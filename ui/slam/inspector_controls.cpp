#include "ui/slam/inspector_controls.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/icons.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

InspectorControls::InspectorControls(QAction* show_ids, QAction* show_outlines, QWidget* parent)
    : QWidget(parent),
      filter_(new QLineEdit(this)),
      nearby_(addGroup(tr("Nearby"), tr("Show or hide the submaps of nearby maps"))),
      incremental_(addGroup(tr("Incremental"), tr("Show or hide the incremental submaps"))),
      slice_(new QSpinBox(this)),
      colors_(new QComboBox(this)) {
  filter_->setPlaceholderText(tr("Filter: 12-3, v70, frozen, failed…"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  filter_->setToolTip(
      tr("Trajectory and index (12-3), index (592), version (v70), frozen, active, incremental, nearby, "
         "hidden,\nshown, updating, queued, fetching, missing, failed, corrupt. Separate several terms with "
         "spaces: all must match."));
  filter_->setAccessibleName(tr("Filter submaps"));
  colors_->addItem(tr("Normal"));
  colors_->addItem(tr("Incremental"));
  colors_->addItem(tr("Active"));
  colors_->setToolTip(tr("Colours: Incremental tints incremental submaps, Active dims frozen ones"));
  colors_->setAccessibleName(tr("Colours"));
  slice_->setRange(0, 0);
  slice_->setPrefix(tr("Slice "));
  slice_->setAccessibleName(tr("Slice"));

  auto* first = new QHBoxLayout;
  first->setSpacing(4);
  first->addWidget(filter_, 1);
  for (QAction* action : {show_ids, show_outlines}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setIconSize({16, 16});
    button->setFixedSize(26, 24);
    first->addWidget(button);
  }
  auto* second = new QHBoxLayout;
  second->setSpacing(8);
  second->addWidget(colors_, 1);
  second->addWidget(slice_, 1);
  auto* third = new QHBoxLayout;
  third->setSpacing(12);
  third->addWidget(incremental_);
  third->addWidget(nearby_);
  third->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 8);
  column->setSpacing(6);
  column->addLayout(second);
  column->addLayout(third);
  column->addLayout(first);

  connect(filter_, &QLineEdit::textChanged, this, &InspectorControls::filterChanged);
  // clicked and not toggled: only for user actions, and a partially checked box becomes checked.
  connect(nearby_, &QCheckBox::clicked, this,
          [this] { Q_EMIT nearbyWanted(nearby_->checkState() != Qt::Unchecked); });
  connect(incremental_, &QCheckBox::clicked, this,
          [this] { Q_EMIT incrementalWanted(incremental_->checkState() != Qt::Unchecked); });
  connect(slice_, &QSpinBox::valueChanged, this, &InspectorControls::sliceWanted);
  connect(colors_, &QComboBox::currentIndexChanged, this,
          [this](int index) { Q_EMIT colorModeWanted(render::ColorMode(index)); });
  setGroups(Qt::Checked, 0, Qt::Checked, 0);
  setSlices(0, 1);
}

QCheckBox* InspectorControls::addGroup(const QString& name, const QString& tip) {
  auto* box = new QCheckBox(name, this);
  box->setObjectName(name.toLower());
  box->setToolTip(tip);
  return box;
}

QString InspectorControls::filterText() const { return filter_->text(); }

void InspectorControls::setGroups(Qt::CheckState nearby, int nearby_count, Qt::CheckState incremental,
                                  int incremental_count) {
  const auto set = [](QCheckBox* box, const QString& name, Qt::CheckState state, int count) {
    box->setEnabled(count > 0);
    box->setText(count > 0 ? QStringLiteral("%1 (%2)").arg(name, countText(count)) : name);
    box->setTristate(state == Qt::PartiallyChecked);
    box->setCheckState(count > 0 ? state : Qt::Checked);
  };
  set(nearby_, tr("Nearby"), nearby, nearby_count);
  set(incremental_, tr("Incremental"), incremental, incremental_count);
}

void InspectorControls::setSlices(int present, int how_many) {
  const QSignalBlocker quiet(slice_);
  const int last = qMax(qMax(0, how_many - 1), present);
  slice_->setRange(0, last);
  slice_->setValue(present);
  slice_->setEnabled(last > 0);
  slice_->setToolTip(how_many > 1 ? tr("Slice to draw of every submap: 0 to %1").arg(how_many - 1)
                                  : tr("Slice to draw of every submap; these have only one"));
}

void InspectorControls::setColorMode(render::ColorMode mode) {
  const QSignalBlocker quiet(colors_);
  colors_->setCurrentIndex(int(mode));
}

}  // namespace mapwright::window

#include "moc_inspector_controls.cpp"
