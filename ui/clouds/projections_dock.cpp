#include "ui/clouds/projections_dock.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "sentences/plural.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {
namespace {

constexpr int kLeastColumnPx = 26;

QLabel* plainLines(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QPushButton* smallButton(const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QStringLiteral("compact"));
  button->setToolTip(tip);
  return button;
}

/// Metres are typed into a box with limits; the frame into a line.
class NumberDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override {
    if (index.column() == ProjectionsModel::Frame) {
      return QStyledItemDelegate::createEditor(parent, option, index);
    }
    auto* const box = new QDoubleSpinBox(parent);
    box->setFrame(false);
    box->setRange(-1e7, 1e7);
    box->setDecimals(3);
    box->setSingleStep(0.1);
    return box;
  }
};

}  // namespace

ProjectionsDock::ProjectionsDock(const ProjectionDraft* draft, QWidget* parent)
    : QDockWidget(tr("Projections"), parent),
      draft_(draft),
      model_(new ProjectionsModel(draft, this)),
      absence_(plainLines(this)),
      state_(plainLines(this)),
      outcome_(plainLines(this)),
      body_(new QWidget(this)),
      table_(new QTableView(body_)) {
  setObjectName(QStringLiteral("projections"));
  ask_ = smallButton(tr("Reload"), tr("Ask the robot for its current projections"), body_);
  add_ = smallButton(tr("Add"), tr("Add a projection of the visible area"), body_);
  draw_ = smallButton(tr("On the map"), tr("Draw, select and move the rectangles on the map"), body_);
  draw_->setCheckable(true);
  remove_ = smallButton(tr("Remove"), tr("Remove the selected projection from the list (Delete)"), body_);
  revert_ = smallButton(tr("Revert"), tr("Back to the robot's projections"), body_);
  send_ = smallButton(tr("Set on the robot"), {}, body_);

  table_->setModel(model_);
  table_->setItemDelegate(new NumberDelegate(table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAccessibleName(tr("Projections"));
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  // A whole row should be visible: the frame, usually the same, gets the remaining width.
  table_->horizontalHeader()->setMinimumSectionSize(kLeastColumnPx);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(ProjectionsModel::Frame, QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->setMinimumHeight(90);

  auto* const column = new QVBoxLayout(body_);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  auto* const unit = plainLines(body_);
  unit->setText(tr("In metres; X and Y are those of the lower left corner."));
  column->addWidget(unit);
  column->addWidget(table_, 1);
  auto* const edits = new QHBoxLayout;
  for (QPushButton* const button : {add_, draw_, remove_}) edits->addWidget(button);
  edits->addStretch();
  column->addLayout(edits);
  auto* const ends = new QHBoxLayout;
  for (QPushButton* const button : {send_, revert_, ask_}) ends->addWidget(button);
  ends->addStretch();
  column->addLayout(ends);
  column->addWidget(state_);
  column->addWidget(outcome_);
  absence_->setContentsMargins(8, 4, 8, 4);

  auto* const all = new QWidget(this);
  auto* const rows = new QVBoxLayout(all);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(absence_);
  rows->addWidget(body_, 1);
  all->setMinimumWidth(240);
  setWidget(all);

  connect(ask_, &QPushButton::clicked, this, &ProjectionsDock::askWanted);
  connect(add_, &QPushButton::clicked, this, &ProjectionsDock::addWanted);
  connect(draw_, &QPushButton::clicked, this, &ProjectionsDock::drawWanted);
  connect(remove_, &QPushButton::clicked, this, &ProjectionsDock::removeWanted);
  connect(revert_, &QPushButton::clicked, this, &ProjectionsDock::revertWanted);
  connect(send_, &QPushButton::clicked, this, [this] {
    // It is disabled at once, and the focus would move to another dock.
    table_->setFocus();
    Q_EMIT sendWanted();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (!selecting_) Q_EMIT chosen(current.isValid() ? std::optional(current.row()) : std::nullopt);
          });
  setAbsence({});
  setOutcome({}, false);
  refresh();
}

void ProjectionsDock::setAbsence(const QString& sentence) {
  absence_->setText(sentence);
  absence_->setVisible(!sentence.isEmpty());
  body_->setVisible(sentence.isEmpty());
}

void ProjectionsDock::setOffer(const ProjectionsOffer& offer) {
  offer_ = offer;
  refresh();
}

void ProjectionsDock::setBusy(bool busy) {
  busy_ = busy;
  refresh();
}

void ProjectionsDock::setOutcome(const QString& sentence, bool bad) {
  outcome_->setText(sentence);
  outcome_->setVisible(!sentence.isEmpty());
  QPalette palette = outcome_->palette();
  palette.setColor(QPalette::WindowText, bad ? appColors().error_text : appColors().secondary_text);
  outcome_->setPalette(palette);
}

void ProjectionsDock::setDrawing(bool drawing) { draw_->setChecked(drawing); }

void ProjectionsDock::refresh() {
  const bool editable = offer_.changes && !busy_;
  model_->setEditable(editable);
  {
    const QScopedValueRollback selecting(selecting_, true);
    model_->refresh();
    const int row = draft_->selected().value_or(-1);
    if (table_->currentIndex().row() != row) {
      const int column = std::max(0, table_->currentIndex().column());
      table_->setCurrentIndex(row < 0 ? QModelIndex() : model_->index(row, column));
      if (row < 0) table_->clearSelection();
    }
  }
  const std::optional<int> flawed = draft_->firstFlawed();
  add_->setEnabled(editable);
  draw_->setEnabled(offer_.changes || !draft_->wanted().empty());
  remove_->setEnabled(editable && draft_->selected());
  revert_->setEnabled(editable && draft_->told() && draft_->changed());
  ask_->setEnabled(offer_.online && offer_.reads && !busy_);
  send_->setEnabled(editable && offer_.online && draft_->changed() && !flawed);
  send_->setToolTip(!offer_.changes  ? tr("Projections cannot be set on this robot.")
                    : !offer_.online ? tr("The robot is not connected.")
                    : flawed         ? flawText(map::flawOf(draft_->wanted()[std::size_t(*flawed)]))
                                     : tr("Send the whole list; the robot's answer is shown afterwards"));
  QString state;
  if (busy_) {
    state = tr("Waiting for the robot…");
  } else if (!draft_->told() && !draft_->changed()) {
    state = offer_.reads ? tr("The robot has not reported its projections yet.")
                         : tr("This robot does not report its projections.");
  } else if (flawed) {
    state = tr("Projection %1 cannot be sent. %2")
                .arg(QString::number(*flawed), flawText(map::flawOf(draft_->wanted()[std::size_t(*flawed)])));
  } else if (draft_->changed()) {
    state = tr("Edited here, not set on the robot yet.");
  } else if (draft_->wanted().empty()) {
    state = tr("The robot has no projections.");
  } else {
    const auto count = qint64(draft_->wanted().size());
    state = sentences::counted(tr("The robot has %1 projections.", nullptr, sentences::formOf(count)), count);
  }
  if (!offer_.changes && offer_.reads) {
    state += QLatin1Char(' ') + tr("They are read-only here: the robot offers no service to set them.");
  }
  state_->setText(state);
}

}  // namespace mapwright::window

#include "moc_projections_dock.cpp"
